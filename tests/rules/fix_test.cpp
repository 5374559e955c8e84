// Repairs as a whole: what a finding offers is what the repair does, a second run has nothing to do, and
// decks that the solver has run are repaired into their clean twins.
#include "literate.h"
#include "rules/fix.h"
#include "sheet_deck.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <set>

using namespace drawbead;

namespace {

using Files = std::map<std::string, std::string>;

FixOutcome fix(const Files& files, const FixOptions& options) {
    MemoryReader reader = reader_of(files);
    return run_fixes("deck.rad", reader, {}, options);
}

Files fixed_files(Files files, const FixOutcome& outcome) {
    for (const FixedFile& file : outcome.files) {
        CHECK(edited(file.original, file.edits) == file.text);
        files[file.path] = std::string(file.text);
    }
    return files;
}

Files files_of(const literate::Example& example) {
    Files files;
    for (const auto& [name, lines] : example.files)
        for (const literate::Line& line : lines)
            files[name] += line.text + "\n";
    return files;
}

std::vector<literate::Document> documents() {
    std::vector<literate::Document> all;
    for (const char* folder : {DRAWBEAD_RULES_DIR, DRAWBEAD_TESTS_DIR "/rules/cases"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.path().extension() == ".md")
                all.push_back(literate::read_document(entry.path().string()));
    return all;
}

bool offers(const Finding& f, FixAvailability applicability) {
    return std::any_of(f.fixes.begin(), f.fixes.end(),
                       [&](const FixOffer& o) { return o.applicability == applicability; });
}

Files truth(const std::string& name) {
    return {
        {"deck.rad", literate::text_of_file(DRAWBEAD_TESTS_DIR "/truth/" + name + "/" + name + "_0000.rad")}};
}

/// Segment (whichever of its nodes is the first), distance, penetration and slope of each bead node in the
/// first cycle.
std::vector<std::string> scene(const Files& files) {
    MemoryReader reader = reader_of(files);
    const auto deck = Deck::read("deck.rad", reader);
    REQUIRE(deck);
    const Model model = Model::build(*deck, needs_contact, 1);
    std::vector<std::string> out;
    for (const InterfaceContact& one : contact_of(model, {}).interfaces)
        for (const BeadNodeContact& n : one.contact.node) {
            std::string row = std::to_string(one.bead->id);
            std::array<uint32_t, 4> nodes;
            for (std::size_t i = 0; i < 4; ++i)
                nodes[i] = value(model.nodes().user_id(NodeRow{n.nodes[i]}));
            std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.end()), nodes.end());
            for (const uint32_t node : nodes)
                row += " " + std::to_string(node);
            for (const double v : {n.distance, n.penetration, n.k, n.slope})
                row += " " + std::to_string(v);
            out.push_back(row + (n.warned_346 ? " 346" : ""));
        }
    return out;
}

} // namespace

TEST_CASE("what a finding offers is what the repair does, and it is done once") {
    std::size_t offered = 0;
    for (const literate::Document& document : documents())
        for (const literate::Example& example : document.examples) {
            INFO(document.path << ": the deck at line " << example.page_line);
            const Files files = files_of(example);
            const DeckResult before = literate::run(example);
            std::set<std::pair<std::string, bool>> wanted; // code, with --unsafe
            for (const Finding& f : before.findings)
                if (!f.fixes.empty()) wanted.emplace(f.code, !offers(f, FixAvailability::safe));
            for (const auto& [code, unsafe] : wanted) {
                CAPTURE(code, unsafe);
                FixOptions options;
                options.selection.select = {code};
                options.choices.unsafe = unsafe;
                const FixOutcome outcome = fix(files, options);
                for (const Finding& f : outcome.after.findings) {
                    if (f.code != code || f.fixes.empty() || (!unsafe && !offers(f, FixAvailability::safe)))
                        continue;
                    FAIL_CHECK("still there: " << f.message);
                    for (const DeclinedFix& d : outcome.declined)
                        FAIL_CHECK(d.why);
                }
                CHECK(outcome.changed());
                CHECK_FALSE(fix(fixed_files(files, outcome), options).changed());
                ++offered;
            }
        }
    CHECK(offered >= 3);
}

