// Bead lines: a damaged deck is repaired into what its clean twin is for the solver, once, and what no
// finding names stays.
#include "line_deck.h"
#include "literate.h"
#include "rules/fix.h"
#include "scene/table.h"

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include <numeric>
#include <random>
#include <set>

using namespace drawbead;

namespace {

using Files = std::map<std::string, std::string>;
using Group = LineDeck::Group;

MemoryReader memory_of(const Files& files) {
    MemoryReader reader;
    for (const auto& [name, text] : files)
        reader.add(name, text);
    return reader;
}

FixOutcome fix(const Files& files, bool unsafe = false) {
    MemoryReader reader = memory_of(files);
    FixOptions options;
    options.choices.unsafe = unsafe;
    return run_fixes("deck.rad", reader, {}, options);
}

Files fixed_files(Files files, const FixOutcome& outcome) {
    for (const FixedFile& file : outcome.files) {
        REQUIRE(edited(file.original, file.edits) == file.text);
        files[file.path] = std::string(file.text);
    }
    return files;
}

std::multiset<std::string> codes_of(const DeckResult& result) {
    std::multiset<std::string> codes;
    for (const Finding& f : result.findings)
        if (f.severity != Severity::info) codes.insert(f.code);
    return codes;
}

/// What the solver makes of each bead node in the first cycle.
struct NodeSeen {
    double fn = 0, ft = 0, tributary = 0, d = 0, penetration = 0;
    std::array<int64_t, 4> segment{};
    int times = 0;
};
std::map<int64_t, NodeSeen> scene(const Files& files) {
    MemoryReader reader = memory_of(files);
    const auto deck = Deck::read("deck.rad", reader);
    REQUIRE(deck);
    const Model model = Model::build(*deck, needs_contact, 1);
    std::map<int64_t, NodeSeen> out;
    for (const BeadTable& bead : table_of(model, contact_of(model, {})).beads) {
        REQUIRE(bead.on_surface());
        for (const BeadTableRow& row : bead.rows) {
            NodeSeen& node = out[row.node];
            node = {row.fn_limit,    row.ft_limit, row.tributary, row.distance,
                    row.penetration, row.n,        node.times + 1};
            std::rotate(node.segment.begin(), std::min_element(node.segment.begin(), node.segment.end()),
                        node.segment.end());
        }
    }
    return out;
}

/// Limits to rounding, all else to the bit.
void check_same(const Files& a, const Files& b) {
    const auto left = scene(a), right = scene(b);
    REQUIRE(left.size() == right.size());
    for (const auto& [id, node] : left) {
        CAPTURE(id);
        REQUIRE(right.count(id) == 1);
        const NodeSeen& twin = right.at(id);
        CHECK(node.times == twin.times);
        CHECK(node.tributary == twin.tributary);
        CHECK(node.d == twin.d);
        CHECK(node.penetration == twin.penetration);
        CHECK(node.segment == twin.segment);
        CHECK(std::abs(node.fn - twin.fn) <= 1e-13 * std::abs(twin.fn));
        CHECK(std::abs(node.ft - twin.ft) <= 1e-13 * std::abs(twin.ft));
    }
}

std::multiset<int> messages(const DeckResult& result) {
    REQUIRE(result.starter);
    return {result.starter->messages.begin(), result.starter->messages.end()};
}

/// Repairs `damaged` and compares with `clean`; gives the repaired files.
Files repaired(const LineDeck& damaged, const LineDeck& clean, bool unsafe = false) {
    const FixOutcome twin = fix(clean.files());
    for (const Finding& f : twin.before.findings) {
        INFO(f.code << ": " << f.message);
        CHECK(f.severity != Severity::error);
    }
    CHECK_FALSE(twin.changed());
    const FixOutcome outcome = fix(damaged.files(), unsafe);
    for (const DeclinedFix& d : outcome.declined)
        FAIL_CHECK(d.code << ": " << d.why);
    REQUIRE(outcome.changed());
    CHECK(codes_of(outcome.after) == codes_of(twin.after));
    CHECK(messages(outcome.after) == messages(twin.after));
    const Files files = fixed_files(damaged.files(), outcome);
    check_same(files, clean.files());
    CHECK_FALSE(fix(files, unsafe).changed());
    return files;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::vector<int> shuffled(int count, unsigned seed) {
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    std::mt19937 random(seed);
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random() % i]);
    return order;
}

} // namespace

