#include "model/line_kernels.h"
#include "model/table_reader.h"

#include <bit>
#include <catch2/catch.hpp>
#include <random>
#include <string>

using namespace drawbead;

namespace {

std::string begin_of(int version, const std::string& length = "mm") {
    const std::string number = std::to_string(version);
    const std::string cells(20 - length.size(), ' ');
    return "#RADIOSS STARTER\n/BEGIN\nrun\n" + std::string(10 - number.size(), ' ') + number +
           "         0\n" + "                  Mg" + cells + length + "                   s\n" +
           "                  Mg                  mm                   s\n";
}
const std::string begin = begin_of(2022);

Deck deck_of(const std::string& text, MemoryReader reader = {}) {
    reader.add("main_0000.rad", text);
    auto deck = Deck::read("main_0000.rad", reader);
    REQUIRE(deck);
    return std::move(*deck);
}

TableRequest everything() {
    TableRequest request;
    request.counts = request.coordinates = request.thickness = request.element_ids = true;
    request.elements = TableRequest::Elements::all;
    return request;
}

std::string right(const std::string& text, std::size_t width) {
    return std::string(text.size() < width ? width - text.size() : 0, ' ') + text;
}
std::string ids(std::initializer_list<int64_t> values) {
    std::string line;
    for (const int64_t v : values)
        line += right(std::to_string(v), 10);
    return line;
}
std::string node(int64_t id, const std::string& x = "0.", const std::string& y = "0.",
                 const std::string& z = "0.") {
    return ids({id}) + right(x, 20) + right(y, 20) + right(z, 20) + "\n";
}
std::string nodes_to(int64_t last) {
    std::string text = "/NODE\n";
    for (int64_t id = 1; id <= last; ++id)
        text += node(id, std::to_string(id) + ".5");
    return text;
}

std::vector<uint32_t> list(const Buffer<uint32_t>& buffer) {
    return {buffer.begin(), buffer.end()};
}

std::size_t count(const Tables& tables, ReadIssue::Kind kind) {
    std::size_t found = 0;
    for (const ReadIssue& issue : tables.issues)
        if (issue.kind == kind) found += issue.count;
    return found;
}
const ReadIssue& first(const Tables& tables, ReadIssue::Kind kind) {
    for (const ReadIssue& issue : tables.issues)
        if (issue.kind == kind) return issue;
    FAIL("no such issue");
    return tables.issues.front();
}

std::vector<int64_t> corners(const Tables& tables, std::span<const NodeRow> rows) {
    std::vector<int64_t> found;
    for (const NodeRow row : rows)
        found.push_back(row == no_node ? int64_t{-1} : value(tables.nodes.user_id(row)));
    return found;
}

} // namespace

TEST_CASE("nodes are read in deck order, in work units, with their places") {
    const Deck deck = deck_of(begin_of(2022, "m") + "/NODE\n#---1----|\n" + node(7, "1.5", "-2.", "1.E-3") +
                              "\n# middle\n" + node(3, "0.25", "1.D2", "") + "# end\n/PART/1\np\n/CNODE\n" +
                              node(9) + "/END\n");
    const Tables tables = read_tables(deck, everything(), 2);
    CHECK(list(tables.nodes.id) == std::vector<uint32_t>{7, 3, 9});
    CHECK(tables.nodes[NodeRow{0}] == Vec3{1500, -2000, 1});
    CHECK(tables.nodes[NodeRow{1}] == Vec3{250, 100000, 0});
    CHECK(tables.nodes.row(NodeId{3}) == NodeRow{1});
    CHECK_FALSE(tables.nodes.row(NodeId{4}));
    CHECK(tables.issues.empty());
    CHECK(tables.counts.nodes == 3);
    CHECK(tables.counts.parts == 1);
    CHECK(deck.at(row_line(deck, tables.nodes.pieces, 0)).line == 9);
    CHECK(deck.at(row_line(deck, tables.nodes.pieces, 1)).line == 12);
    CHECK(deck.at(row_line(deck, tables.nodes.pieces, 2)).line == 17);
    CHECK(deck.text(row_line(deck, tables.nodes.pieces, 1)).substr(0, 10) == "         3");
}

