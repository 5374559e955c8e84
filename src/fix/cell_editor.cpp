#include "fix/cell_editor.h"

#include <algorithm>

namespace drawbead {

std::string& CellEditor::line(const Span& span) {
    const auto [at, added] = lines_.try_emplace({span.file, span.begin});
    if (added) at->second = {span.end, std::string(deck_.text(span))};
    return at->second.text;
}

void CellEditor::set_cell(const Card& card, std::string_view name, std::string_view text) {
    for (std::size_t i = 0; card.schema && i < card.schema->fields.size(); ++i) {
        const Field& field = card.schema->fields[i];
        const Cell& cell = card.cells[i];
        if (field.name != name || cell.state == CellState::absent) continue;
        if (!card.present) return fail("the line of the card does not exist");
        if (!card.free_format) return set_columns(card.line, field.column, field.width, text);
        if (cell.text.empty()) return fail("the line is in free format and ends before the field");
        return replace(cell.place, text.empty() ? "0" : std::string(text));
    }
    fail("this version of the deck has no field " + std::string(name));
}

void CellEditor::set_columns(const Span& span, uint32_t column, uint32_t width, std::string_view text) {
    if (text.size() > width) return fail("'" + std::string(text) + "' does not fit its columns");
    std::string& now = line(span);
    const std::size_t begin = column - 1;
    std::string cell(width - text.size(), ' ');
    cell += text;
    if (now.size() <= begin + width) {
        if (text.empty() && now.size() <= begin) return;
        now.resize(begin, ' ');
        now += cell;
        if (text.empty()) now.erase(now.find_last_not_of(' ') + 1);
    } else {
        now.replace(begin, width, cell);
    }
}

void CellEditor::set_listed_id(ScopeId scope, const Span& place, int64_t written) {
    const SourceFile& file = deck_.file(place.file);
    const uint64_t begin = file.line_begin(place.begin);
    const Span whole{place.file, begin, begin + file.line_at(place.begin).size()};
    const std::string text = std::to_string(written);
    if (deck_.text(whole).find(',') != std::string_view::npos) return replace(place, text);
    const uint32_t width = deck_.scope(scope).layout < 45 ? 8 : 10;
    const auto cell = static_cast<uint32_t>((place.begin - begin) / width);
    const uint32_t cell_begin = cell * width;
    // The last digit stays where it is as long as there is room before it.
    const auto right = static_cast<uint32_t>(place.end - begin);
    const auto shortest = static_cast<uint32_t>(text.size());
    const uint32_t end = std::min(std::max(right, cell_begin + shortest), cell_begin + width) - cell_begin;
    std::string columns = text + std::string(width - std::max(end, shortest), ' ');
    if (columns.size() > width) return fail("'" + text + "' does not fit its columns");
    std::string& now = line(whole);
    if (now.size() < cell_begin + width) { // the line ends inside the cell: no blanks are added behind
        columns.erase(columns.find_last_not_of(' ') + 1);
        columns.insert(0, end > columns.size() ? end - columns.size() : 0, ' ');
        now.resize(cell_begin, ' ');
        now += columns;
        return;
    }
    columns.insert(0, width - columns.size(), ' ');
    now.replace(cell_begin, width, columns);
}

void CellEditor::set_header_id(BlockIndex index, int64_t written) {
    const Block& block = deck_.blocks()[index];
    const std::string_view text = deck_.text(block.header);
    // The id is the first field of digits or the first parameter; columns do not matter on a header.
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t slash = text.find('/', at);
        if (slash == std::string_view::npos) break;
        std::size_t begin = text.find_first_not_of(" \t", slash + 1);
        if (begin == std::string_view::npos) break;
        std::size_t end = begin;
        if (text[begin] == '&') {
            end = std::min(text.find_first_of("/ \t", begin), text.size());
        } else {
            while (end < text.size() && text[end] >= '0' && text[end] <= '9')
                ++end;
            const std::size_t next = std::min(text.find_first_of("/ \t", end), text.size());
            if (next != end) end = begin;
        }
        if (end > begin)
            return replace({block.header.file, block.header.begin + begin, block.header.begin + end},
                           std::to_string(written));
        at = slash + 1;
    }
    fail("the header of /" + std::string(block.keyword) + " has no id to replace");
}

void CellEditor::replace(const Span& span, std::string text) {
    other_.push_back({span, std::move(text)});
}

void CellEditor::delete_lines(const Span& span) {
    const SourceFile& file = deck_.file(span.file);
    const uint64_t last = span.end > span.begin ? span.end - 1 : span.begin;
    other_.push_back({{span.file, file.line_begin(span.begin), file.next_line(last)}, ""});
}

EditList CellEditor::edits() {
    if (failed()) return {};
    EditList all;
    for (auto& [place, changed] : lines_)
        all.push_back({{place.first, place.second, changed.end}, changed.text});
    std::move(other_.begin(), other_.end(), std::back_inserter(all));
    lines_.clear();
    other_.clear();
    sort_edits(all);
    EditList out;
    for (std::size_t i = 0; i < all.size();) {
        std::size_t end = i;
        EditList one;
        for (; end < all.size() && all[end].at.file == all[i].at.file; ++end)
            one.push_back(std::move(all[end]));
        const FileId file = one.front().at.file;
        EditList least = minimal(deck_.file(file).bytes(), one);
        std::move(least.begin(), least.end(), std::back_inserter(out));
        i = end;
    }
    if (!in_order(out)) {
        fail("two of its changes meet on one line");
        return {};
    }
    return out;
}

} // namespace drawbead