TEST_CASE("a sorted group on a curved line") {
    for (const Group kind : {Group::node, Group::set_of_nodes})
        for (const bool shared : {false, true})
            for (const bool scrambled : {false, true}) {
                CAPTURE(shared, scrambled);
                LineDeck damaged;
                damaged.mixed_ids = true;
                LineDeck clean = damaged;
                damaged.group = kind;
                damaged.shared = shared;
                if (scrambled) damaged.order = shuffled(damaged.nodes, 3);
                const std::string before = damaged.files()["deck.rad"];
                const std::string after = repaired(damaged, clean)["deck.rad"];
                // The group of others stays; a list that only the bead uses is the bead's.
                const bool in_place = kind == Group::node && !shared;
                CHECK(contains(after, "/GRNOD/NODENS/101\n") == in_place);
                CHECK(contains(after, "/GRNOD/NODENS/901\n") == !in_place);
                if (!in_place) CHECK(contains(after, damaged.group_block(101, damaged.lists()[0])));
            }
}

TEST_CASE("which end comes first is a guess where limits vary, unless the file tells") {
    LineDeck damaged;
    damaged.mixed_ids = true;
    damaged.fn_last = 160;
    LineDeck clean = damaged;
    damaged.group = Group::node;
    SECTION("the file lists the nodes along the bead") {
        const FixOutcome outcome = fix(damaged.files());
        REQUIRE(outcome.applied.size() == 1);
        CHECK(outcome.applied[0].safe);
        check_same(fixed_files(damaged.files(), outcome), clean.files());
    }
    SECTION("it does not") {
        damaged.order = shuffled(damaged.nodes, 5);
        const FixOutcome outcome = fix(damaged.files());
        CHECK_FALSE(outcome.changed());
        REQUIRE(outcome.declined.size() == 1);
        CHECK(outcome.declined[0].needs_unsafe);
        CHECK(fix(damaged.files(), true).changed());
    }
}

TEST_CASE("500 nodes scrambled") {
    LineDeck damaged;
    damaged.nodes = 500;
    damaged.step = 0.25;
    LineDeck clean = damaged;
    damaged.order = shuffled(500, 7);
    const Files files = repaired(damaged, clean);
    damaged.group = Group::set;
    clean.group = Group::set;
    repaired(damaged, clean);
    damaged.group = Group::node;
    clean.group = Group::nodens;
    repaired(damaged, clean);
}

TEST_CASE("a scrambled list with varying limits that begins at an end") {
    LineDeck damaged;
    damaged.fn_last = 160;
    damaged.ft_last = 30;
    const LineDeck clean = damaged;
    damaged.order = {0, 5, 3, 9, 1, 12, 7, 4, 13, 2, 11, 6, 10, 8};
    const Files files = repaired(damaged, clean);
    CHECK(files == clean.files());
    damaged.order = {5, 0, 3, 9, 1, 12, 7, 4, 13, 2, 11, 6, 10, 8};
    CHECK_FALSE(fix(damaged.files()).changed());
}

TEST_CASE("two gaps, without and with variation") {
    for (const bool varying : {false, true})
        for (const bool shared : {false, true})
            for (const Group kind : {Group::nodens, Group::set}) {
                CAPTURE(varying, shared);
                LineDeck damaged;
                damaged.curved = true;
                damaged.nodes = 18;
                damaged.step = 2.5;
                damaged.gaps = {5, 11};
                damaged.group = kind;
                damaged.history = true;
                damaged.shared = shared;
                if (varying) damaged.fn_last = 210, damaged.ft_last = 10.3;
                LineDeck clean = damaged;
                clean.split = true;
                clean.shared = false;
                if (varying) CHECK_FALSE(fix(damaged.files()).changed());
                const std::string after = repaired(damaged, clean, varying)["deck.rad"];
                CHECK(contains(after, "DEF\n         1         2         3\n/END"));
                if (shared) CHECK(contains(after, damaged.group_block(101, damaged.lists()[0])));
            }
}

TEST_CASE("Fn of 0 stays 0, and a limit of exactly 0 at the end of a piece is none that means constant") {
    LineDeck damaged;
    damaged.curved = false;
    damaged.nodes = 8;
    damaged.gaps = {4};
    damaged.fn = 0;
    damaged.fn_last = 80; // no normal force at all: PAR006
    damaged.ft = 110;
    damaged.ft_last = -70; // along the line 0 is met at the node before the gap: 3 of 14 steps of 16.36
    const FixOutcome outcome = fix(damaged.files(), false);
    CHECK_FALSE(outcome.changed());
    damaged.ft_last = 20;
    FixOptions options;
    options.choices.unsafe = true;
    options.selection.select = {"LIN001"};
    MemoryReader reader = memory_of(damaged.files());
    const FixOutcome split = run_fixes("deck.rad", reader, {}, options);
    REQUIRE(split.applied.size() == 1);
    const std::string after = fixed_files(damaged.files(), split)["deck.rad"];
    const auto second = after.substr(after.find("/INTER/TYPE8/2"));
    CHECK(contains(second, "\n                   0"));
}

