#include "deck/card.h"

#include "deck/deck.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

bool holds(const Field& field, int layout) {
    return field.since <= layout && layout <= field.until;
}

/// Replaces `&name` or `-&name` by its parameter.
void read_reference(const Deck& deck, ScopeId scope, std::string_view text, Kind kind, Cell& cell) {
    const bool negative = text[0] == '-';
    std::string_view name = text.substr(negative ? 2 : 1);
    name = name.substr(0, name.find_first_of(" \t"));
    const Parameter* parameter = deck.parameter(scope, name);
    if (!parameter || (kind != Kind::text && parameter->kind == Parameter::Kind::text)) {
        cell.state = CellState::unknown_parameter;
        return;
    }
    cell.state = CellState::ok;
    cell.real = negative ? -parameter->value : parameter->value;
    // Ids and flags are at most ten digits; a real out of that range is no integer.
    constexpr double largest = 2147483647;
    if (kind == Kind::integer && !(std::abs(cell.real) <= largest)) {
        cell.state = CellState::not_finite;
        cell.real = 0;
        return;
    }
    cell.integer = kind == Kind::integer ? static_cast<int64_t>(cell.real) : 0;
}

CellState cell_state(NumberState state) {
    switch (state) {
    case NumberState::blank:
        return CellState::blank;
    case NumberState::ok:
        return CellState::ok;
    case NumberState::trailing:
        return CellState::trailing;
    case NumberState::garbage:
        return CellState::garbage;
    case NumberState::not_finite:
        return CellState::not_finite;
    }
    return CellState::garbage;
}

/// The cell whose raw text is [begin, end) of the line that starts at `line.begin`.
Cell cell_from(const Deck& deck, ScopeId scope, const Span& line, std::string_view raw, uint64_t offset,
               Kind kind) {
    Cell cell;
    cell.text = trim(raw);
    const uint64_t lead = cell.text.empty() ? 0 : static_cast<uint64_t>(cell.text.data() - raw.data());
    const uint64_t length = cell.text.empty() ? raw.size() : cell.text.size();
    cell.place = {line.file, line.begin + offset + lead, line.begin + offset + lead + length};
    if (cell.text.empty()) {
        cell.state = CellState::blank;
        return cell;
    }
    if (kind == Kind::text) {
        cell.state = CellState::ok;
        return cell;
    }
    if (cell.text[0] == '&' || (cell.text.size() > 1 && cell.text[0] == '-' && cell.text[1] == '&')) {
        read_reference(deck, scope, cell.text, kind, cell);
    } else if (kind == Kind::real) {
        const RealCell number = parse_real(cell.text);
        cell.state = cell_state(number.state);
        cell.real = number.value;
    } else {
        const IntegerCell number = parse_integer(cell.text);
        cell.state = cell_state(number.state);
        cell.integer = number.value;
        cell.real = static_cast<double>(number.value);
    }
    return cell;
}

std::string_view columns(std::string_view text, uint32_t column, uint32_t width) {
    if (column > text.size()) return text.substr(text.size());
    return text.substr(column - 1, width);
}

/// Which free-format position each field of the layout has: gaps between fields count as one empty field
/// each.
std::vector<int> free_positions(const CardSchema& schema, int layout) {
    std::vector<int> position(schema.fields.size(), -1);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < schema.fields.size(); ++i)
        if (holds(schema.fields[i], layout)) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return schema.fields[a].column < schema.fields[b].column;
    });
    uint32_t next_column = 1;
    int next = 0;
    for (const std::size_t i : order) {
        const Field& field = schema.fields[i];
        if (field.column > next_column) ++next;
        position[i] = next++;
        next_column = field.column + field.width;
    }
    return position;
}

} // namespace

const Cell& Card::operator[](std::string_view field) const {
    static const Cell absent;
    for (std::size_t i = 0; schema && i < schema->fields.size(); ++i)
        if (schema->fields[i].name == field && cells[i].state != CellState::absent) return cells[i];
    return absent;
}

std::vector<std::string_view> free_fields(std::string_view text) {
    std::vector<std::string_view> fields;
    std::size_t begin = 0;
    for (;;) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        std::string_view part = trim(text.substr(begin, comma - begin));
        if (part.empty()) fields.push_back(text.substr(comma, 0));
        while (!part.empty()) {
            const std::size_t blank = std::min(part.find_first_of(" \t"), part.size());
            fields.push_back(part.substr(0, blank));
            part = trim(part.substr(blank));
        }
        if (comma == text.size()) break;
        begin = comma + 1;
    }
    return fields;
}

Card read_card(const Deck& deck, ScopeId scope, Span line, const CardSchema& schema) {
    Card card;
    card.schema = &schema;
    card.present = true;
    card.line = line;
    card.cells.resize(schema.fields.size());
    const std::string_view text = deck.text(line);
    const int layout = deck.scope(scope).layout;
    const bool any_number = std::any_of(schema.fields.begin(), schema.fields.end(), [&](const Field& f) {
        return f.kind != Kind::text && holds(f, layout);
    });
    card.free_format = any_number && text.find(',') != std::string_view::npos;
    if (card.free_format) {
        const auto fields = free_fields(text);
        const auto position = free_positions(schema, layout);
        for (std::size_t i = 0; i < schema.fields.size(); ++i) {
            if (position[i] < 0) continue;
            const auto p = static_cast<std::size_t>(position[i]);
            const std::string_view raw = p < fields.size() ? fields[p] : text.substr(text.size());
            card.cells[i] = cell_from(deck, scope, line, raw, static_cast<uint64_t>(raw.data() - text.data()),
                                      schema.fields[i].kind);
        }
        return card;
    }
    for (std::size_t i = 0; i < schema.fields.size(); ++i) {
        const Field& field = schema.fields[i];
        if (!holds(field, layout)) continue;
        const std::string_view raw = columns(text, field.column, field.width);
        card.cells[i] =
            cell_from(deck, scope, line, raw, static_cast<uint64_t>(raw.data() - text.data()), field.kind);
    }
    return card;
}

Card missing_card(const Deck& deck, ScopeId scope, const CardSchema& schema) {
    Card card;
    card.schema = &schema;
    card.cells.resize(schema.fields.size());
    const int layout = deck.scope(scope).layout;
    for (std::size_t i = 0; i < schema.fields.size(); ++i)
        if (holds(schema.fields[i], layout)) card.cells[i].state = CellState::blank;
    return card;
}

Cell read_cell(const Deck& deck, ScopeId scope, Span line, uint32_t column, uint32_t width, Kind kind) {
    const std::string_view text = deck.text(line);
    const std::string_view raw = columns(text, column, width);
    return cell_from(deck, scope, line, raw, static_cast<uint64_t>(raw.data() - text.data()), kind);
}

} // namespace drawbead