TEST_CASE("all rules together: a second run has nothing to do") {
    for (const literate::Document& document : documents())
        for (const literate::Example& example : document.examples)
            for (const bool unsafe : {false, true}) {
                INFO(document.path << ": the deck at line " << example.page_line << ", unsafe " << unsafe);
                FixOptions options;
                options.choices.unsafe = unsafe;
                const Files files = files_of(example);
                const FixOutcome outcome = fix(files, options);
                CHECK(outcome.rounds < options.most_rounds);
                if (outcome.changed()) CHECK_FALSE(fix(fixed_files(files, outcome), options).changed());
            }
}

TEST_CASE("of two interfaces with one id the one is repaired that the finding is about") {
    // The first lacks its cards; Iform stands in the wrong columns of the second.
    const std::string deck = "#RADIOSS STARTER\n/BEGIN\ntwo\n      2022         0\n"
                             "                  Mg                  mm                   s\n"
                             "                  Mg                  mm                   s\n"
                             "/INTER/TYPE8/7\nfirst\n/INTER/TYPE8/7\nsecond\n"
                             "         1         1                              1\n"
                             "                50.0                20.0                 2.0\n\n/END\n";
    FixOptions options;
    options.selection.select = {"SYN003"};
    const FixOutcome outcome = fix({{"deck.rad", deck}}, options);
    REQUIRE(outcome.changed());
    const std::string text = fixed_files({{"deck.rad", deck}}, outcome)["deck.rad"];
    CHECK(text.find("first\n/INTER/TYPE8/7\nsecond\n         1         1                   1\n") !=
          std::string::npos);
}

TEST_CASE("a rule offers fixes in its description only where it has one") {
    for (const Rule& rule : registry()) {
        INFO(rule.info.code);
        CHECK((rule.info.fix != FixAvailability::none) == (rule.fix != nullptr));
    }
}

TEST_CASE("decks that the solver has run with wrong normals become their clean twins") {
    const auto repaired = [](const std::string& name) {
        CAPTURE(name);
        FixOptions options;
        options.selection.select = {"SRF"};
        const Files files = truth(name);
        const FixOutcome outcome = fix(files, options);
        CHECK(outcome.declined.empty());
        REQUIRE(outcome.after.starter);
        for (const int message : outcome.after.starter->messages)
            CHECK((message != 346 && message != 499));
        const Files after = fixed_files(files, outcome);
        CHECK_FALSE(fix(after, options).changed());
        return after;
    };
    CHECK(scene(repaired("g_reversed")) == scene(truth("a_closing")));
    CHECK(scene(repaired("half")) == scene(truth("half_fixgr")));
    CHECK(scene(repaired("half")) == scene(repaired("seg_rev")));
    const auto sides = scene(repaired("twoside_bad"));
    const auto untouched = scene(truth("twoside_bad"));
    REQUIRE(sides.size() == 18);
    CHECK(std::vector(sides.begin(), sides.begin() + 9) ==
          std::vector(untouched.begin(), untouched.begin() + 9));
    repaired("s_703_rev_reset");
}

TEST_CASE("elements turned back are the elements of the clean twin") {
    FixOptions options;
    options.choices.normals = NormalsMode::elements;
    const Files files = truth("g_reversed");
    const std::string shells = "/SHELL/1", next = "/GRNOD/NODE/1";
    const auto table = [&](const Files& f) {
        const std::string& text = f.at("deck.rad");
        return text.substr(text.find(shells), text.find(next) - text.find(shells));
    };
    CHECK(table(fixed_files(files, fix(files, options))) == table(truth("a_closing")));
}

TEST_CASE("decks that the solver has run without trouble are left alone") {
    for (const auto& entry : std::filesystem::directory_iterator(DRAWBEAD_TESTS_DIR "/truth")) {
        if (!entry.is_directory()) continue;
        const std::string name = entry.path().filename().string();
        CAPTURE(name);
        FixOptions options;
        options.selection.select = {"SRF"};
        const FixOutcome outcome = fix(truth(name), options);
        const bool damaged =
            std::any_of(outcome.before.findings.begin(), outcome.before.findings.end(), [](const Finding& f) {
                return f.code == "SRF001" || f.code == "SRF002" || f.code == "SRF003";
            });
        CHECK(outcome.changed() == damaged);
    }
}