TEST_CASE("line ends, versions, includes, submodels, units, a list continued through an include") {
    LineDeck damaged;
    damaged.nodes = 18;
    damaged.step = 2.5;
    damaged.gaps = {5, 11};
    bool unsafe = false;
    SECTION("the line ends of Windows") {
        damaged.windows_lines = true;
    }
    SECTION("version 110") {
        damaged.version = 110, damaged.fn = 0;
    }
    SECTION("version 100") {
        damaged.version = 100, damaged.fn = 0;
    }
    SECTION("version 2021") {
        damaged.version = 2021;
    }
    SECTION("in an include") {
        damaged.in_include = true;
    }
    SECTION("in a submodel with offsets") {
        damaged.in_submodel = true;
    }
    SECTION("a unit of the bead's own") {
        damaged.unit = 1, damaged.fn_last = 211, unsafe = true;
    }
    SECTION("an include in the list") {
        damaged.continued = true;
    }
    SECTION("Windows, in a submodel, with variation") {
        damaged.windows_lines = damaged.in_submodel = true;
        damaged.ft_last = 33, unsafe = true;
    }
    LineDeck clean = damaged;
    clean.split = true;
    clean.continued = false;
    damaged.order = {0, 4, 2, 1, 3, 5, 10, 6, 8, 7, 9, 11, 12, 14, 13, 16, 15, 17};
    if (damaged.fn_last != 0 || damaged.ft_last != 0) damaged.order.clear();
    const Files files = repaired(damaged, clean, unsafe);
    if (damaged.windows_lines)
        for (const auto& [name, text] : files)
            CHECK(std::count(text.begin(), text.end(), '\n') == std::count(text.begin(), text.end(), '\r'));
}

TEST_CASE("two clauses of a set become one") {
    LineDeck damaged;
    LineDeck clean = damaged;
    damaged.group = Group::two_clauses;
    const Files files = repaired(damaged, clean);
    CHECK(contains(files.at("deck.rad"), "/SET/GENERAL/101"));
    CHECK_FALSE(contains(files.at("deck.rad"), "/GRNOD/NODENS"));
    damaged.order = shuffled(damaged.nodes, 9);
    repaired(damaged, clean);
}

TEST_CASE("clauses that delete and intersect") {
    LineDeck clean;
    Files files = clean.files();
    std::string& text = files["deck.rad"];
    const std::string block = clean.group_block(101, clean.lists()[0]);
    LineDeck more = clean;
    more.group = Group::set;
    std::string set = more.group_block(101, more.lists()[0]);
    set.insert(set.find("      5002"), "         9"); // a node of the sheet
    set.erase(set.find("      5009"), 10);
    set.insert(set.find("      5010"), "      5009");
    text.replace(text.find(block), block.size(), set + "NODENS_D           9\n");
    const FixOutcome outcome = fix(files);
    REQUIRE(outcome.changed());
    check_same(fixed_files(files, outcome), clean.files());
}

TEST_CASE("a repeated node") {
    for (const Group kind : {Group::nodens, Group::set})
        for (const bool shared : {false, true}) {
            LineDeck damaged;
            damaged.group = kind;
            damaged.shared = shared;
            damaged.fn_last = 120;
            const LineDeck clean = damaged;
            damaged.repeated = 4;
            repaired(damaged, clean);
        }
    // Of two places the one on the way stays.
    LineDeck damaged;
    const LineDeck clean = damaged;
    damaged.order = {0, 1, 2, 9, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13};
    repaired(damaged, clean);
}

TEST_CASE("four defects at once") {
    LineDeck damaged;
    damaged.nodes = 18;
    damaged.step = 2.5;
    damaged.gaps = {9};
    damaged.mixed_ids = true;
    LineDeck clean = damaged;
    clean.split = true;
    damaged.reversed_sheet = true;
    damaged.group = Group::node;
    damaged.order = shuffled(18, 4);
    damaged.iform_column = 21;
    const FixOutcome outcome = fix(damaged.files());
    std::set<std::string> codes;
    for (const AppliedFix& one : outcome.applied)
        codes.insert(one.code);
    CHECK(codes == std::set<std::string>{"SYN003", "REF003", "LIN001", "SRF001"});
    const Files files = fixed_files(damaged.files(), outcome);
    const auto left = scene(files), right = scene(clean.files());
    REQUIRE(left.size() == right.size());
    for (const auto& [id, node] : left) {
        CHECK(node.tributary == right.at(id).tributary);
        CHECK(node.d == right.at(id).d);
        CHECK(node.fn == right.at(id).fn);
    }
    CHECK(codes_of(outcome.after).empty());
    CHECK_FALSE(fix(files).changed());
}

