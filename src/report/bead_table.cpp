#include "report/bead_table.h"

#include "report/json.h"
#include "report/table.h"
#include "report/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

namespace drawbead {

namespace {

using Layout = JsonWriter::Layout;

enum class Unit : uint8_t { none, length, force_per_length, slope, manual_slope };

struct Column {
    std::string_view name;
    Unit unit = Unit::none;
};

/// The order is part of what users rely on: columns are only ever added behind the last.
constexpr Column columns[]{
    {"interface"},
    {"index"},
    {"node"},
    {"s", Unit::length},
    {"tributary", Unit::length},
    {"fn_limit", Unit::force_per_length},
    {"ft_limit", Unit::force_per_length},
    {"n1"},
    {"n2"},
    {"n3"},
    {"n4"},
    {"xi"},
    {"eta"},
    {"inside"},
    {"distance", Unit::length},
    {"half_thickness", Unit::length},
    {"penetration", Unit::length},
    {"stiffness", Unit::force_per_length},
    {"slope", Unit::slope},
    {"slope_read", Unit::slope},
    {"reset"},
    {"closest_n1"},
    {"closest_n2"},
    {"closest_n3"},
    {"closest_n4"},
    {"closest_distance", Unit::length},
    {"manual_slope", Unit::manual_slope},
    {"manual_reset"},
};
constexpr std::size_t column_count = std::size(columns);

/// Hands the cells of a row to `out` in the order of the columns: whole(int64_t), real(double), flag(bool) or
/// empty().
template <class Out>
void each_cell(const BeadTable& bead, std::size_t i, Out& out) {
    const BeadTableRow& row = bead.rows[i];
    const auto ids = [&](const std::array<int64_t, 4>& n) {
        for (const int64_t id : n)
            out.whole(id);
    };
    out.whole(bead.interface_id);
    out.whole(static_cast<int64_t>(i) + 1);
    out.whole(row.node);
    out.real(row.s);
    out.real(row.tributary);
    out.real(row.fn_limit);
    out.real(row.ft_limit);
    constexpr std::size_t so_far = 7;
    if (!row.met) {
        for (std::size_t k = so_far; k < column_count; ++k)
            out.empty();
        return;
    }
    ids(row.n);
    out.real(row.xi);
    out.real(row.eta);
    out.flag(row.inside);
    out.real(row.distance);
    out.real(row.half_thickness);
    out.real(row.penetration);
    out.real(row.stiffness);
    out.real(row.slope);
    if (row.slope_read)
        out.real(*row.slope_read);
    else
        out.empty();
    out.flag(row.reset);
    ids(row.closest_n);
    out.real(row.closest_distance);
    out.real(row.manual_slope);
    out.flag(row.manual_reset);
}

/// The shortest digits that read back as the same number, or `precision` significant ones.
void append_number(std::string& text, double number, int precision = 0) {
    char digits[32];
    const auto end = precision > 0 ? std::to_chars(digits, digits + sizeof digits, number,
                                                   std::chars_format::general, precision)
                                   : std::to_chars(digits, digits + sizeof digits, number);
    text.append(digits, end.ptr);
}

void append_whole(std::string& text, int64_t number) {
    char digits[24];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

constexpr int text_digits = 6;

std::string number_text(double number) {
    std::string text;
    append_number(text, number + 0.0, text_digits); // no "-0"
    return text;
}

std::string quantity_text(double number, const std::string& unit) {
    return number_text(number) + (unit.empty() ? "" : " " + terminal_safe(unit));
}

struct CsvCells {
    std::string line;

    void whole(int64_t number) { append_whole(next(), number); }
    void real(double number) {
        if (std::isfinite(number))
            append_number(next(), number);
        else
            next();
    }
    void flag(bool truth) { next() += truth ? '1' : '0'; }
    void empty() { next(); }

private:
    std::string& next() {
        if (first_)
            first_ = false;
        else
            line += ',';
        return line;
    }
    bool first_ = true;
};

struct JsonCells {
    JsonWriter& json;
    std::size_t column = 0;

    void whole(int64_t number) { json.member(columns[column++].name, number); }
    void real(double number) { json.member(columns[column++].name, number); }
    void flag(bool truth) { json.member(columns[column++].name, truth); }
    void empty() {
        json.key(columns[column++].name);
        json.null();
    }
};

/// Cells of all rows of a bead one behind the other: a table of many rows is no place for many strings.
struct TextCells {
    std::string text;
    std::vector<std::size_t> end; ///< of each cell in `text`
    std::array<std::size_t, column_count> width{};

    void whole(int64_t number) {
        append_whole(text, number);
        done();
    }
    void real(double number) {
        append_number(text, number + 0.0, text_digits);
        done();
    }
    void flag(bool truth) {
        text += truth ? "yes" : "no";
        done();
    }
    void empty() {
        text += '-';
        done();
    }
    void word(std::string_view one) {
        text += one;
        done();
    }

private:
    void done() {
        const std::size_t begin = end.empty() ? 0 : end.back();
        std::size_t& most = width[end.size() % column_count];
        most = std::max(most, text.size() - begin);
        end.push_back(text.size());
    }
};

void write_cells(OutputSink& out, const TextCells& cells) {
    const std::string blanks(2 + *std::max_element(cells.width.begin(), cells.width.end()), ' ');
    std::size_t begin = 0;
    for (std::size_t c = 0; c < cells.end.size(); ++c) {
        const std::size_t size = cells.end[c] - begin, column = c % column_count;
        const std::size_t before = cells.width[column] - size + (column == 0 ? 0 : 2);
        out.write(std::string_view(blanks).substr(0, before));
        out.write(std::string_view(cells.text).substr(begin, size));
        if (column + 1 == column_count) out.write('\n');
        begin = cells.end[c];
    }
}

/// ASCII, so that a byte is a column.
std::string bead_unit(const DeckTable& table, const BeadTable& bead, Unit unit) {
    switch (unit) {
    case Unit::length:
        return table.length_unit;
    case Unit::force_per_length:
        return table.force_per_length_unit;
    case Unit::slope:
        return bead.slope_unit;
    case Unit::manual_slope:
        return bead.manual_slope_unit;
    case Unit::none:
        break;
    }
    return {};
}

std::string title_of(const BeadTable& bead) {
    std::string text = "/INTER/TYPE8/" + std::to_string(bead.interface_id);
    if (!bead.title.empty()) text += " " + terminal_safe(bead.title);
    return text;
}

/// "50 % (4 of 8)"
std::string share_text(uint64_t part, uint64_t whole) {
    if (whole == 0) return "-";
    const double percent = 100 * static_cast<double>(part) / static_cast<double>(whole);
    return number_text(std::round(percent * 10) / 10) + " % (" + std::to_string(part) + " of " +
           std::to_string(whole) + ")";
}

std::string per_length_text(double force, double length, const std::string& unit) {
    return length > 0 ? quantity_text(force / length, unit) : "-";
}

std::string tool_name(const ToolTotals& tool) {
    return tool.rigid_body ? "rigid body " + std::to_string(*tool.rigid_body) : "no rigid body";
}

void write_totals_text(OutputSink& out, const DeckTable& table) {
    std::vector<std::vector<std::string>> rows{{"bead", "length", "sum Fn*L", "sum Ft*L", "Fn*L/length",
                                                "Ft*L/length", "over the blank", "not the closest segment",
                                                "largest difference of distance"}};
    for (const BeadTable& bead : table.beads) {
        const BeadTotals& t = bead.totals;
        std::vector<std::string> row{std::to_string(bead.interface_id),
                                     quantity_text(t.length, table.length_unit),
                                     quantity_text(t.force.fn, table.force_unit),
                                     quantity_text(t.force.ft, table.force_unit),
                                     per_length_text(t.force.fn, t.length, table.force_per_length_unit),
                                     per_length_text(t.force.ft, t.length, table.force_per_length_unit),
                                     "-",
                                     "-",
                                     "-"};
        if (bead.on_surface()) {
            row[6] = share_text(t.inside, t.force.nodes);
            row[7] = share_text(t.different_segments, t.force.nodes);
            row[8] = quantity_text(t.largest_difference, table.length_unit);
            if (t.largest_difference > 0) row[8] += " at node " + std::to_string(t.largest_difference_node);
        }
        rows.push_back(std::move(row));
    }
    out.write("totals\n");
    out.write(text_table(rows, {0, 1, 2, 3, 4, 5, 6, 7}, 2));

    std::vector<std::vector<std::string>> tools{{"tool", "beads", "nodes", "sum Fn*L", "sum Ft*L"}};
    for (const ToolTotals& tool : table.tools)
        tools.push_back({tool_name(tool), std::to_string(tool.interfaces.size()),
                         std::to_string(tool.force.nodes), quantity_text(tool.force.fn, table.force_unit),
                         quantity_text(tool.force.ft, table.force_unit)});
    tools.push_back({"all", std::to_string(table.beads.size()), std::to_string(table.force.nodes),
                     quantity_text(table.force.fn, table.force_unit),
                     quantity_text(table.force.ft, table.force_unit)});
    out.write("\n");
    out.write(text_table(tools, {1, 2, 3, 4}, 2));
}

void write_forces(JsonWriter& json, const BeadForces& force) {
    json.member("nodes", force.nodes);
    json.member("fn", force.fn);
    json.member("ft", force.ft);
}

void optional_number(JsonWriter& json, std::string_view name, bool known, double number) {
    json.key(name);
    if (known)
        json.value(number);
    else
        json.null();
}

void write_totals_json(JsonWriter& json, const DeckTable& table) {
    json.begin_object();
    json.key("beads");
    json.begin_array();
    for (const BeadTable& bead : table.beads) {
        const BeadTotals& t = bead.totals;
        const bool known = bead.on_surface();
        json.begin_object();
        json.member("interface", bead.interface_id);
        json.member("title", bead.title);
        json.member("unknown", bead.unknown);
        json.member("length", t.length);
        write_forces(json, t.force);
        optional_number(json, "fn_per_length", t.length > 0, t.force.fn / t.length);
        optional_number(json, "ft_per_length", t.length > 0, t.force.ft / t.length);
        json.member("inside", t.inside);
        optional_number(json, "inside_share", known,
                        static_cast<double>(t.inside) / static_cast<double>(t.force.nodes));
        json.member("different_segments", t.different_segments);
        optional_number(json, "largest_difference", known, t.largest_difference);
        json.key("largest_difference_node");
        if (known)
            json.value(t.largest_difference_node);
        else
            json.null();
        json.end();
    }
    json.end();
    json.key("tools");
    json.begin_array();
    for (const ToolTotals& tool : table.tools) {
        json.begin_object(Layout::line);
        json.key("rigid_body");
        if (tool.rigid_body)
            json.value(*tool.rigid_body);
        else
            json.null();
        json.member_list("interfaces", tool.interfaces);
        write_forces(json, tool.force);
        json.end();
    }
    json.end();
    json.key("deck");
    json.begin_object(Layout::line);
    json.member("beads", table.beads.size());
    json.member("length", table.length);
    write_forces(json, table.force);
    json.end();
    json.end();
}

} // namespace

void write_table_text(OutputSink& out, const DeckTable& table) {
    if (table.beads.empty()) {
        out.write("no /INTER/TYPE8\n");
        return;
    }
    for (const BeadTable& bead : table.beads) {
        out.write(title_of(bead) + '\n');
        TextCells cells;
        for (const Column& column : columns)
            cells.word(column.name);
        for (const Column& column : columns)
            cells.word(terminal_safe(bead_unit(table, bead, column.unit)));
        for (std::size_t i = 0; i < bead.rows.size(); ++i)
            each_cell(bead, i, cells);
        write_cells(out, cells);
        out.write('\n');
    }
    write_totals_text(out, table);
}

void write_table_csv(OutputSink& out, const DeckTable& table) {
    std::string head;
    for (const Column& column : columns)
        head.append(head.empty() ? "" : ",").append(column.name);
    out.write(head + '\n');
    for (const BeadTable& bead : table.beads)
        for (std::size_t i = 0; i < bead.rows.size(); ++i) {
            CsvCells cells;
            cells.line.reserve(512);
            each_cell(bead, i, cells);
            out.write(cells.line += '\n');
        }
}

void write_table_json(OutputSink& out, const DeckTable& table, std::string_view tool_version) {
    JsonWriter json(out);
    json.begin_object();
    json.member("tool", "drawbead");
    json.member("version", tool_version);
    json.member("schema", 1);
    json.member("path", table.path);
    json.key("units");
    json.begin_object(Layout::line);
    json.member("length", table.length_unit);
    json.member("force", table.force_unit);
    json.member("force_per_length", table.force_per_length_unit);
    json.end();
    json.key("warnings");
    json.begin_array();
    for (const std::string& warning : table.warnings)
        json.value(warning);
    json.end();
    json.key("rows");
    json.begin_array();
    for (const BeadTable& bead : table.beads)
        for (std::size_t i = 0; i < bead.rows.size(); ++i) {
            json.begin_object(Layout::line);
            JsonCells cells{json};
            each_cell(bead, i, cells);
            json.end();
        }
    json.end();
    json.key("totals");
    write_totals_json(json, table);
    json.end();
}

} // namespace drawbead
