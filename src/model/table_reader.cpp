#include "model/table_reader.h"

#include "base/parallel.h"
#include "model/line_kernels.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/core.h>
#include <string_view>
#include <utility>

namespace drawbead {

namespace {

constexpr uint64_t piece_bytes = uint64_t{4} << 20;
constexpr uint32_t most_cells = 10;

// ------------------------------------------------------------------------------------------------ cards as data

constexpr int last_narrow_layout = 50; ///< 41, 42, 44: 8-column integers and 16-column reals

constexpr std::array<Field, 8> node_fields{{
    {"id", 1, 8, Kind::integer, dimensionless, 0, last_narrow_layout},
    {"x", 9, 16, Kind::real, length_dimension, 0, last_narrow_layout},
    {"y", 25, 16, Kind::real, length_dimension, 0, last_narrow_layout},
    {"z", 41, 16, Kind::real, length_dimension, 0, last_narrow_layout},
    {"id", 1, 10, Kind::integer, dimensionless, last_narrow_layout + 1},
    {"x", 11, 20, Kind::real, length_dimension, last_narrow_layout + 1},
    {"y", 31, 20, Kind::real, length_dimension, last_narrow_layout + 1},
    {"z", 51, 20, Kind::real, length_dimension, last_narrow_layout + 1},
}};
constexpr CardSchema node_card{"node", node_fields};

constexpr std::array<std::string_view, most_cells + 1> cell_names{"id", "n1", "n2", "n3", "n4", "n5",
                                                                  "n6", "n7", "n8", "n9", "n10"};

/// `count` integer cells named from cell_names[first] on, for both widths; then, for shells, Phi and Thick.
template <std::size_t count, bool shell = false>
constexpr auto element_fields(std::size_t first = 0) {
    std::array<Field, 2 * (count + (shell ? 2 : 0))> fields{};
    std::size_t at = 0;
    for (const uint8_t width : {uint8_t{8}, uint8_t{10}}) {
        const int since = width == 8 ? 0 : last_narrow_layout + 1, until = width == 8 ? last_narrow_layout : newest_layout;
        const auto column = [width](std::size_t cell) { return static_cast<uint8_t>(1 + cell * width); };
        for (std::size_t i = 0; i < count; ++i)
            fields[at++] = {cell_names[first + i], column(i), width, Kind::integer, dimensionless, since, until};
        if (shell) {
            const auto real = static_cast<uint8_t>(2 * width);
            fields[at++] = {"Phi", column(6), real, Kind::real, dimensionless, since, until};
            fields[at++] = {"Thick", column(8), real, Kind::real, length_dimension, since, until};
        }
    }
    return fields;
}

constexpr auto shell4_fields = element_fields<5, true>();
constexpr auto shell3_fields = element_fields<4, true>();
constexpr auto fields_1 = element_fields<1>();
constexpr auto fields_5 = element_fields<5>();
constexpr auto fields_7 = element_fields<7>();
constexpr auto fields_9 = element_fields<9>();
constexpr auto tetra10_fields = element_fields<10>(1);
constexpr CardSchema shell4_card{"shell", shell4_fields}, shell3_card{"sh3n", shell3_fields}, id_card{"element", fields_1},
    tetra4_card{"tetra4", fields_5}, penta6_card{"penta6", fields_7}, brick_card{"brick", fields_9},
    tetra10_nodes_card{"tetra10 nodes", tetra10_fields};

enum class Target : uint8_t { nodes, shells4, shells3, solids };

/// How the rows of a table block are written.
struct Form {
    std::string_view keyword;
    Target target;
    SolidKind solid;
    uint32_t lines_per_row;
    uint32_t cells; ///< integers on the first line: the id and the nodes that we keep
    const CardSchema* card;
    std::string_view name; ///< of one row, in messages
};

constexpr std::array<Form, 10> forms{{
    {"NODE", Target::nodes, {}, 1, 1, &node_card, "node"},
    {"CNODE", Target::nodes, {}, 1, 1, &node_card, "node"},
    {"SHELL", Target::shells4, {}, 1, 5, &shell4_card, "shell"},
    {"SH3N", Target::shells3, {}, 1, 4, &shell3_card, "sh3n"},
    {"BRICK", Target::solids, SolidKind::brick, 1, 9, &brick_card, "solid"},
    {"TETRA4", Target::solids, SolidKind::tetra4, 1, 5, &tetra4_card, "solid"},
    {"PENTA6", Target::solids, SolidKind::penta6, 1, 7, &penta6_card, "solid"},
    {"TETRA10", Target::solids, SolidKind::tetra10, 2, 1, &id_card, "solid"},
    {"BRIC20", Target::solids, SolidKind::bric20, 3, 9, &brick_card, "solid"},
    {"SHEL16", Target::solids, SolidKind::shel16, 3, 9, &brick_card, "solid"},
}};

const Form* form_of(std::string_view keyword) {
    for (const Form& form : forms)
        if (form.keyword == keyword) return &form;
    return nullptr;
}

// ------------------------------------------------------------------------------------------------ issues

/// The first issues of each kind, and how many there are.
class Issues {
public:
    void add(ReadIssue issue) {
        Entry& entry = entries_[static_cast<std::size_t>(issue.kind)];
        entry.total += issue.count;
        if (entry.listed.size() == issue_limit) return;
        issue.count = 1;
        entry.listed.push_back(std::move(issue));
    }
    /// Whether another issue of the kind would only be counted.
    bool full(ReadIssue::Kind kind) const {
        return entries_[static_cast<std::size_t>(kind)].listed.size() == issue_limit;
    }
    void count(ReadIssue::Kind kind, uint64_t more) { entries_[static_cast<std::size_t>(kind)].total += more; }
    void append(Issues&& later) {
        for (std::size_t kind = 0; kind < kinds; ++kind) {
            Entry &to = entries_[kind], &from = later.entries_[kind];
            to.total += from.total;
            for (ReadIssue& issue : from.listed)
                if (to.listed.size() < issue_limit) to.listed.push_back(std::move(issue));
        }
    }
    void write_to(std::vector<ReadIssue>& out) {
        for (Entry& entry : entries_) {
            if (entry.listed.empty()) continue;
            entry.listed.back().count = entry.total - (entry.listed.size() - 1);
            for (ReadIssue& issue : entry.listed) out.push_back(std::move(issue));
        }
    }

private:
    static constexpr std::size_t kinds = static_cast<std::size_t>(ReadIssue::Kind::member_missing) + 1;
    struct Entry {
        std::vector<ReadIssue> listed;
        uint64_t total = 0;
    };
    std::array<Entry, kinds> entries_;
};

// ------------------------------------------------------------------------------------------------ pieces of text

/// A table block and what its numbers mean.
struct Source {
    uint32_t block = 0;
    const Form* form = nullptr;
    bool parse = false; ///< else its lines are only counted
    CellWidths widths;
    Offsets offsets;
    double length = 1; ///< factor to work units
    PartId part = 0;
    uint64_t lines = 0; ///< data lines, when all its pieces are done
};

/// Lines of one source that one thread reads, and what it found there.
struct Piece {
    uint32_t source = 0;
    Span text; ///< begins at a line start, ends at one or at the end of the file