TEST_CASE("a node line that no kernel takes is read exactly") {
    struct Case {
        std::string line;
        Vec3 x;
    };
    for (const Case& c : {
             Case{"         5               1.5-3               2.D+1                +3.0", {1.5e-3, 20, 3}},
             Case{"5, 1.5, -2.5E0, 3", {1.5, -2.5, 3}},
             Case{"5,,2", {0, 2, 0}},
             Case{"         5             &length            -&length                    ", {2.5, -2.5, 0}},
             Case{"    &count                 1.0", {1, 0, 0}},
             Case{"\t 5                        1.0                 2.0                 3.0", {0.0, 0, 0}},
             Case{"       5.3                 1.0                 2.0                 3.0   trailing text",
                  {1, 2, 3}},
             Case{"     5 6 7                 1.0                 2.0                 3.0", {1, 2, 3}},
             Case{"         5               1.0E                  .5                  3.", {1, 0.5, 3}},
             Case{"         5               1   2                 2.0                 3.0\r", {1, 2, 3}},
         }) {
        if (c.line[0] == '\t') continue;
        const Deck deck = deck_of(begin + "/PARAMETER/GLOBAL/REAL/1\nlength\nlength                   2.5\n" +
                                  "/PARAMETER/GLOBAL/INTEGER/2\ncount\ncount              5\n/NODE\n" +
                                  node(4) + c.line + "\n" + node(6) + "/END\n");
        const Tables tables = read_tables(deck, everything(), 1);
        INFO(c.line);
        REQUIRE(list(tables.nodes.id) == std::vector<uint32_t>{4, 5, 6});
        CHECK(tables.nodes[NodeRow{1}] == c.x);
        CHECK(tables.issues.empty());
    }
}

TEST_CASE("rows without a usable id are left out and reported, and places stay right") {
    const Deck deck =
        deck_of(begin + "/NODE\n" + node(1) + node(0) + node(2) + "     #   5\n" + node(-3) +
                node(2147483648) + node(3) + "       abc                 1.0\n" + node(4) + "/END\n");
    const Tables tables = read_tables(deck, everything(), 1);
    CHECK(list(tables.nodes.id) == std::vector<uint32_t>{1, 2, 3, 4});
    CHECK(tables.counts.nodes == 9);
    CHECK(count(tables, ReadIssue::Kind::id_missing) == 2);
    CHECK(count(tables, ReadIssue::Kind::id_overflow) == 1);
    CHECK(count(tables, ReadIssue::Kind::not_a_number) == 2);
    const uint64_t first_line = deck.at(row_line(deck, tables.nodes.pieces, 0)).line;
    for (const auto& [row, line] : {std::pair{1u, 2u}, {2u, 6u}, {3u, 8u}})
        CHECK(deck.at(row_line(deck, tables.nodes.pieces, row)).line == first_line + line);
    CHECK(deck.at(first(tables, ReadIssue::Kind::id_missing).place).line == first_line + 1);
}

TEST_CASE("cells that are no numbers are 0 and reported with their place") {
    const Deck deck = deck_of(begin + "/NODE\n" + node(1, "x1.0", "nan", "&none") +
                              node(2, "1.", "2.", "1e999") + "/END\n");
    const Tables tables = read_tables(deck, everything(), 1);
    CHECK(tables.nodes[NodeRow{0}] == Vec3{});
    CHECK(tables.nodes[NodeRow{1}] == Vec3{1, 2, 0});
    const ReadIssue& garbage = first(tables, ReadIssue::Kind::not_a_number);
    CHECK(garbage.subject == "node 1 x");
    CHECK(garbage.detail == "x1.0");
    CHECK(deck.text(garbage.place) == "x1.0");
    CHECK(count(tables, ReadIssue::Kind::not_finite) == 2);
    CHECK(first(tables, ReadIssue::Kind::unknown_parameter).detail == "&none");
}

