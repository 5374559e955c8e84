#include "model/table_reader.h"

#include "base/parallel.h"
#include "deck/keyword_line.h"
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

// ---- cards as data

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
        const int since = width == 8 ? 0 : last_narrow_layout + 1,
                  until = width == 8 ? last_narrow_layout : newest_layout;
        const auto column = [width](std::size_t cell) { return static_cast<uint8_t>(1 + cell * width); };
        for (std::size_t i = 0; i < count; ++i)
            fields[at++] = {cell_names[first + i], column(i), width, Kind::integer,
                            dimensionless,         since,     until};
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
constexpr CardSchema shell4_card{"shell", shell4_fields}, shell3_card{"sh3n", shell3_fields},
    id_card{"element", fields_1}, tetra4_card{"tetra4", fields_5}, penta6_card{"penta6", fields_7},
    brick_card{"brick", fields_9}, tetra10_nodes_card{"tetra10 nodes", tetra10_fields};

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

// ---- issues

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
    void count(ReadIssue::Kind kind, uint64_t more) {
        entries_[static_cast<std::size_t>(kind)].total += more;
    }
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
            for (ReadIssue& issue : entry.listed)
                out.push_back(std::move(issue));
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

// ---- pieces of text

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

    uint64_t lines = 0;    ///< data lines
    uint32_t skip = 0;     ///< data lines at the begin that belong to the last row of the piece before
    std::size_t place = 0; ///< first row of the room that the table keeps for it
    std::size_t room = 0;  ///< rows at most
    std::size_t rows = 0;  ///< rows stored
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

