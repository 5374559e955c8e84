// Decks that the solver has run, and damaged twins of them: the damage is told, and nothing that only follows
// from it.
#include "literate.h"
#include "rules/check.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

using namespace drawbead;

namespace {

using Lines = std::vector<std::string>;
using Codes = std::set<std::string>;

Lines lines_of(const std::string& text) {
    Lines lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

/// Codes of what the families of this test find.
Codes found_in(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += line + "\n";
    MemoryReader reader;
    reader.add("deck.rad", text);
    CheckOptions options;
    options.selection.select = {"SYN", "REF", "PAR"};
    options.selection.ignore = {"PAR007", "PAR008"}; // some runs are made of implausible values
    const DeckResult result = check_deck("deck.rad", reader, {}, options);
    Codes codes;
    if (result.failed()) codes.insert("failed");
    for (const Finding& finding : result.findings)
        codes.insert(finding.code);
    return codes;
}

/// The runs, by name.
std::map<std::string, Lines> runs() {
    std::map<std::string, Lines> all;
    for (const auto& entry : std::filesystem::directory_iterator(DRAWBEAD_TESTS_DIR "/truth"))
        if (entry.is_directory()) {
            const std::string name = entry.path().filename().string();
            all[name] = lines_of(literate::text_of_file(entry.path().string() + "/" + name + "_0000.rad"));
        }
    return all;
}

/// Index of the n-th data line behind the first /INTER/TYPE8, 0 for its title.
std::size_t type8_line(const Lines& lines, std::size_t n) {
    auto at = std::find_if(lines.begin(), lines.end(),
                           [](const auto& l) { return l.rfind("/INTER/TYPE8", 0) == 0; });
    REQUIRE(at != lines.end());
    for (++at;; ++at) {
        REQUIRE(at != lines.end());
        if ((*at)[0] != '#' && n-- == 0) return static_cast<std::size_t>(at - lines.begin());
    }
}

std::size_t version_line(const Lines& lines) {
    const auto begin = std::find(lines.begin(), lines.end(), "/BEGIN");
    REQUIRE(begin != lines.end());
    return static_cast<std::size_t>(begin - lines.begin()) + 2;
}

double value(const Lines& lines, std::size_t line, std::size_t column) {
    return std::strtod(lines[type8_line(lines, line)].substr(column, 20).c_str(), nullptr);
}

} // namespace

TEST_CASE("what the runs' cards are told of") {
    const std::map<std::string, Codes> expected{
        {"a3_closing_ft_fn0", {"PAR004"}},
        {"d3_linear_fnlast_only", {"PAR005", "PAR006"}},
        {"d4_linear_ftlast_only", {"PAR005"}},
        {"e3_depth0_fn0", {"PAR003"}},
        {"e_depth0", {"PAR003"}},
        {"h_sorted", {"REF003"}},
        {"negft2", {"PAR001"}},
        {"p3_closed_loop", {"PAR005"}},
        {"p3b_closed_loop", {"PAR005"}},
        {"y_v2021_fnlast", {"SYN002"}},
        {"z1_neg_fn", {"PAR002"}},
        {"z2_neg_depth", {"PAR003"}},
        {"z4_neg_ft_visc", {"PAR001"}},
    };
    const auto all = runs();
    CHECK(all.size() > 50);
    for (const auto& [name, lines] : all) {
        INFO(name);
        const auto known = expected.find(name);
        CHECK(found_in(lines) == (known == expected.end() ? Codes{} : known->second));
    }
}

TEST_CASE("a line that is taken out of the cards is told, and no value that is read from a wrong line") {
    for (const auto& [name, good] : runs()) {
        if (!found_in(good).empty()) continue;
        for (std::size_t line = 0; line < 4; ++line) {
            INFO(name << ", line " << line);
            Lines lines = good;
            lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(type8_line(lines, line)));
            CHECK(found_in(lines) == Codes{"SYN001"});
        }
    }
}

TEST_CASE("an older version on /BEGIN is told by what it drops") {
    // What may follow: without Fn and DEPTH the other rules speak of what is left; Iform moves with version
    // 110.
    const Codes companions{"SYN002", "SYN003", "PAR003", "PAR004", "REF006"};
    for (const auto& [name, good] : runs()) {
        if (!found_in(good).empty()) continue;
        for (const std::string version : {"2021", "2017", "130", "120", "110", "100", "90", "51"}) {
            INFO(name << ", version " << version);
            Lines lines = good;
            lines[version_line(lines)].replace(0, 10, std::string(10 - version.size(), ' ') + version);
            const Codes codes = found_in(lines);
            CHECK(codes.count("SYN002") == 1);
            CHECK(std::includes(companions.begin(), companions.end(), codes.begin(), codes.end()));
        }
    }
}

TEST_CASE("an Iform in the columns of version 100 is told") {
    for (const auto& [name, good] : runs()) {
        if (!found_in(good).empty() || name == "u_iform0" || value(good, 1, 30) == 0) continue;
        INFO(name);
        Lines lines = good;
        lines[type8_line(lines, 1)].erase(20, 10);
        CHECK(found_in(lines) == Codes{"SYN003"});
    }
}

TEST_CASE("a group that the solver sorts is told, a list that is out of order is not these rules' business") {
    for (const auto& [name, good] : runs()) {
        if (!found_in(good).empty()) continue;
        INFO(name);
        Lines lines = good;
        for (std::string& line : lines)
            if (line.rfind("/GRNOD/NODENS", 0) == 0) line.replace(0, 13, "/GRNOD/NODE");
        CHECK(found_in(lines) == Codes{"REF003"});
    }
}