    uint64_t lines = 0;      ///< data lines
    uint32_t skip = 0;       ///< data lines at the begin that belong to the last row of the piece before
    std::size_t place = 0;   ///< first row of the room that the table keeps for it
    std::size_t room = 0;    ///< rows at most
    std::size_t rows = 0;    ///< rows stored
    std::vector<RowPiece> row_pieces; ///< rows counted from `place`
    std::vector<std::pair<uint32_t, double>> thickness;
    Issues issues;
};

uint64_t next_line(std::string_view bytes, uint64_t at) {
    return static_cast<uint64_t>(line_end(bytes.data() + at, bytes.data() + bytes.size()) - bytes.data()) + 1;
}

/// `text` without the comments and blank lines that it begins and ends with.
Span trimmed(std::string_view bytes, Span text) {
    while (text.begin < text.end) {
        const uint64_t next = std::min(next_line(bytes, text.begin), text.end);
        if (!is_skipped(bytes.substr(text.begin, next - text.begin - (bytes[next - 1] == '\n')))) break;
        text.begin = next;
    }
    while (text.begin < text.end) {
        const uint64_t stop = text.end - (bytes[text.end - 1] == '\n');
        const std::string_view before = bytes.substr(text.begin, stop - text.begin);
        const std::size_t newline = before.rfind('\n');
        const std::size_t last = newline == std::string_view::npos ? 0 : newline + 1;
        if (!is_skipped(before.substr(last))) break;
        text.end = text.begin + last;
    }
    return text;
}

/// The text of a block, cut at directive lines, which are left out with their continuation lines.
std::vector<Span> stretches(const Deck& deck, const Span& text) {
    const SourceFile& file = deck.file(text.file);
    std::vector<Span> found;
    Span rest = text;
    const std::vector<uint64_t>& marks = file.marks();
    for (auto mark = std::lower_bound(marks.begin(), marks.end(), text.begin); mark != marks.end() && *mark < text.end;
         ++mark) {
        if (*mark < rest.begin || file.bytes()[*mark] != '#') continue;
        found.push_back({text.file, rest.begin, *mark});
        Span line;
        rest.begin = DataLines(deck, Span{text.file, *mark, text.end}).next(line) ? line.begin : text.end;
    }
    found.push_back(rest);
    return found;
}

void cut_into_pieces(const Deck& deck, const Block& block, uint32_t source, std::vector<Piece>& pieces) {
    const std::string_view bytes = deck.file(block.text.file).bytes();
    for (const Span& stretch : stretches(deck, block.text)) {
        Span text = trimmed(bytes, stretch);
        while (text.begin < text.end) {
            // Cuts near multiples of the size keep the counting of lines before them short.
            const uint64_t goal = (text.begin / piece_bytes + 1) * piece_bytes;
            uint64_t cut = text.end;
            if (goal + piece_bytes / 2 < text.end) cut = std::min(next_line(bytes, goal - 1), text.end);
            Piece piece;
            piece.source = source;
            piece.text = {text.file, text.begin, cut};
            pieces.push_back(std::move(piece));
            text.begin = cut;
        }
    }
}

/// Lines of a piece, comments and blank ones too.
uint64_t lines_of(const Deck& deck, const Span& text) {
    const SourceFile& file = deck.file(text.file);
    const std::string_view inside = deck.text(text);
    if (inside.empty()) return 0;
    const uint64_t newlines = text.size() > 2 * LineScan::stride
                                  ? file.newlines_before(text.end) - file.newlines_before(text.begin)
                                  : count_newlines(inside);
    return newlines + (inside.back() != '\n');
}

// ------------------------------------------------------------------------------------------------ one exact line

/// Everything that reading a piece needs.
struct Context {
    const Deck& deck;
    const TableRequest& request;
    const NodeTable& nodes;
};

/// Reads lines of a piece that the kernels leave.
class LineReader {
public:
    LineReader(const Context& context, const Source& source, Piece& piece)
        : deck_(context.deck), source_(source), scope_(context.deck.blocks()[source.block].scope), piece_(piece) {}