TEST_CASE("duplicate node ids are reported with both places, at most 100 of them") {
    const Deck deck = deck_of(begin + nodes_to(500) + nodes_to(300) + "/END\n");
    const Tables tables = read_tables(deck, everything(), 1);
    CHECK(tables.nodes.size() == 800);
    CHECK(tables.nodes.row(NodeId{300}) == NodeRow{299});
    REQUIRE(tables.issues.size() == issue_limit);
    CHECK(count(tables, ReadIssue::Kind::duplicate_id) == 300);
    CHECK(tables.issues[1].subject == "node 2");
    CHECK(deck.text(tables.issues[1].place) == deck.text(tables.issues[1].related));
    CHECK(deck.at(tables.issues[1].place).line == deck.at(tables.issues[1].related).line + 501);
    CHECK(tables.issues.back().count == 201);
}

TEST_CASE("shells know their nodes, parts and thickness") {
    const Deck deck =
        deck_of(begin + nodes_to(8) + "/SHELL/12\n" + ids({101, 1, 2, 3, 4}) + "\n" + ids({105, 5, 6, 7, 8}) +
                right("", 10) + right("", 20) + right("1.25", 20) + "\n/SH3N/4\n#\n" + ids({7, 3, 2, 1}) +
                "\n" + ids({8, 4, 5, 6}) + right("", 20) + right("0.", 20) + right("2D0", 20) +
                "\r\n/SHELL/13\n" + ids({102, 1, 2, 6, 5}) + right("", 10) + "                 0.5\n/END\n");
    const Tables tables = read_tables(deck, everything(), 2);
    CHECK(tables.issues.empty());
    CHECK(list(tables.shells4.id) == std::vector<uint32_t>{101, 105, 102});
    CHECK(list(tables.shells3.id) == std::vector<uint32_t>{7, 8});
    CHECK(corners(tables, tables.shells4.nodes[1]) == std::vector<int64_t>{5, 6, 7, 8});
    CHECK(corners(tables, tables.shells3.nodes[0]) == std::vector<int64_t>{3, 2, 1, 1});
    CHECK(tables.shells4.part(0) == 12);
    CHECK(tables.shells4.part(1) == 12);
    CHECK(tables.shells4.part(2) == 13);
    CHECK(tables.shells3.part(1) == 4);
    CHECK(tables.shells4.own_thickness(0) == 0);
    CHECK(tables.shells4.own_thickness(1) == 1.25);
    CHECK(tables.shells4.own_thickness(2) == 0);
    CHECK(tables.shells3.own_thickness(1) == 2);
    CHECK(tables.shells4.map.row(102) == 2);
    CHECK(deck.text(row_line(deck, tables.shells4.pieces, 2)).substr(0, 10) == "       102");
    CHECK(tables.counts.shells4 == 3);
    CHECK(tables.counts.shells3 == 2);
}

TEST_CASE("nodes of elements that do not exist are reported at their cell") {
    const Deck deck =
        deck_of(begin + nodes_to(4) + "/SHELL/1\n" + ids({1, 1, 2, 3, 4}) + "\n" + ids({2, 1, 2, 33, 0}) +
                "\n" + ids({3, 1, 2, -3, 4}) + "\n/SH3N/1\n3, 1, 2, 44\n/END\n");
    const Tables tables = read_tables(deck, everything(), 1);
    CHECK(corners(tables, tables.shells4.nodes[1]) == std::vector<int64_t>{1, 2, -1, -1});
    CHECK(corners(tables, tables.shells4.nodes[2]) == std::vector<int64_t>{1, 2, -1, 4});
    CHECK(count(tables, ReadIssue::Kind::unknown_node) == 4);
    const ReadIssue& issue = first(tables, ReadIssue::Kind::unknown_node);
    CHECK(issue.subject == "shell 2");
    CHECK(issue.detail == "node 33");
    CHECK(deck.text(issue.place) == "33");
    CHECK(tables.issues.back().subject == "sh3n 3");
    CHECK(deck.text(tables.issues.back().place) == "44");
}

