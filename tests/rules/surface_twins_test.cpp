// Damaged twins of decks that the solver has run: flipped elements, scrambled, cut, doubled and sorted lists.
// Each raises its own rule and no other error.
#include "literate.h"
#include "rules/check.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <random>
#include <set>
#include <sstream>

using namespace drawbead;

namespace {

using Lines = std::vector<std::string>;
using Codes = std::set<std::string>;

Lines lines_of(const std::string& name) {
    Lines lines;
    std::istringstream in(
        literate::text_of_file(DRAWBEAD_TESTS_DIR "/truth/" + name + "/" + name + "_0000.rad"));
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

Codes errors_of(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += line + "\n";
    MemoryReader reader;
    reader.add("deck.rad", text);
    const DeckResult result = check_deck("deck.rad", reader, {}, {});
    Codes codes;
    if (result.failed()) codes.insert("failed");
    for (const Finding& f : result.findings)
        if (f.severity == Severity::error) codes.insert(f.code);
    return codes;
}

/// Scenes of shells under one straight or curved bead of at least eight nodes, without an error.
std::vector<std::string> good_scenes() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(DRAWBEAD_TESTS_DIR "/truth")) {
        if (!entry.is_directory()) continue;
        const std::string name = entry.path().filename().string();
        const Lines lines = lines_of(name);
        const auto has = [&](const char* key) { return std::count(lines.begin(), lines.end(), key) == 1; };
        if (has("/SHELL/1") && has("/GRNOD/NODENS/10") && has("/SURF/PART/1") && name != "adv_mm" &&
            name != "o_nsn_gt_nrt" && errors_of(lines).empty())
            names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::size_t header(const Lines& lines, const std::string& key) {
    const auto at = std::find(lines.begin(), lines.end(), key);
    REQUIRE(at != lines.end());
    return static_cast<std::size_t>(at - lines.begin());
}

/// Whether all nodes of the bead stand over the fifth column of a plate of ten by ten elements of 5 mm.
bool over_fifth_column(const Lines& lines, const std::vector<int>& nodes) {
    return std::all_of(nodes.begin(), nodes.end(), [&](int node) {
        char id[16];
        std::snprintf(id, sizeof id, "%10d ", node);
        const auto at = std::find_if(lines.begin(), lines.end(),
                                     [&](const std::string& line) { return line.rfind(id, 0) == 0; });
        REQUIRE(at != lines.end());
        const double x = std::stod(at->substr(10, 20));
        return x > 20 && x < 25;
    });
}

/// Cells of ten columns.
std::vector<int> cells(const std::string& line) {
    std::vector<int> out;
    for (std::size_t at = 0; at < line.size(); at += 10)
        out.push_back(std::stoi(line.substr(at, 10)));
    return out;
}
std::string line_of(const std::vector<int>& numbers) {
    std::string line;
    for (const int n : numbers) {
        char cell[16];
        std::snprintf(cell, sizeof cell, "%10d", n);
        line += cell;
    }
    return line;
}

/// The bead's list, and the deck with another one.
std::vector<int> bead_list(const Lines& lines) {
    std::vector<int> nodes;
    for (std::size_t i = header(lines, "/GRNOD/NODENS/10") + 2; lines[i][0] != '/'; ++i)
        for (const int n : cells(lines[i]))
            nodes.push_back(n);
    return nodes;
}
Lines with_list(Lines lines, const std::vector<int>& nodes) {
    const std::size_t begin = header(lines, "/GRNOD/NODENS/10") + 2;
    std::size_t end = begin;
    while (lines[end][0] != '/')
        ++end;
    const auto at = [&](std::size_t i) { return lines.begin() + static_cast<std::ptrdiff_t>(i); };
    lines.erase(at(begin), at(end));
    Lines list;
    for (std::size_t i = 0; i < nodes.size(); i += 10)
        list.push_back(
            line_of({nodes.begin() + static_cast<std::ptrdiff_t>(i),
                     nodes.begin() + static_cast<std::ptrdiff_t>(std::min(i + 10, nodes.size()))}));
    lines.insert(at(begin), list.begin(), list.end());
    return lines;
}

/// The deck with these shells (ids) listed the other way round.
Lines with_flipped(Lines lines, const std::set<int>& ids) {
    std::size_t flipped = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].rfind("/SHELL/", 0) != 0) continue;
        for (++i; i < lines.size() && lines[i][0] != '/'; ++i) {
            if (lines[i][0] == '#') continue;
            const std::vector<int> c = cells(lines[i].substr(0, 50));
            if (ids.count(c[0]) == 0) continue;
            lines[i] = line_of({c[0], c[4], c[3], c[2], c[1]}) + lines[i].substr(50);
            ++flipped;
        }
        --i;
    }
    REQUIRE(flipped == ids.size());
    return lines;
}