    Span span(std::string_view line) const {
        const auto begin = static_cast<uint64_t>(line.data() - deck_.file(piece_.text.file).bytes().data());
        return {piece_.text.file, begin, begin + line.size()};
    }
    Card card(std::string_view line, const CardSchema& schema) const {
        return read_card(deck_, scope_, span(line), schema);
    }

    /// The global id in a cell; 0, with an issue, when the row cannot be stored.
    uint32_t id(const Card& card, int64_t offset) {
        const Cell& cell = card["id"];
        if (cell.state == CellState::not_finite) {
            report(ReadIssue::Kind::id_overflow, cell, card, {});
            return 0;
        }
        if (!check(cell, card, "id")) return 0;
        const int64_t global = Deck::global_id(cell.integer, offset);
        if (global > 0 && global <= largest_id) return static_cast<uint32_t>(global);
        report(global > 0 ? ReadIssue::Kind::id_overflow : ReadIssue::Kind::id_missing, cell, card, {});
        return 0;
    }
    /// False, with an issue, when a cell cannot be used as a number. A blank cell can.
    bool check(const Cell& cell, const Card& card, std::string_view subject) {
        switch (cell.state) {
        case CellState::garbage: report(ReadIssue::Kind::not_a_number, cell, card, subject); return false;
        case CellState::not_finite: report(ReadIssue::Kind::not_finite, cell, card, subject); return false;
        case CellState::unknown_parameter: report(ReadIssue::Kind::unknown_parameter, cell, card, subject); return false;
        default: return true;
        }
    }

private:
    void report(ReadIssue::Kind kind, const Cell& cell, const Card& card, std::string_view cell_name) {
        ReadIssue issue;
        issue.kind = kind;
        issue.place = cell.text.empty() ? card.line : cell.place;
        issue.subject = source_.form->name;
        if (!cell_name.empty()) issue.subject += fmt::format(" {}", cell_name);
        issue.detail = std::string(cell.text);
        piece_.issues.add(std::move(issue));
    }