/// The text of a block, cut at #include lines, which are left out with their continuation lines.
std::vector<Span> stretches(const Deck& deck, const Span& text) {
    const SourceFile& file = deck.file(text.file);
    std::vector<Span> found;
    Span rest = text;
    const std::vector<uint64_t>& marks = file.marks();
    for (auto mark = std::lower_bound(marks.begin(), marks.end(), text.begin);
         mark != marks.end() && *mark < text.end; ++mark) {
        if (*mark < rest.begin) continue;
        const auto include = include_at(file.bytes(), *mark);
        if (!include) continue;
        found.push_back({text.file, rest.begin, *mark});
        rest.begin = std::min(include->next, text.end);
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

// ---- one exact line

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
        : deck_(context.deck), source_(source), scope_(context.deck.blocks()[source.block].scope),
          piece_(piece) {}

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
        case CellState::garbage:
            report(ReadIssue::Kind::not_a_number, cell, card, subject);
            return false;
        case CellState::not_finite:
            report(ReadIssue::Kind::not_finite, cell, card, subject);
            return false;
        case CellState::unknown_parameter:
            report(ReadIssue::Kind::unknown_parameter, cell, card, subject);
            return false;
        default:
            return true;
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

/// Rows [first, now) of a piece come from the lines from `from` on without a gap; a line that is left out
/// ends that.
class RowTrail {
public:
    RowTrail(const Source& source, Piece& piece, uint64_t from)
        : source_(source), piece_(piece), from_(from) {}
    void break_at(std::size_t now, uint64_t from) {
        if (now > first_)
            piece_.row_pieces.push_back({static_cast<uint32_t>(first_), static_cast<uint32_t>(now),
                                         source_.block, from_, source_.form->lines_per_row});
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

// ---- nodes

void read_node_piece(const Context& context, const Source& source, Piece& piece, NodeTable& table) {
    LineReader reader(context, source, piece);
    RowTrail trail(source, piece, piece.text.begin);
    LineRange range = range_of(context.deck, piece.text);
    NodeRows rows{table.id.data() + piece.place,
                  table.x.data() + piece.place,
                  piece.room,
                  0,
                  source.offsets.node,
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
            x[i] = reader.check(cell, card, fmt::format("{} {}", id, names[i])) ? cell.real * source.length
                                                                                : 0.0;
        }
        rows.id[rows.count] = id;
        rows.x[rows.count] = {x[0], x[1], x[2]};
        ++rows.count;
    }
    trail.break_at(rows.count, piece.text.end);
    piece.rows = rows.count;
    piece.lines = rows.count + left_out;
}

// ---- elements

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
        std::array<std::string_view, batch> more;
        while (range.at < range.end) {
            const char* const from = range.at;
            IdRows ids{values.data(), more.data(), cells, batch, 0};
            read_id_lines(best_kernel(), source_.widths, range, ids);
            if (ids.count > 0) {
                store(ids, from);
                continue;
            }
            const std::string_view line = take_line(range);
            if (!is_skipped(line)) store_exactly(line);
        }
        trail_.break_at(count_, piece_.text.end);
        piece_.lines = count_ + left_out_;
    }

    bool wants_thickness() const {
        return context_.request.thickness && source_.form->target != Target::solids;
    }
    /// Adds the thickness of the row at hand; false when its cell is not plain. `more` begins after the last
    /// id.
    bool plain_thickness(std::string_view more) {
        double written = 0;
        const uint32_t width = source_.widths.integer;
        if (!plain_real(columns(more, (8 - source_.form->cells) * width, 2 * width), written)) return false;
        add_thickness(written);
        return true;
    }
    void add_thickness(double written) {
        if (written != 0)
            piece_.thickness.emplace_back(static_cast<uint32_t>(count_), written * source_.length);
    }

    uint32_t row_of(uint32_t written) const {
        if (written == 0) return IdMap::none;
        const int64_t global = written + source_.offsets.node;
        return global < 1 || global > largest_id ? IdMap::none
                                                 : context_.nodes.map.row(static_cast<uint32_t>(global));
    }

    /// Stores consecutive plain lines, the first of which is at `from`.
    void store(const IdRows& ids, const char* from) {
        const IdMap& map = context_.nodes.map;
        if (!map.consecutive() && (rows_.shell || rows_.solid)) {
            for (std::size_t i = 0; i < ids.count; ++i)
                for (uint32_t n = 1; n < ids.cells; ++n)
                    map.prefetch(static_cast<uint32_t>(ids.values[i * ids.cells + n] + source_.offsets.node));
        }
        const bool quads = rows_.shell && ids.cells == 5 && source_.offsets.node == 0;
        const std::size_t plain =
            quads ? map.with_rows([&](const auto& row) { return store_quads(ids, row); }) : 0;
        for (std::size_t i = plain; i < ids.count; ++i) {
            const uint32_t* const cell = ids.values + i * ids.cells;
            const int64_t id = cell[0] + source_.offsets.element;
            if (id < 1 || id > largest_id ||
                (!ids.more[i].empty() && wants_thickness() && !plain_thickness(ids.more[i]))) {
                store_exactly(line_of(from, i));
                continue;
            }
            rows_.id[count_] = static_cast<uint32_t>(id);
            if (rows_.kind) rows_.kind[count_] = source_.form->solid;
            if (rows_.mid) rows_.mid[count_].fill(no_node);
            bool known = true;
            if (rows_.shell) {
                std::array<NodeRow, 4>& nodes = rows_.shell[count_];
                known = find_nodes(cell + 1, ids.cells - 1, nodes.data());
                if (ids.cells == 4) nodes[3] = nodes[2];
            } else if (rows_.solid) {
                rows_.solid[count_].fill(no_node);
                known = find_nodes(cell + 1, ids.cells - 1, rows_.solid[count_].data());
            }
            if (!known) report_unknown(static_cast<uint32_t>(id), cell, ids.cells, from, i);
            ++count_;
        }
    }
    /// Stores quads whose ids are all that is to be said of them, up to the first that is not one; how many.
    template <class RowOf>
    std::size_t store_quads(const IdRows& ids, const RowOf& row_of) {
        const bool thickness = wants_thickness();
        const int64_t offset = source_.offsets.element;
        uint32_t* const to = rows_.id + count_;
        std::array<NodeRow, 4>* const nodes = rows_.shell + count_;
        std::size_t i = 0;
        for (; i < ids.count; ++i) {
            const uint32_t* const cell = ids.values + 5 * i;
            const int64_t id = cell[0] + offset;
            if (id < 1 || id > largest_id || (thickness && !ids.more[i].empty())) break;
            if (cell[1] == 0 || cell[2] == 0 || cell[3] == 0 || cell[4] == 0) break;
            const uint32_t a = row_of(cell[1]), b = row_of(cell[2]), c = row_of(cell[3]), d = row_of(cell[4]);
            if (a == IdMap::none || b == IdMap::none || c == IdMap::none || d == IdMap::none) break;
            to[i] = static_cast<uint32_t>(id);
            nodes[i] = {NodeRow{a}, NodeRow{b}, NodeRow{c}, NodeRow{d}};
        }
        count_ += i;
        return i;
    }
    /// Rows of written node ids; whether all of them exist.
    bool find_nodes(const uint32_t* written, uint32_t count, NodeRow* rows) const {
        bool known = true;
        for (uint32_t n = 0; n < count; ++n) {
            const uint32_t row = row_of(written[n]);
            known &= row != IdMap::none;
            rows[n] = NodeRow{row};
        }
        return known;
    }
    void store_exactly(std::string_view line) {
        if (read_exactly(reader_.card(line, *source_.form->card), nullptr)) return;
        ++left_out_;
        trail_.break_at(count_, std::min(next_line(bytes_, offset(line.data())), piece_.text.end));
    }
    std::string_view line_of(const char* from, std::size_t line) const {
        LineRange range{from, bytes_.data() + piece_.text.end, bytes_};
        std::string_view text = take_line(range);
        for (std::size_t i = 0; i < line; ++i)
            text = take_line(range);
        return text;
    }

    /// Nodes of a plain line that do not exist. When a whole node table is missing, counting them must be
    /// quick.
    void report_unknown(uint32_t id, const uint32_t* cell, uint32_t cells, const char* from,
                        std::size_t line) {
        for (uint32_t n = 1; n < cells; ++n) {
            if (row_of(cell[n]) != IdMap::none) continue;
            if (piece_.issues.full(ReadIssue::Kind::unknown_node)) {
                piece_.issues.count(ReadIssue::Kind::unknown_node, 1);
                continue;
            }
            const Span text = reader_.span(line_of(from, line));
            const Cell written =
                read_cell(context_.deck, context_.deck.blocks()[source_.block].scope, text,
                          n * source_.widths.integer + 1, source_.widths.integer, Kind::integer);
            report_unknown(id, cell[n], written.text.empty() ? text : written.place);
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
            for (uint32_t n = 0; n < cells - 1; ++n)
                nodes[n] = node(first, cell_names[n + 1], id, false);
            if (cells == 4) nodes[3] = nodes[2];
        } else if (rows_.solid) {
            std::array<NodeRow, 8>& nodes = rows_.solid[count_];
            nodes.fill(no_node);
            for (uint32_t n = 0; n + 1 < cells; ++n)
                nodes[n] = node(first, cell_names[n + 1], id, false);
            if (second) {
                for (uint32_t n = 0; n < 4; ++n)
                    nodes[n] = node(*second, cell_names[n + 1], id, false);
                for (uint32_t n = 4; n < 10; ++n)
                    rows_.mid[count_][n - 4] = node(*second, cell_names[n + 1], id, true);
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
        trail_.break_at(0,
                        line.end > 0 ? std::min(next_line(bytes_, line.end), block.end) : piece_.text.begin);
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
    uint64_t left_out_ = 0;
};

// ---- tables

struct Plan {
    std::vector<Source> sources;
    std::vector<Piece> pieces;    ///< in the order of their sources, and of the text in each
    std::array<Issues, 4> issues; ///< by Target

    Target target(const Piece& piece) const { return sources[piece.source].form->target; }
    bool parses(const Piece& piece) const { return sources[piece.source].parse; }
};

bool wanted(const TableRequest& request, const std::vector<PartId>& parts, const Form& form, PartId part) {
    if (form.target == Target::nodes) return request.coordinates;
    if (!(form.target == Target::solids ? request.solids : request.shells)) return false;
    if (request.elements == TableRequest::Elements::all) return true;
    return request.elements == TableRequest::Elements::of_parts &&
           std::binary_search(parts.begin(), parts.end(), part);
}

Plan plan_of(const Deck& deck, const TableRequest& request, Counts& counts) {
    Plan plan;
    std::vector<PartId> parts = request.parts;
    std::sort(parts.begin(), parts.end());
    const std::span<const Block> blocks = deck.blocks();
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const Block& block = blocks[i];
        if (block.keyword == "PART") ++counts.parts;
        const Form* form = form_of(block.keyword);
        if (!form) continue;
        const Scope& scope = deck.scope(block.scope);
        Source source;
        source.block = static_cast<uint32_t>(i);
        source.form = form;
        source.offsets = scope.offsets;
        if (scope.layout <= last_narrow_layout) source.widths = {8, 16};
        // /NODE has no id: the first number of its header is the unit.
        const bool nodes = form->target == Target::nodes;
        const int64_t unit = nodes && block.unit == 0 && block.id_given ? block.id : block.unit;
        if (!nodes) source.part = Deck::global_id(block.id, scope.offsets.part);
        source.parse = wanted(request, parts, *form, source.part);
        if (!source.parse && !request.counts) continue;
        if (source.parse) {
            const std::optional<double> factor = deck.factor(block.scope, unit, length_dimension);
            source.length = factor.value_or(1.0);
            if (!factor)
                plan.issues[static_cast<std::size_t>(form->target)].add({ReadIssue::Kind::unknown_unit,
                                                                         block.header,
                                                                         fmt::format("unit {}", unit),
                                                                         std::string(block.keyword),
                                                                         {},
                                                                         1});
        }
        cut_into_pieces(deck, block, static_cast<uint32_t>(plan.sources.size()), plan.pieces);
        plan.sources.push_back(source);
    }
    return plan;
}

/// How many rows each piece can have. A row of several lines belongs to the piece in which it begins.
void make_room(const Deck& deck, Plan& plan, unsigned threads) {
    parallel_for(threads, plan.pieces.size(), [&](std::size_t i) {
        Piece& piece = plan.pieces[i];
        if (!plan.parses(piece)) return;
        if (plan.sources[piece.source].form->lines_per_row == 1)
            piece.room = lines_of(deck, piece.text);
        else
            piece.lines = count_data_lines(deck.text(piece.text));
    });
    uint64_t before = 0; // data lines of the source
    std::array<std::size_t, 4> end{};
    for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
        Piece& piece = plan.pieces[i];
        if (!plan.parses(piece)) continue;
        if (i == 0 || plan.pieces[i - 1].source != piece.source) before = 0;
        if (const uint32_t per_row = plan.sources[piece.source].form->lines_per_row; per_row > 1) {
            piece.skip = static_cast<uint32_t>((per_row - before % per_row) % per_row);
            piece.room = piece.lines > piece.skip ? (piece.lines - piece.skip + per_row - 1) / per_row : 0;
            before += piece.lines;
        }
        std::size_t& place = end[static_cast<std::size_t>(plan.target(piece))];
        piece.place = place;
        place += piece.room;
    }
}

std::size_t room_of(const Plan& plan, Target target) {
    std::size_t room = 0;
    for (const Piece& piece : plan.pieces)
        if (plan.target(piece) == target) room += piece.room;
    return room;
}

/// Moves the rows of the pieces together, where lines without a row left room between them.
template <class T>
void close_gaps(const Plan& plan, Target target, Buffer<T>& column) {
    if (column.empty()) return;
    std::size_t end = 0;
    for (const Piece& piece : plan.pieces) {
        if (plan.target(piece) != target) continue;
        if (piece.place != end && piece.rows > 0)
            std::memmove(column.data() + end, column.data() + piece.place, piece.rows * sizeof(T));
        end += piece.rows;
    }
    column.resize(end);
}

/// Row pieces, and issues, of a table whose gaps are closed.
void place_rows(Plan& plan, Target target, std::vector<RowPiece>& row_pieces) {
    std::size_t end = 0;
    for (Piece& piece : plan.pieces) {
        if (plan.target(piece) != target || !plan.parses(piece)) continue;
        piece.place = end;
        end += piece.rows;
        for (RowPiece rows : piece.row_pieces) {
            rows.row_begin += static_cast<uint32_t>(piece.place);
            rows.row_end += static_cast<uint32_t>(piece.place);
            row_pieces.push_back(rows);
        }
        plan.issues[static_cast<std::size_t>(target)].append(std::move(piece.issues));
    }
}

std::vector<ElementRange> ranges_of(const Plan& plan, Target target) {
    std::vector<ElementRange> ranges;
    for (const Piece& piece : plan.pieces) {
        if (plan.target(piece) != target || piece.rows == 0) continue;
        const Source& source = plan.sources[piece.source];
        const auto end = static_cast<uint32_t>(piece.place + piece.rows);
        if (!ranges.empty() && ranges.back().block == source.block)
            ranges.back().row_end = end;
        else
            ranges.push_back({static_cast<uint32_t>(piece.place), end, source.part, source.block});
    }
    return ranges;
}

void report_duplicates(const Deck& deck, std::string_view name, std::span<const uint32_t> ids,
                       const IdMap& map, std::span<const RowPiece> pieces, Issues& issues) {
    RowLines later(deck, pieces), first(deck, pieces);
    const std::span<const uint32_t> duplicates = map.duplicates();
    const std::size_t listed = std::min(duplicates.size(), issue_limit);
    for (std::size_t i = 0; i < listed; ++i) {
        const uint32_t row = duplicates[i];
        issues.add({ReadIssue::Kind::duplicate_id,
                    later.line(row),
                    fmt::format("{} {}", name, ids[row]),
                    {},
                    first.line(map.row(ids[row])),
                    1});
    }
    issues.count(ReadIssue::Kind::duplicate_id, duplicates.size() - listed);
}

void read_nodes(const Context& context, Plan& plan, unsigned threads, NodeTable& table) {
    const std::size_t room = room_of(plan, Target::nodes);
    table.id = Buffer<uint32_t>(room);
    table.x = Buffer<Vec3>(room);
    parallel_for(threads, plan.pieces.size(), [&](std::size_t i) {
        Piece& piece = plan.pieces[i];
        if (plan.target(piece) == Target::nodes && plan.parses(piece))
            read_node_piece(context, plan.sources[piece.source], piece, table);
    });
    close_gaps(plan, Target::nodes, table.id);
    close_gaps(plan, Target::nodes, table.x);
    place_rows(plan, Target::nodes, table.pieces);
    table.map = IdMap(table.id.span(), threads);
    report_duplicates(context.deck, "node", table.id.span(), table.map, table.pieces, plan.issues[0]);
}

/// The columns of a table, from the first row of a piece on.
ElementRows rows_at(ShellTable& table, std::size_t place) {
    ElementRows rows;
    rows.id = table.id.data() + place;
    if (!table.nodes.empty()) rows.shell = table.nodes.data() + place;
    return rows;
}
ElementRows rows_at(SolidTable& table, std::size_t place) {
    ElementRows rows;
    rows.id = table.id.data() + place;
    rows.kind = table.kind.data() + place;
    if (!table.nodes.empty()) rows.solid = table.nodes.data() + place;
    if (!table.mid.empty()) rows.mid = table.mid.data() + place;
    return rows;
}

template <class Table>
void make_columns(const Plan& plan, Target target, bool connectivity, Table& table) {
    const std::size_t room = room_of(plan, target);
    table.id = Buffer<uint32_t>(room);
    if (connectivity) table.nodes = decltype(table.nodes)(room);
    if constexpr (std::is_same_v<Table, SolidTable>) {
        table.kind = Buffer<SolidKind>(room);
        const bool tetra10 = std::any_of(plan.sources.begin(), plan.sources.end(), [](const Source& source) {
            return source.parse && source.form->target == Target::solids &&
                   source.form->solid == SolidKind::tetra10;
        });
        if (connectivity && tetra10) table.mid = decltype(table.mid)(room);
    }
}

template <class Table>
void finish_table(const Context& context, Plan& plan, Target target, unsigned threads, Table& table) {
    close_gaps(plan, target, table.id);
    close_gaps(plan, target, table.nodes);
    if constexpr (std::is_same_v<Table, SolidTable>) {
        close_gaps(plan, target, table.kind);
        close_gaps(plan, target, table.mid);
    }
    place_rows(plan, target, table.pieces);
    table.ranges = ranges_of(plan, target);
    if constexpr (std::is_same_v<Table, ShellTable>) {
        std::size_t given = 0;
        for (const Piece& piece : plan.pieces)
            if (plan.target(piece) == target) given += piece.thickness.size();
        table.thickness.reserve(given);
        for (Piece& piece : plan.pieces) {
            if (plan.target(piece) != target) continue;
            for (const auto& [row, thickness] : piece.thickness)
                table.thickness.emplace_back(row + static_cast<uint32_t>(piece.place), thickness);
            piece.thickness = {};
        }
    }
    if (!context.request.element_ids) return;
    table.map = IdMap(table.id.span(), threads);
    const std::string_view name = target == Target::shells4   ? "shell"
                                  : target == Target::shells3 ? "sh3n"
                                                              : "solid";
    report_duplicates(context.deck, name, table.id.span(), table.map, table.pieces,
                      plan.issues[static_cast<std::size_t>(target)]);
}

void read_elements(const Context& context, Plan& plan, unsigned threads, Tables& tables) {
    const bool connectivity = context.request.coordinates;
    make_columns(plan, Target::shells4, connectivity, tables.shells4);
    make_columns(plan, Target::shells3, connectivity, tables.shells3);
    make_columns(plan, Target::solids, connectivity, tables.solids);
    parallel_for(threads, plan.pieces.size(), [&](std::size_t i) {
        Piece& piece = plan.pieces[i];
        if (!plan.parses(piece)) {
            piece.lines = count_data_lines(context.deck.text(piece.text));
            return;
        }
        ElementRows rows;
        switch (plan.target(piece)) {
        case Target::nodes:
            return;
        case Target::shells4:
            rows = rows_at(tables.shells4, piece.place);
            break;
        case Target::shells3:
            rows = rows_at(tables.shells3, piece.place);
            break;
        case Target::solids:
            rows = rows_at(tables.solids, piece.place);
            break;
        }
        ElementReader(context, plan.sources[piece.source], piece, rows).read();
    });
    finish_table(context, plan, Target::shells4, threads, tables.shells4);
    finish_table(context, plan, Target::shells3, threads, tables.shells3);
    finish_table(context, plan, Target::solids, threads, tables.solids);
}

void add_counts(Plan& plan, Counts& counts) {
    for (const Piece& piece : plan.pieces)
        plan.sources[piece.source].lines += piece.lines;
    for (const Source& source : plan.sources) {
        const uint64_t rows = (source.lines + source.form->lines_per_row - 1) / source.form->lines_per_row;
        switch (source.form->target) {
        case Target::nodes:
            counts.nodes += rows;
            break;
        case Target::shells4:
            counts.shells4 += rows;
            break;
        case Target::shells3:
            counts.shells3 += rows;
            break;
        case Target::solids:
            counts.solids += rows;
            break;
        }
    }
}

} // namespace

Tables read_tables(const Deck& deck, const TableRequest& request, unsigned threads) {
    Tables tables;
    Plan plan = plan_of(deck, request, tables.counts);
    const Context context{deck, request, tables.nodes};
    make_room(deck, plan, threads);
    if (request.coordinates) read_nodes(context, plan, threads, tables.nodes);
    read_elements(context, plan, threads, tables);
    add_counts(plan, tables.counts);
    for (Issues& issues : plan.issues)
        issues.write_to(tables.issues);
    return tables;
}

} // namespace drawbead