TEST_CASE("when a node table is missing, the first elements are listed and the rest is counted") {
    std::string text = begin + nodes_to(2) + "/SHELL/1\n";
    for (int64_t id = 1; id <= 1000; ++id)
        text += ids({id, 1, 2, 3, 4}) + "\n";
    const Deck deck = deck_of(text + "/END\n");
    const Tables tables = read_tables(deck, everything(), 1);
    REQUIRE(tables.issues.size() == issue_limit);
    CHECK(count(tables, ReadIssue::Kind::unknown_node) == 2000);
    CHECK(tables.issues[99].subject == "shell 50");
    CHECK(tables.issues[99].count == 1901);
}

TEST_CASE("solids of all kinds") {
    const Deck deck =
        deck_of(begin + nodes_to(20) + "/BRICK/1\n" + ids({1, 1, 2, 3, 4, 5, 6, 7, 8}) + "\n/TETRA4/2\n" +
                ids({2, 1, 2, 3, 4}) + "\n/PENTA6/3\n" + ids({3, 1, 2, 3, 4, 5, 6}) + "\n/TETRA10/4\n" +
                ids({4}) + "\n" + ids({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}) + "\n# comment\n" + ids({5}) + "\n\n" +
                ids({4, 3, 2, 1, 0, 0, 0, 0, 0, 0}) + "\n/BRIC20/5\n" + ids({6, 1, 2, 3, 4, 5, 6, 7, 8}) +
                "\n" + ids({9, 10, 11, 12, 13, 14, 15, 16}) + "\n" + ids({17, 18, 19, 20}) + "\n/SHEL16/6\n" +
                ids({7, 8, 7, 6, 5, 4, 3, 2, 1}) + "\n" + ids({9, 10, 11, 12}) + "\n" +
                ids({13, 14, 15, 16}) + "\n" + ids({8, 1, 2, 3, 4, 5, 6, 7, 8}) + "\n" +
                ids({9, 10, 11, 12}) + "\n" + ids({13, 14, 15, 16}) + "\n/END\n");
    const Tables tables = read_tables(deck, everything(), 3);
    CHECK(tables.issues.empty());
    CHECK(list(tables.solids.id) == std::vector<uint32_t>{1, 2, 3, 4, 5, 6, 7, 8});
    CHECK(tables.counts.solids == 8);
    CHECK(corners(tables, tables.solids.nodes[0]) == std::vector<int64_t>{1, 2, 3, 4, 5, 6, 7, 8});
    CHECK(corners(tables, tables.solids.nodes[1]) == std::vector<int64_t>{1, 2, 3, 4, -1, -1, -1, -1});
    CHECK(corners(tables, tables.solids.nodes[2]) == std::vector<int64_t>{1, 2, 3, 4, 5, 6, -1, -1});
    CHECK(corners(tables, tables.solids.nodes[4]) == std::vector<int64_t>{4, 3, 2, 1, -1, -1, -1, -1});
    CHECK(corners(tables, tables.solids.nodes[6]) == std::vector<int64_t>{8, 7, 6, 5, 4, 3, 2, 1});
    REQUIRE(tables.solids.mid.size() == 8);
    CHECK(corners(tables, tables.solids.mid[3]) == std::vector<int64_t>{5, 6, 7, 8, 9, 10});
    CHECK(corners(tables, tables.solids.mid[4]) == std::vector<int64_t>{-1, -1, -1, -1, -1, -1});
    CHECK(tables.solids.kind[3] == SolidKind::tetra10);
    CHECK(tables.solids.kind[7] == SolidKind::shel16);
    CHECK(tables.solids.part(4) == 4);
    CHECK(tables.solids.part(7) == 6);
    CHECK(deck.text(row_line(deck, tables.solids.pieces, 4)) == ids({5}));
    CHECK(deck.text(row_line(deck, tables.solids.pieces, 7)).substr(0, 10) == "         8");
}