TEST_CASE("an interface reports what was moved, before and after") {
    LineDeck damaged;
    damaged.nodes = 18;
    damaged.step = 2.5;
    damaged.gaps = {9};
    const FixOutcome outcome = fix(damaged.files());
    REQUIRE(outcome.interfaces.size() == 2);
    CHECK(outcome.interfaces[0].nodes_moved == 9);
    CHECK(outcome.interfaces[1].nodes_moved == 9);
    CHECK_FALSE(outcome.interfaces[1].before);
    CHECK(outcome.interfaces[0].before->fn > 1.4 * 2 * outcome.interfaces[0].after->fn);
}

TEST_CASE("runs of the solver: a gap, a sorted group, a repeated and a coincident node") {
    const auto truth = [](const std::string& name) {
        return Files{{"deck.rad", literate::text_of_file(DRAWBEAD_TESTS_DIR "/truth/" + name + "/" + name +
                                                         "_0000.rad")}};
    };
    const Files sorted = truth("h_sorted");
    check_same(fixed_files(sorted, fix(sorted)), truth("a_closing"));
    for (const std::string name : {"i_gap", "gap_one"}) {
        CAPTURE(name);
        const Files gap = truth(name);
        const FixOutcome outcome = fix(gap, true);
        REQUIRE(outcome.after.starter);
        const auto before = scene(gap), after = scene(fixed_files(gap, outcome));
        REQUIRE(before.size() == after.size());
        std::size_t shorter = 0;
        for (const auto& [id, node] : before) {
            CHECK(std::abs(node.fn - after.at(id).fn) <= 1e-13 * node.fn);
            CHECK(std::abs(node.ft - after.at(id).ft) <= 1e-13 * node.ft);
            shorter += after.at(id).tributary < node.tributary;
        }
        CHECK(shorter == 2);
    }
    for (const std::string name : {"p2_coincident", "p3_closed_loop"}) {
        CAPTURE(name);
        const FixOutcome outcome = fix(truth(name));
        CHECK(codes_of(outcome.after).count("LIN003") == 0);
    }
}

TEST_CASE("any damage of a line is repaired into the clean twin, once") {
    CHECK(rc::check([] {
        LineDeck damaged;
        damaged.nodes = *rc::gen::inRange(10, 24);
        damaged.step = 2.5;
        damaged.mixed_ids = *rc::gen::arbitrary<bool>();
        damaged.curved = *rc::gen::arbitrary<bool>();
        damaged.windows_lines = *rc::gen::arbitrary<bool>();
        const int where = *rc::gen::inRange(0, 3);
        damaged.in_include = where == 1;
        damaged.in_submodel = where == 2;
        if (*rc::gen::arbitrary<bool>()) damaged.gaps = {*rc::gen::inRange(4, damaged.nodes - 4)};
        LineDeck clean = damaged;
        clean.split = true;
        damaged.shared = *rc::gen::arbitrary<bool>();
        damaged.group = *rc::gen::element(Group::nodens, Group::node, Group::set, Group::set_of_nodes,
                                          Group::two_clauses);
        if (*rc::gen::arbitrary<bool>()) damaged.order = shuffled(damaged.nodes, *rc::gen::inRange(0, 1000));
        if (*rc::gen::arbitrary<bool>()) damaged.repeated = *rc::gen::inRange(0, damaged.nodes);
        const Files files = damaged.files();
        const FixOutcome outcome = fix(files);
        const Files after = fixed_files(files, outcome);
        const auto codes = codes_of(outcome.after);
        RC_ASSERT(codes.empty());
        const auto left = scene(after), right = scene(clean.files());
        RC_ASSERT(left.size() == right.size());
        for (const auto& [id, node] : left) {
            const NodeSeen& twin = right.at(id);
            RC_ASSERT(node.tributary == twin.tributary);
            RC_ASSERT(node.segment == twin.segment);
            RC_ASSERT(node.fn == twin.fn);
        }
        RC_ASSERT(!fix(after).changed());
    }));
}
