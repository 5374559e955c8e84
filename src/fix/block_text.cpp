#include "fix/block_text.h"

#include "deck/keyword_line.h"

#include <algorithm>
#include <charconv>

namespace drawbead {

namespace {

/// The last byte after the last data line, its line end included.
uint64_t data_end(const Deck& deck, const Block& block) {
    const SourceFile& file = deck.file(block.header.file);
    uint64_t end = file.next_line(block.header.begin);
    DataLines lines(deck, block);
    for (Span line; lines.next(line);)
        if (!trim(deck.text(line)).empty()) end = file.next_line(line.begin);
    return end;
}

std::string line_end_of(const Deck& deck, const Block& block) {
    const std::string_view bytes = deck.file(block.header.file).bytes();
    return block.header.end < bytes.size() && bytes[block.header.end] == '\r' ? "\r\n" : "\n";
}

bool has_title_line(const Deck& deck, const Block& block) {
    if (deck.scope(block.scope).layout >= 51) return true;
    const std::string_view last = trim(deck.text(block.header));
    const std::size_t slash = last.rfind('/');
    const std::string_view title = slash == std::string_view::npos ? last : trim(last.substr(slash + 1));
    return title.empty() || title.find_first_not_of("0123456789") == std::string_view::npos;
}

void put_right(std::string& line, uint32_t column, uint32_t width, std::string_view text) {
    const std::size_t begin = column - 1 + width - std::min<std::size_t>(text.size(), width);
    if (line.size() < begin) line.resize(begin, ' ');
    line.replace(begin, std::min(line.size() - begin, text.size()), text);
}

} // namespace

BlockEnd block_end(const Deck& deck, BlockIndex served) {
    const Block& block = deck.blocks()[served];
    const std::string_view bytes = deck.file(block.header.file).bytes();
    const uint64_t end = data_end(deck, block);
    return {{block.header.file, end, end}, line_end_of(deck, block), end > 0 && bytes[end - 1] != '\n'};
}

BlockWriter::BlockWriter(const Deck& deck, BlockIndex served)
    : layout_(deck.scope(deck.blocks()[served].scope).layout),
      title_lines_(has_title_line(deck, deck.blocks()[served])),
      line_end_(line_end_of(deck, deck.blocks()[served])) {}

void BlockWriter::line(std::string_view text) {
    text_ += text;
    text_ += line_end_;
}

void BlockWriter::header(std::string_view keyword, int64_t id, std::string_view title, int64_t unit) {
    std::string head = "/" + std::string(keyword) + "/" + std::to_string(id);
    if (unit != 0) head += "/" + std::to_string(unit);
    if (!title_lines_) return line(head + "/" + std::string(title));
    line(head);
    line(title.substr(0, 100));
}

void BlockWriter::ids(std::span<const int64_t> list) {
    const std::size_t width = id_width();
    text_.reserve(text_.size() + list.size() * (width + 1));
    char digits[24];
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto end = std::to_chars(digits, digits + sizeof digits, list[i]).ptr;
        const auto length = static_cast<std::size_t>(end - digits);
        text_.append(width - std::min(length, width), ' ');
        text_.append(digits, length);
        if (i % 10 == 9 || i + 1 == list.size()) text_ += line_end_;
    }
}

void BlockWriter::card(const CardSchema& schema,
                       std::initializer_list<std::pair<std::string_view, std::string_view>> values) {
    std::string row;
    for (const Field& field : schema.fields) {
        if (field.since > layout_ || layout_ > field.until) continue;
        for (const auto& [name, text] : values)
            if (field.name == name) put_right(row, field.column, field.width, text);
    }
    line(row);
}

BlockCopy::BlockCopy(const Deck& deck, BlockIndex block) : deck_(deck), block_(block), editor_(deck) {}

std::string BlockCopy::text() {
    const Block& block = deck_.blocks()[block_];
    const std::string_view bytes = deck_.file(block.header.file).bytes();
    const uint64_t begin = block.header.begin, end = data_end(deck_, block);
    // Lines that are neither data nor plain comments: what they bring in is there already.
    for (uint64_t at = begin; at < end;)
        if (const auto include = bytes[at] == '#' ? include_at(bytes, at) : std::nullopt) {
            editor_.delete_lines({block.header.file, at, include->next});
            at = include->next;
        } else {
            at = deck_.file(block.header.file).next_line(at);
        }
    EditList edits = editor_.edits();
    if (editor_.failed()) return {};
    for (Edit& e : edits) {
        e.at.begin -= begin;
        e.at.end -= begin;
    }
    std::string text = edited(bytes.substr(begin, end - begin), edits);
    if (text.empty() || text.back() != '\n') text += line_end_of(deck_, block);
    return text;
}

} // namespace drawbead
