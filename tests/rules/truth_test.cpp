// Decks that were run through the real solver: what is wrong with them is found, and nothing else is called
// an error.
#include "literate.h"
#include "rules/check.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace drawbead;

namespace {

struct Scene {
    const char* name;
    std::set<std::string> errors; ///< codes of all findings that are errors
};

/// Every scene that is not listed is clean of errors.
const std::vector<Scene> damaged{
    {"d3_linear_fnlast_only", {"PAR006"}},
    {"e3_depth0_fn0", {"PAR003"}},
    {"e_depth0", {"PAR003"}},
    {"g_reversed", {"SRF001"}},
    {"gap_one", {"LIN001"}},
    {"h_sorted", {"REF003"}},
    {"half", {"SRF001", "SRF002"}},
    {"i3_two_parallel", {"LIN001"}},
    {"i_gap", {"LIN001"}},
    {"l_admesh_iform1", {"STB006"}},
    {"n2_two_thick_reset", {"STB003"}},
    {"negft2", {"PAR001"}},
    {"o_nsn_gt_nrt", {"STB003"}},
    {"p2_coincident", {"LIN003"}},
    {"p3_closed_loop", {"LIN003"}},
    {"p3b_closed_loop", {"LIN003"}},
    {"p_single", {"LIN012"}},
    {"s_703_rev_reset", {"SRF001", "STB006"}},
    {"seg_rev", {"SRF001"}},
    {"twoside_bad", {"SRF001", "SRF003"}},
    {"y_v2021_fnlast", {"SYN002"}},
    {"z1_neg_fn", {"PAR002"}},
    {"z2_neg_depth", {"PAR003"}},
    {"z4_neg_ft_visc", {"PAR001"}},
};

/// Bead nodes that the Starter warned of (message 346) because their segment looks away from them.
const std::map<std::string, std::vector<int64_t>> looked_away_from{
    {"g_reversed", {1001, 1002, 1003, 1004, 1005, 1006, 1007, 1008, 1009}},
    {"half", {1005, 1006, 1007, 1008, 1009}},
    {"s_703_rev_reset", {1001, 1002, 1003, 1004, 1005, 1006, 1007, 1008, 1009}},
    {"seg_rev", {1001, 1002, 1003, 1004, 1005, 1006, 1007, 1008, 1009}},
    {"twoside_bad", {2001, 2002, 2003, 2004, 2005, 2006, 2007, 2008, 2009}},
};

DeckResult check_scene(const std::string& name, unsigned threads = 1) {
    DiskReader reader;
    CheckOptions options;
    options.threads = threads;
    return check_deck(DRAWBEAD_TESTS_DIR "/truth/" + name + "/" + name + "_0000.rad", reader, {}, options);
}

std::vector<std::string> scenes() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(DRAWBEAD_TESTS_DIR "/truth"))
        if (entry.is_directory()) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string all_messages(const DeckResult& result) {
    std::string text = result.failure;
    for (const Finding& f : result.findings)
        text += std::string(name(f.severity)) + " " + f.code + ": " + f.message + "\n";
    return text;
}

} // namespace

TEST_CASE("every deck of the solver runs raises the errors that it was built to have, and no other") {
    const std::vector<std::string> names = scenes();
    REQUIRE(names.size() >= 59);
    for (const Scene& scene : damaged)
        CHECK(std::count(names.begin(), names.end(), scene.name) == 1);
    for (const std::string& name : names) {
        const DeckResult result = check_scene(name);
        INFO(name << "\n" << all_messages(result));
        REQUIRE_FALSE(result.failed());
        std::set<std::string> errors;
        for (const Finding& f : result.findings)
            if (f.severity == Severity::error) errors.insert(f.code);
        const auto scene =
            std::find_if(damaged.begin(), damaged.end(), [&](const Scene& s) { return s.name == name; });
        CHECK(errors == (scene == damaged.end() ? std::set<std::string>{} : scene->errors));
    }
}

TEST_CASE("SRF001 names the bead nodes that the Starter warns of") {
    for (const std::string& name : scenes()) {
        const DeckResult result = check_scene(name);
        INFO(name << "\n" << all_messages(result));
        std::vector<int64_t> nodes;
        for (const Finding& f : result.findings)
            if (f.code == "SRF001")
                nodes.insert(nodes.end(), f.entities.nodes.ids.begin(), f.entities.nodes.ids.end());
        const auto expected = looked_away_from.find(name);
        CHECK(nodes == (expected == looked_away_from.end() ? std::vector<int64_t>{} : expected->second));
    }
}

TEST_CASE("STB001 is said where the Starter warned of a reset, and nowhere else") {
    std::size_t resets = 0;
    for (const std::string& name : scenes()) {
        const DeckResult result = check_scene(name);
        INFO(name << "\n" << all_messages(result));
        const std::string outcome =
            literate::text_of_file(DRAWBEAD_TESTS_DIR "/truth/" + name + "/outcome.json");
        const bool warned = outcome.find("warning 1040") != std::string::npos;
        const bool said = std::any_of(result.findings.begin(), result.findings.end(),
                                      [](const Finding& f) { return f.code == "STB001"; });
        CHECK(said == warned);
        resets += warned;
    }
    CHECK(resets >= 6);
}

TEST_CASE("findings do not depend on the count of threads") {
    for (const std::string name : {"half", "twoside_bad", "i_gap", "sol_coat_soft"})
        CHECK(all_messages(check_scene(name, 4)) == all_messages(check_scene(name, 1)));
}