TEST_CASE("offsets of a submodel, and an include in the middle of a table") {
    MemoryReader reader;
    reader.add("more.inc", "/NODE\n" + node(50));
    const Deck deck = deck_of(begin + "/NODE\n" + node(1) + "#include more.&\n inc\n" + node(2) +
                                  "//SUBMODEL/1\nsub\n" + ids({100, 200, 300, 400}) + "\n/NODE\n" + node(1) +
                                  node(2) + node(3) + "/SH3N/7\n" + ids({5, 1, 2, 3}) + "\n//ENDSUB\n/END\n",
                              reader);
    const Tables tables = read_tables(deck, everything(), 1);
    CHECK(tables.issues.empty());
    CHECK(tables.nodes.size() == 6);
    CHECK(tables.nodes.row(NodeId{50}));
    CHECK(tables.nodes.row(NodeId{202}));
    REQUIRE(tables.shells3.size() == 1);
    CHECK(tables.shells3.id[0] == 305);
    CHECK(tables.shells3.part(0) == 407);
    CHECK(corners(tables, tables.shells3.nodes[0]) == std::vector<int64_t>{201, 202, 203, 203});
    for (uint32_t row = 0; row < tables.nodes.size(); ++row) {
        const std::string_view line = deck.text(row_line(deck, tables.nodes.pieces, row));
        CHECK(parse_integer(columns(line, 0, 10)).value % 100 == tables.nodes.id[row] % 100);
    }
}

TEST_CASE("unit ids of tables") {
    const std::string unit =
        "/UNIT/3\nmetres\n                  Mg                   m                   s\n";
    const Deck deck =
        deck_of(begin + unit + "/NODE/3\n" + node(1, "2.") + "/NODE/4\n" + node(2, "2.") + "/SHELL/1/3\n" +
                ids({1, 1, 2, 1, 2}) + right("", 10) + right("", 20) + right("0.002", 20) + "\n/END\n");
    const Tables tables = read_tables(deck, everything(), 1);
    CHECK(tables.nodes[NodeRow{0}].x == 2000);
    CHECK(tables.nodes[NodeRow{1}].x == 2);
    CHECK(tables.shells4.own_thickness(0) == Approx(2).epsilon(1e-15));
    REQUIRE(tables.issues.size() == 1);
    CHECK(tables.issues[0].kind == ReadIssue::Kind::unknown_unit);
    CHECK(tables.issues[0].subject == "unit 4");
    CHECK(deck.text(tables.issues[0].place) == "/NODE/4");
}

TEST_CASE("old layouts have narrow columns") {
    const Deck deck = deck_of("#RADIOSS STARTER\n/BEGIN\nrun\n      44       0\n/NODE\n       1             "
                              "1.5             2.5             3.5\n"
                              "       2             1.5\n/SHELL/1\n       1       1       2       1       2  "
                              "                          "
                              "        0.75\n/END\n");
    TableRequest request = everything();
    const Tables tables = read_tables(deck, request, 1);
    REQUIRE(tables.nodes.size() == 2);
    CHECK(tables.nodes[NodeRow{0}].z == 3.5);
    REQUIRE(tables.shells4.size() == 1);
    CHECK(tables.shells4.own_thickness(0) == 0.75);
}