    const Deck& deck_;
    const Source& source_;
    ScopeId scope_;
    Piece& piece_;
};

/// Rows [first, now) of a piece come from the lines from `from` on without a gap; a line that is left out ends that.
class RowTrail {
public:
    RowTrail(const Source& source, Piece& piece, uint64_t from) : source_(source), piece_(piece), from_(from) {}
    void break_at(std::size_t now, uint64_t from) {
        if (now > first_)
            piece_.row_pieces.push_back({static_cast<uint32_t>(first_), static_cast<uint32_t>(now), source_.block, from_,
                                         source_.form->lines_per_row});
        first_ = now;
        from_ = from;
    }

private:
    const Source& source_;
    Piece& piece_;
    std::size_t first_ = 0;
    uint64_t from_;
};

/// The line at `range.at` without its line end; moves `range.at` to the next one.
std::string_view take_line(LineRange& range) {
    const char* const begin = range.at;
    const char* stop = line_end(begin, range.end);
    range.at = stop < range.end ? stop + 1 : range.end;
    if (stop > begin && stop[-1] == '\r') --stop;
    return {begin, static_cast<std::size_t>(stop - begin)};
}

LineRange range_of(const Deck& deck, const Span& text) {
    const std::string_view bytes = deck.file(text.file).bytes();
    return {bytes.data() + text.begin, bytes.data() + text.end, bytes};
}

// ------------------------------------------------------------------------------------------------ nodes

void read_node_piece(const Context& context, const Source& source, Piece& piece, NodeTable& table) {
    LineReader reader(context, source, piece);
    RowTrail trail(source, piece, piece.text.begin);
    LineRange range = range_of(context.deck, piece.text);
    NodeRows rows{table.id.data() + piece.place, table.x.data() + piece.place, piece.room, 0, source.offsets.node,
                  source.length};
    uint64_t left_out = 0;
    while (read_node_lines(best_kernel(), source.widths, range, rows), range.at < range.end) {
        const std::string_view line = take_line(range);
        if (is_skipped(line)) continue;
        const Card card = reader.card(line, node_card);
        const uint32_t id = reader.id(card, source.offsets.node);
        if (id == 0) {
            ++left_out;
            trail.break_at(rows.count, static_cast<uint64_t>(range.at - range.file.data()));
            continue;
        }
        std::array<double, 3> x{};
        constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
        for (std::size_t i = 0; i < 3; ++i) {
            const Cell& cell = card[names[i]];
            x[i] = reader.check(cell, card, fmt::format("{} {}", id, names[i])) ? cell.real * source.length : 0.0;
        }
        rows.id[rows.count] = id;
        rows.x[rows.count] = {x[0], x[1], x[2]};
        ++rows.count;
    }
    trail.break_at(rows.count, piece.text.end);
    piece.rows = rows.count;
    piece.lines = rows.count + left_out;
}

// ------------------------------------------------------------------------------------------------ elements

/// The columns of a table of elements; what a table does not have is null.
struct ElementRows {
    uint32_t* id = nullptr;
    std::array<NodeRow, 4>* shell = nullptr;
    std::array<NodeRow, 8>* solid = nullptr;
    std::array<NodeRow, 6>* mid = nullptr;
    SolidKind* kind = nullptr;
};

class ElementReader {
public:
    ElementReader(const Context& context, const Source& source, Piece& piece, ElementRows rows)
        : context_(context), source_(source), piece_(piece), rows_(rows), reader_(context, source, piece),
          trail_(source, piece, piece.text.begin), bytes_(context.deck.file(piece.text.file).bytes()) {}

    void read() {
        if (source_.form->lines_per_row > 1)
            read_cards();
        else
            read_lines();
        piece_.rows = count_;
    }

private:
    static constexpr std::size_t batch = 512;

    uint64_t offset(const char* at) const { return static_cast<uint64_t>(at - bytes_.data()); }

    void read_lines() {
        LineRange range = range_of(context_.deck, piece_.text);
        const uint32_t cells = source_.form->cells;
        std::array<uint32_t, batch * most_cells> values;
        uint64_t left_out = 0;
        while (range.at < range.end) {
            const char* const from = range.at;
            IdRows ids{values.data(), cells, batch, 0};
            read_id_lines(best_kernel(), source_.widths, range, ids);
            if (ids.count > 0) {
                left_out += store(values.data(), ids.count, from);
                continue;
            }
            const std::string_view line = take_line(range);
            if (is_skipped(line)) continue;
            if (read_shell_line(line, values.data())) {
                left_out += store(values.data(), 1, from);
                continue;
            }
            if (!read_exactly(reader_.card(line, *source_.form->card), nullptr)) {
                ++left_out;
                trail_.break_at(count_, offset(range.at));
            }
        }
        trail_.break_at(count_, piece_.text.end);
        piece_.lines = count_ + left_out;
    }