std::set<int> range(int from, int to) {
    std::set<int> ids;
    for (int i = from; i <= to; ++i)
        ids.insert(i);
    return ids;
}

} // namespace

TEST_CASE("flipped shells under and near the bead") {
    const std::vector<std::string> scenes = good_scenes();
    REQUIRE(scenes.size() > 25);
    for (const std::string& name : scenes) {
        const Lines good = lines_of(name);
        INFO(name);
        std::set<int> all;
        for (std::size_t i = header(good, "/SHELL/1") + 1; i < good.size(); ++i) {
            if (good[i].rfind("/SHELL/", 0) == 0) continue;
            if (good[i][0] == '/') break;
            if (good[i][0] != '#') all.insert(std::stoi(good[i].substr(0, 10)));
        }
        CHECK(errors_of(with_flipped(good, all)) == Codes{"SRF001"});
        // One shell after the other under the bead, a patch, and half of the plate.
        if (all != range(1, 100) || !over_fifth_column(good, bead_list(good))) continue;
        for (int row = 1; row < 9; ++row)
            CHECK(errors_of(with_flipped(good, {row * 10 + 5})) == Codes{"SRF001", "SRF002"});
        CHECK(errors_of(with_flipped(good, {44, 45, 46, 54, 55, 56, 64, 65, 66})) ==
              Codes{"SRF001", "SRF002"});
        CHECK(errors_of(with_flipped(good, range(51, 100))) == Codes{"SRF001", "SRF002"});
    }
}

TEST_CASE("a shell far from the bead clashes with its neighbours, and no bead looks at it yet") {
    CHECK(errors_of(with_flipped(lines_of("a_closing"), {50})) == Codes{"SRF002"});
    CHECK(errors_of(with_flipped(lines_of("a_closing"), {10, 20, 30})) == Codes{"SRF002"});
}

TEST_CASE("damaged lists") {
    std::mt19937 random(3);
    for (const std::string& name : good_scenes()) {
        const Lines good = lines_of(name);
        const std::vector<int> list = bead_list(good);
        if (list.size() < 8 || name == "k_outside" || name == "k2_outside_fine") continue; // uneven by intent
        INFO(name);
        CHECK(errors_of(with_list(good, list)).empty());
        CHECK(errors_of(with_list(good, {list.rbegin(), list.rend()})).empty());

        std::vector<int> shuffled = list;
        std::shuffle(shuffled.begin(), shuffled.end(), random);
        CHECK(errors_of(with_list(good, shuffled)) == Codes{"LIN002"});
        std::vector<int> swapped = list;
        std::swap(swapped[2], swapped[5]);
        CHECK(errors_of(with_list(good, swapped)) == Codes{"LIN002"});

        std::vector<int> twice = list;
        twice.insert(twice.begin() + 4, list[3]);
        CHECK(errors_of(with_list(good, twice)) == Codes{"LIN003"});
        std::vector<int> closed = list;
        closed.push_back(list[0]);
        CHECK(errors_of(with_list(good, closed)) == Codes{"LIN003"});

        CHECK(errors_of(with_list(good, {list[0]})) == Codes{"LIN012"});

        Lines sorted = with_list(good, shuffled);
        sorted[header(sorted, "/GRNOD/NODENS/10")] = "/GRNOD/NODE/10";
        CHECK(errors_of(sorted) == Codes{"REF003"});
    }
}

TEST_CASE("a hop in the list") {
    for (const char* name : {"a_closing", "b_drawin_visc", "c_drawin_incr", "f3_noreset", "n_two_thick"}) {
        const Lines good = lines_of(name);
        std::vector<int> list = bead_list(good);
        REQUIRE(list.size() == 9);
        INFO(name);
        list.erase(list.begin() + 3, list.begin() + 7); // a hop of five steps, four and a half elements
        CHECK(errors_of(with_list(good, list)) == Codes{"LIN001"});
    }
}