TEST_CASE("only what is asked for is read") {
    const Deck deck = deck_of(begin + nodes_to(4) + "/SHELL/1\n" + ids({1, 1, 2, 3, 4}) + "\n/SHELL/2\n" +
                              ids({2, 1, 2, 3, 4}) + "\n" + ids({1, 1, 2, 3, 4}) + "\n/BRICK/2\n" +
                              ids({1, 1, 2, 3, 4, 1, 2, 3, 4}) + "\n/END\n");
    TableRequest request;
    request.counts = true;
    Tables tables = read_tables(deck, request, 1);
    CHECK(tables.nodes.size() + tables.shells4.size() + tables.solids.size() == 0);
    CHECK(tables.counts.nodes == 4);
    CHECK(tables.counts.shells4 == 3);
    CHECK(tables.counts.solids == 1);

    request = {};
    request.coordinates = true;
    request.elements = TableRequest::Elements::of_parts;
    request.parts = {9, 2};
    request.solids = false;
    tables = read_tables(deck, request, 1);
    CHECK(list(tables.shells4.id) == std::vector<uint32_t>{2, 1});
    CHECK(tables.shells4.part(0) == 2);
    CHECK(tables.solids.size() == 0);
    CHECK(tables.counts.shells4 == 2);
    CHECK(tables.issues.empty());

    request = {};
    request.elements = TableRequest::Elements::all;
    request.element_ids = true;
    tables = read_tables(deck, request, 1);
    CHECK(list(tables.shells4.id) == std::vector<uint32_t>{1, 2, 1});
    CHECK(tables.shells4.nodes.empty());
    REQUIRE(tables.issues.size() == 1);
    CHECK(tables.issues[0].subject == "shell 1");
    CHECK(deck.at(tables.issues[0].related).line + 3 == deck.at(tables.issues[0].place).line);
}

TEST_CASE("tables at the very begin and end of files") {
    MemoryReader reader;
    reader.add("a.inc", "/NODE\n1");
    reader.add("b.inc", "/NODE\n" + node(2, "1.", "2.", "3."));
    reader.add("c.inc", "/NODE\n\n#\n");
    reader.add("d.inc", "/NODE");
    reader.add("e.inc", "/TETRA10/1\n" + ids({1}));
    const Deck deck = deck_of(
        begin + "#include a.inc\n#include b.inc\n#include c.inc\n#include d.inc\n#include e.inc\n/END\n",
        reader);
    const Tables tables = read_tables(deck, everything(), 1);
    CHECK(list(tables.nodes.id) == std::vector<uint32_t>{1, 2});
    CHECK(tables.nodes[NodeRow{1}] == Vec3{1, 2, 3});
    REQUIRE(tables.solids.size() == 1);
    CHECK(count(tables, ReadIssue::Kind::unknown_node) == 4);
    CHECK(tables.counts.nodes == 2);
    CHECK(tables.counts.solids == 1);
}

namespace {

/// A deck of several pieces: comments, blank lines and damaged lines are strewn in.
std::string long_deck(uint32_t rows) {
    std::mt19937 random(11);
    const auto strewn = [&](std::string& text, bool blank_ids) {
        switch (random() % 400) {
        case 0:
            text += "# comment\n";
            break;
        case 1:
            text += "   \n";
            break;
        case 2:
            text += "$\n\n";
            break;
        case 3:
            if (blank_ids) text += node(0);
            break;
        default:
            break;
        }
    };
    std::string text = begin + "/NODE\n#\n";
    for (uint32_t id = 1; id <= rows; ++id) {
        strewn(text, true);
        text += node(id * 7919 % 1000003, std::to_string(id * 0.37), std::to_string(-1.0 * id),
                     id % 50 ? "1.5E-3" : "1.5-3");
    }
    text += "/SHELL/1\n";
    for (uint32_t id = 1; id <= rows; ++id) {
        strewn(text, true);
        text += ids({id, id * 7919 % 1000003, (id * 7919 + 7919) % 1000003, 7919, 7919 * 2});
        text += id % 40 ? "\n" : right("", 30) + right("0.8", 20) + "\n";
    }
    text += "/TETRA10/2\n";
    for (uint32_t id = 1; id <= rows; ++id) {
        strewn(text, false);
        text += ids({id}) + "\n";
        strewn(text, false);
        text += ids({7919, 7919 * 2, 7919 * 3, id * 7919 % 1000003, 0, 0, 0, 0, 0, 0}) + "\n";
    }
    return text + "/END\n";
}

} // namespace

