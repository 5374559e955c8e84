#include "model/option_reader.h"

#include "model/cards/lists.h"

#include <array>

namespace drawbead {

namespace {

/// Layouts below 51 carry the title at the end of the header line; decks written for them by newer tools do
/// not.
bool title_on_header(const Deck& deck, const Block& block) {
    if (deck.scope(block.scope).layout >= 51) return false;
    std::string_view text = trim(deck.text(block.header));
    const std::size_t slash = text.rfind('/');
    if (slash == std::string_view::npos || slash == 0) return false;
    text = trim(text.substr(slash + 1));
    return !text.empty() && text.find_first_not_of("0123456789 ") != std::string_view::npos &&
           block.keyword.find(text) == std::string_view::npos;
}

} // namespace

OptionReader::OptionReader(const Deck& deck, BlockIndex index, IssueLog& issues, bool titled)
    : deck_(deck), block_(deck.blocks()[index]), issues_(issues), lines_(deck, block_) {
    if (titled && !title_on_header(deck, block_)) has_title_line_ = lines_.next(title_line_);
}

std::string OptionReader::title() const {
    if (!has_title_line_) return {};
    return std::string(trim(deck_.text(title_line_).substr(0, 100)));
}

Card OptionReader::card(const CardSchema& schema) {
    Span line;
    if (!lines_.next(line)) return missing_card(deck_, block_.scope, schema);
    Card card = read_card(deck_, block_.scope, line, schema);
    issues_.check(card);
    return card;
}

double OptionReader::factor(Dimension dimension) {
    const std::optional<double> factor = deck_.factor(block_.scope, block_.unit, dimension);
    if (factor) return *factor;
    if (unit_known_)
        issues_.add(ReadIssue::Kind::unknown_unit, block_.header, std::to_string(block_.unit),
                    std::string(block_.keyword) + ' ' + std::to_string(block_.id));
    unit_known_ = false;
    return 1;
}

double OptionReader::real(const Card& card, std::string_view name) {
    const Cell& cell = card[name];
    if (!cell.given()) return 0;
    for (std::size_t i = 0; i < card.cells.size(); ++i)
        if (&card.cells[i] == &cell) return cell.real * factor(card.schema->fields[i].dimension);
    return cell.real;
}

namespace {

using TenIds = std::array<WrittenId, 10>;

/// Plain cells only: blanks, an optional minus sign, digits, blanks. False when the line needs the exact
/// path.
bool read_plain_line(std::string_view text, const Span& line, std::size_t width, TenIds& ids,
                     std::size_t& count) {
    if (text.size() > 10 * width) text = text.substr(0, 10 * width);
    count = 0;
    for (std::size_t begin = 0; begin < text.size(); begin += width) {
        const std::size_t end = begin + width < text.size() ? begin + width : text.size();
        std::size_t at = begin;
        while (at < end && text[at] == ' ')
            ++at;
        if (at == end) continue;
        const std::size_t first = at;
        const bool negative = text[at] == '-';
        if (negative) ++at;
        const std::size_t digits = at;
        int64_t id = 0;
        while (at < end && text[at] >= '0' && text[at] <= '9')
            id = 10 * id + (text[at++] - '0');
        if (at == digits || id > 2147483647) return false;
        const std::size_t last = at;
        while (at < end && text[at] == ' ')
            ++at;
        if (at != end) return false;
        ids[count++] = {negative ? -id : id, {line.file, line.begin + first, line.begin + last}};
    }
    return true;
}

} // namespace

void for_each_id(const Deck& deck, ScopeId scope, const Span& text, IssueLog& issues,
                 const std::function<void(const WrittenId*, std::size_t count)>& take) {
    const bool narrow = deck.scope(scope).layout < 45;
    DataLines lines(deck, text);
    Span line;
    TenIds ids;
    std::size_t count = 0;
    while (lines.next_filled(line)) {
        if (!read_plain_line(lines.text(line), line, narrow ? 8 : 10, ids, count)) {
            const Card card = read_card(deck, scope, line, narrow ? narrow_id_list_card : id_list_card);
            issues.check(card);
            count = 0;
            for (const Cell& cell : card.cells)
                if (cell.given() && count < ids.size()) ids[count++] = {cell.integer, cell.place};
        }
        if (count) take(ids.data(), count);
    }
}

bool read_plain_cells(std::string_view text, std::size_t width, std::size_t count, int64_t* values) {
    if (text.find(',') != std::string_view::npos) return false;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t begin = i * width;
        const std::size_t end = begin + width < text.size() ? begin + width : text.size();
        std::size_t at = begin;
        values[i] = 0;
        while (at < end && text[at] == ' ')
            ++at;
        if (at >= end) continue;
        const bool negative = text[at] == '-';
        if (negative) ++at;
        const std::size_t digits = at;
        int64_t value = 0;
        while (at < end && text[at] >= '0' && text[at] <= '9')
            value = 10 * value + (text[at++] - '0');
        if (at == digits || value > 2147483647) return false;
        while (at < end && text[at] == ' ')
            ++at;
        if (at != end) return false;
        values[i] = negative ? -value : value;
    }
    return true;
}

std::vector<Span> line_pieces(const Deck& deck, const Span& text) {
    constexpr uint64_t piece = uint64_t{1} << 21;
    std::vector<Span> pieces;
    const SourceFile& file = deck.file(text.file);
    uint64_t begin = text.begin;
    while (begin < text.end) {
        uint64_t end = begin + piece;
        while (end < text.end) {
            const uint64_t line = file.line_begin(end);
            end = file.next_line(end);
            if (end >= text.end || (file.bytes()[line] != '#' && file.bytes()[line] != '+')) break;
        }
        end = std::min(end, text.end);
        pieces.push_back({text.file, begin, end});
        begin = end;
    }
    return pieces;
}

Span list_text(const Deck& deck, const Block& block) {
    DataLines lines(deck, block);
    Span title;
    if (title_on_header(deck, block)) return block.text;
    if (!lines.next(title)) return {block.text.file, block.text.end, block.text.end};
    const uint64_t begin = deck.file(title.file).next_line(title.begin);
    return {block.text.file, begin < block.text.end ? begin : block.text.end, block.text.end};
}

std::vector<WrittenId> read_ids(const Deck& deck, const Block& block, IssueLog& issues) {
    std::vector<WrittenId> ids;
    for_each_id(deck, block.scope, list_text(deck, block), issues,
                [&](const WrittenId* id, std::size_t count) { ids.insert(ids.end(), id, id + count); });
    return ids;
}

} // namespace drawbead