    /// A plain line with something behind the node ids, such as a thickness.
    bool read_shell_line(std::string_view line, uint32_t* values) {
        if (!plain_integers(line, source_.widths, source_.form->cells, values) || values[0] == 0) return false;
        if (line.find(',') != std::string_view::npos) return false;
        if (!wants_thickness()) return true;
        const uint32_t width = source_.widths.integer;
        double thickness = 0;
        if (!plain_real(columns(line, 8 * width, 2 * width), thickness)) return false;
        const int64_t id = values[0] + source_.offsets.element;
        if (id < 1 || id > largest_id) return false;
        add_thickness(thickness);
        return true;
    }
    bool wants_thickness() const { return context_.request.thickness && rows_.solid == nullptr; }
    void add_thickness(double written) {
        if (written != 0) piece_.thickness.emplace_back(static_cast<uint32_t>(count_), written * source_.length);
    }

    uint32_t row_of(uint32_t written) const {
        if (written == 0) return IdMap::none;
        const int64_t global = written + source_.offsets.node;
        return global < 1 || global > largest_id ? IdMap::none : context_.nodes.map.row(static_cast<uint32_t>(global));
    }

    /// Stores consecutive plain lines, the first of which is at `from`. The number of lines left out.
    uint64_t store(const uint32_t* values, std::size_t lines, const char* from) {
        const uint32_t cells = source_.form->cells;
        uint64_t left_out = 0;
        for (std::size_t i = 0; i < lines; ++i) {
            const uint32_t* const cell = values + i * cells;
            const int64_t id = cell[0] + source_.offsets.element;
            if (id < 1 || id > largest_id) {
                const std::string_view line = line_of(from, i);
                const Card card = reader_.card(line, *source_.form->card);
                static_cast<void>(reader_.id(card, source_.offsets.element));
                ++left_out;
                trail_.break_at(count_, next_line(bytes_, offset(line.data())));
                continue;
            }
            rows_.id[count_] = static_cast<uint32_t>(id);
            bool known = true;
            if (rows_.shell) {
                std::array<NodeRow, 4>& nodes = rows_.shell[count_];
                for (uint32_t n = 0; n < cells - 1; ++n) {
                    const uint32_t row = row_of(cell[n + 1]);
                    known &= row != IdMap::none;
                    nodes[n] = NodeRow{row};
                }
                if (cells == 4) nodes[3] = nodes[2];
            } else if (rows_.solid) {
                std::array<NodeRow, 8>& nodes = rows_.solid[count_];
                nodes.fill(no_node);
                for (uint32_t n = 0; n < cells - 1; ++n) {
                    const uint32_t row = row_of(cell[n + 1]);
                    known &= row != IdMap::none;
                    nodes[n] = NodeRow{row};
                }
            }
            if (rows_.kind) rows_.kind[count_] = source_.form->solid;
            if (rows_.mid) rows_.mid[count_].fill(no_node);
            if (!known) report_unknown(static_cast<uint32_t>(id), cell, cells, line_of(from, i));
            ++count_;
        }
        return left_out;
    }
    std::string_view line_of(const char* from, std::size_t line) const {
        LineRange range{from, bytes_.data() + piece_.text.end, bytes_};
        std::string_view text = take_line(range);
        for (std::size_t i = 0; i < line; ++i) text = take_line(range);
        return text;
    }

    void report_unknown(uint32_t id, const uint32_t* cell, uint32_t cells, std::string_view line) {
        for (uint32_t n = 1; n < cells; ++n) {
            if (row_of(cell[n]) != IdMap::none) continue;
            const Cell written = read_cell(context_.deck, context_.deck.blocks()[source_.block].scope, reader_.span(line),
                                           n * source_.widths.integer + 1, source_.widths.integer, Kind::integer);
            report_unknown(id, cell[n], written.text.empty() ? reader_.span(line) : written.place);
        }
    }
    void report_unknown(uint32_t id, int64_t written, Span place) {
        if (piece_.issues.full(ReadIssue::Kind::unknown_node)) {
            piece_.issues.count(ReadIssue::Kind::unknown_node, 1);
            return;
        }
        ReadIssue issue;
        issue.kind = ReadIssue::Kind::unknown_node;
        issue.place = place;
        issue.subject = fmt::format("{} {}", source_.form->name, id);
        issue.detail = fmt::format("node {}", Deck::global_id(written, source_.offsets.node));
        piece_.issues.add(std::move(issue));
    }