TEST_CASE("rows do not depend on the threads, and agree with a plain reader of lines") {
    constexpr uint32_t rows = 130000; // 9 MB of nodes
    const Deck deck = deck_of(long_deck(rows));
    const Tables one = read_tables(deck, everything(), 1);
    const Tables three = read_tables(deck, everything(), 3);
    CHECK(one.nodes.size() == rows);
    CHECK(one.solids.size() == rows);
    CHECK(list(one.nodes.id) == list(three.nodes.id));
    CHECK(list(one.solids.id) == list(three.solids.id));
    CHECK(one.shells4.thickness == three.shells4.thickness);
    CHECK(one.shells4.thickness.size() == rows / 40);
    CHECK(one.counts.nodes == three.counts.nodes);
    REQUIRE(one.issues.size() == three.issues.size());
    for (std::size_t i = 0; i < one.issues.size(); ++i) {
        CHECK(one.issues[i].place == three.issues[i].place);
        CHECK(one.issues[i].subject == three.issues[i].subject);
        CHECK(one.issues[i].count == three.issues[i].count);
    }

    uint64_t wrong = 0;
    for (const Block& block : deck.blocks()) {
        DataLines lines(deck, block);
        Span line;
        uint32_t row = 0;
        uint64_t data = 0;
        while (lines.next_filled(line)) {
            ++data;
            const Cell id = read_cell(deck, block.scope, line, 1, 10, Kind::integer);
            if (block.keyword == "NODE") {
                if (id.integer == 0) continue;
                const Vec3 x{read_cell(deck, block.scope, line, 11, 20, Kind::real).real,
                             read_cell(deck, block.scope, line, 31, 20, Kind::real).real,
                             read_cell(deck, block.scope, line, 51, 20, Kind::real).real};
                wrong +=
                    one.nodes.id[row] != id.integer || !(one.nodes.x[row] == x) || !(three.nodes.x[row] == x);
            } else if (block.keyword == "SHELL") {
                if (id.integer == 0) continue;
                wrong +=
                    one.shells4.id[row] != id.integer || one.shells4.nodes[row] != three.shells4.nodes[row];
                for (uint32_t n = 0; n < 4; ++n) {
                    const int64_t written =
                        read_cell(deck, block.scope, line, 11 + 10 * n, 10, Kind::integer).integer;
                    const auto known = one.nodes.row(NodeId{static_cast<uint32_t>(written)});
                    wrong += one.shells4.nodes[row][n] != known.value_or(no_node);
                }
            } else if (block.keyword == "TETRA10") {
                wrong += one.solids.id[row] != id.integer;
                REQUIRE(lines.next_filled(line));
                ++data;
                const Cell fourth = read_cell(deck, block.scope, line, 31, 10, Kind::integer);
                const NodeRow last = one.solids.nodes[row][3];
                wrong += last == no_node || value(one.nodes.user_id(last)) != fourth.integer;
                wrong += one.solids.nodes[row] != three.solids.nodes[row];
            }
            ++row;
        }
        if (block.keyword == "NODE") CHECK(one.counts.nodes == data);
        if (block.keyword == "TETRA10") CHECK(one.counts.solids == data / 2);
    }
    CHECK(wrong == 0);

    // Places of rows, in steps, backwards and forwards.
    RowLines node_lines(deck, one.nodes.pieces), solid_lines(deck, three.solids.pieces);
    for (uint32_t row = 0; row < rows; row += 1009) {
        const std::string_view line = deck.text(node_lines.line(row));
        CHECK(parse_integer(columns(line, 0, 10)).value == one.nodes.id[row]);
        const uint32_t back = rows - 1 - row;
        CHECK(parse_integer(deck.text(row_line(deck, one.nodes.pieces, back)).substr(0, 10)).value ==
              one.nodes.id[back]);
        CHECK(parse_integer(deck.text(solid_lines.line(row))).value == three.solids.id[row]);
    }
}

TEST_CASE("the byte that old editors end a file with is no row") {
    MemoryReader files;
    files.add("nodes.inc", nodes_to(3) + "\x1a");
    const Deck deck = deck_of(begin + "#include nodes.inc\n/END\n", files);
    const Tables tables = read_tables(deck, everything(), 1);
    CHECK(tables.counts.nodes == 3);
    CHECK(list(tables.nodes.id) == std::vector<uint32_t>{1, 2, 3});
    CHECK(tables.issues.empty());
}