    /// One cell of nodes of an element, with an issue when there is no such node.
    NodeRow node(const Card& card, std::string_view name, uint32_t id, bool may_be_zero) {
        const Cell& cell = card[name];
        if (!reader_.check(cell, card, fmt::format("{} {}", id, name))) return no_node;
        const int64_t global = Deck::global_id(cell.integer, source_.offsets.node);
        const uint32_t row = global < 1 || global > largest_id
                                 ? IdMap::none
                                 : context_.nodes.map.row(static_cast<uint32_t>(global));
        if (row == IdMap::none && !(may_be_zero && global == 0))
            report_unknown(id, cell.integer, cell.text.empty() ? card.line : cell.place);
        return NodeRow{row};
    }

    /// Any element, from its first card and, for a tetra10, the card of its nodes. False when it is left out.
    bool read_exactly(const Card& first, const Card* second) {
        const uint32_t id = reader_.id(first, source_.offsets.element);
        if (id == 0) return false;
        rows_.id[count_] = id;
        const uint32_t cells = source_.form->cells;
        if (rows_.kind) rows_.kind[count_] = source_.form->solid;
        if (rows_.mid) rows_.mid[count_].fill(no_node);
        if (rows_.shell) {
            std::array<NodeRow, 4>& nodes = rows_.shell[count_];
            for (uint32_t n = 0; n < cells - 1; ++n) nodes[n] = node(first, cell_names[n + 1], id, false);
            if (cells == 4) nodes[3] = nodes[2];
        } else if (rows_.solid) {
            std::array<NodeRow, 8>& nodes = rows_.solid[count_];
            nodes.fill(no_node);
            for (uint32_t n = 0; n + 1 < cells; ++n) nodes[n] = node(first, cell_names[n + 1], id, false);
            if (second) {
                for (uint32_t n = 0; n < 4; ++n) nodes[n] = node(*second, cell_names[n + 1], id, false);
                for (uint32_t n = 4; n < 10; ++n) rows_.mid[count_][n - 4] = node(*second, cell_names[n + 1], id, true);
            }
        }
        if (wants_thickness()) {
            const Cell& cell = first["Thick"];
            if (reader_.check(cell, first, fmt::format("{} Thick", id))) add_thickness(cell.real);
        }
        ++count_;
        return true;
    }

    void read_cards() {
        // The last row may end in the next piece, and a directive may stand between its lines.
        const Deck& deck = context_.deck;
        const Span block = deck.blocks()[source_.block].text;
        const ScopeId scope = deck.blocks()[source_.block].scope;
        DataLines lines(deck, Span{block.file, piece_.text.begin, block.end});
        Span line;
        for (uint32_t i = 0; i < piece_.skip; ++i)
            if (!lines.next_filled(line)) return;
        trail_.break_at(0, line.end > 0 ? std::min(next_line(bytes_, line.end), block.end) : piece_.text.begin);
        const uint32_t per_row = source_.form->lines_per_row;
        for (std::size_t row = 0; row < piece_.room && lines.next_filled(line); ++row) {
            const Card first = read_card(deck, scope, line, *source_.form->card);
            Card second = missing_card(deck, scope, tetra10_nodes_card);
            for (uint32_t i = 1; i < per_row; ++i) {
                if (!lines.next_filled(line)) break;
                if (i == 1 && source_.form->solid == SolidKind::tetra10)
                    second = read_card(deck, scope, line, tetra10_nodes_card);
            }
            if (!read_exactly(first, source_.form->solid == SolidKind::tetra10 ? &second : nullptr))
                trail_.break_at(count_, std::min(next_line(bytes_, line.end), block.end));
        }
        trail_.break_at(count_, block.end);
    }

    const Context& context_;
    const Source& source_;
    Piece& piece_;
    ElementRows rows_;
    LineReader reader_;
    RowTrail trail_;
    std::string_view bytes_;
    std::size_t count_ = 0;
};

} // namespace
