#include "rules/fix.h"
#include "rules/suppressions.h"

#include <catch2/catch.hpp>

using namespace drawbead;

namespace {

const std::string begin = "#RADIOSS STARTER\n/BEGIN\ntiny\n      2022         0\n"
                          "                  Mg                  mm                   s\n"
                          "                  Mg                  mm                   s\n";
const std::string group = "/GRNOD/NODENS/1\nbead\n        11        12        13\n";
/// Fn is negative (PAR002), and there are neither nodes nor elements (REF005, …).
const std::string bead = "/INTER/TYPE8/7\nbead\n         1         1                   2\n"
                         "               -50.0                20.0                 2.0                 0.0"
                         "                 0.0\n                 0.0                 0.0\n";

DeckResult check(const std::string& middle, const std::vector<std::string>& select = {},
                 const std::map<std::string, std::string>& includes = {}) {
    MemoryReader reader;
    reader.add("deck.rad", begin + middle + "/END\n");
    for (const auto& [name, text] : includes)
        reader.add(name, text);
    CheckOptions options;
    options.selection.select = select;
    return check_deck("deck.rad", reader, {}, options);
}

uint64_t count(const DeckResult& result, const std::string& code) {
    return static_cast<uint64_t>(std::count_if(result.findings.begin(), result.findings.end(),
                                               [&](const Finding& f) { return f.code == code; }));
}

const Finding& only(const DeckResult& result, const std::string& code) {
    REQUIRE(count(result, code) == 1);
    return *std::find_if(result.findings.begin(), result.findings.end(),
                         [&](const Finding& f) { return f.code == code; });
}

} // namespace

TEST_CASE("without a comment nothing is suppressed") {
    const DeckResult plain = check(group + bead);
    CHECK(count(plain, "PAR002") == 1);
    CHECK(count(plain, "REF005") == 1);
    CHECK(plain.suppressed == 0);
}

TEST_CASE("a comment before a block speaks of its interface, wherever the finding stands") {
    const DeckResult result = check(group + "# drawbead: ignore[PAR002, ref005] known since June\n" + bead);
    CHECK(count(result, "PAR002") == 0);
    CHECK(count(result, "REF005") == 0); // it stands in the list of the group
    CHECK(result.suppressed == 2);
    CHECK(count(result, "SUP001") == 0);
    CHECK(count(result, "SUP002") == 0);
}

TEST_CASE("a comment before a group speaks of what stands in it") {
    const DeckResult result = check("# drawbead: ignore[REF, PAR002] known\n" + group + bead);
    CHECK(count(result, "REF005") == 0);
    CHECK(count(result, "PAR002") == 1);
    CHECK(only(result, "SUP001").message.find("PAR002") != std::string::npos);
}

TEST_CASE("a comment before a card speaks of that line") {
    std::string middle = group + bead;
    middle.insert(middle.find("               -50.0"),
                  "#  Fn\n# drawbead: ignore[PAR002] pulls on purpose\n#\n");
    const DeckResult result = check(middle);
    CHECK(count(result, "PAR002") == 0);
    CHECK(count(result, "REF005") == 1);
    CHECK(count(result, "SUP001") == 0);

    middle = group + bead;
    middle.insert(middle.find("         1         1  "), "# drawbead: ignore[PAR002] one line too early\n");
    CHECK(count(check(middle), "PAR002") == 1);
    CHECK(count(check(middle), "SUP001") == 1);
}

TEST_CASE("comments may stand one below the other, and a name or ALL stands for its rules") {
    const DeckResult result =
        check(group + "# drawbead: ignore[negative-normal-force] a\n#drawbead:ignore[ALL] b\n" + bead);
    CHECK(count(result, "PAR002") == 0);
    CHECK(count(result, "REF005") == 0);
    CHECK(count(result, "SUP001") == 0);
}

TEST_CASE("other comments may stand between, of either kind") {
    const DeckResult result = check(group + "# drawbead: ignore[PAR002] a\n$ one\n\n# another\n" + bead);
    CHECK(count(result, "PAR002") == 0);
    CHECK(count(result, "SUP001") == 0);
}

TEST_CASE("ignore-file speaks of its own file") {
    const std::string comment = "# drawbead: ignore-file[PAR] a trial\n";
    CHECK(count(check(comment + group + bead), "PAR002") == 0);
    // The interface stands in the include: a comment in the main file says nothing of it.
    CHECK(count(check(comment + group + "#include b.inc\n", {}, {{"b.inc", bead}}), "PAR002") == 1);
    CHECK(count(check(group + "#include b.inc\n", {}, {{"b.inc", comment + bead}}), "PAR002") == 0);
    CHECK(count(check(group + "#include b.inc\n", {}, {{"b.inc", "# drawbead: ignore[PAR002] so\n" + bead}}),
                "PAR002") == 0);
}

TEST_CASE("a comment before #include speaks of that line") {
    CHECK(count(check("#include lost.inc\n" + group + bead), "SYN009") == 1);
    const DeckResult result =
        check("# drawbead: ignore[SYN009] made by the run\n#include lost.inc\n" + group + bead);
    CHECK(count(result, "SYN009") == 0);
}

TEST_CASE("rules that were not run do not make a comment unused") {
    const std::string middle = group + "# drawbead: ignore[LIN005, SRF] why not\n" + bead;
    CHECK(count(check(middle), "SUP001") == 2);
    CHECK(count(check(middle, {"SUP"}), "SUP001") == 0);
    CHECK(count(check(middle, {"SUP", "LIN"}), "SUP001") == 1);
    CHECK(count(check(middle, {"SUP", "SRF001"}), "SUP001") == 0); // one rule of the family
}

TEST_CASE("a missing reason and what cannot be understood are findings") {
    CHECK(count(check(group + "# drawbead: ignore[PAR002]\n" + bead), "SUP002") == 1);
    CHECK(count(check(group + "# drawbead: ignore[PAR002]\n" + bead), "PAR002") == 0);
    CHECK(count(check(group + "# drawbead: ignore[PAR002] - \n" + bead), "SUP002") == 1);
    for (const char* damaged : {"ignore[PAR02] x", "ignore[] x", "ignore x", "ignore[PAR002 x",
                                "ignor[PAR002] x", "ignore[,] x", "ignore", "ignore-file [PAR002"}) {
        INFO(damaged);
        const DeckResult result = check(group + "# drawbead: " + damaged + "\n" + bead);
        CHECK(count(result, "SUP003") == 1);
        CHECK(count(result, "PAR002") == 1);
        CHECK(count(result, "SUP001") + count(result, "SUP002") == 0);
    }
    for (const char* other : {"left flange", "", "ignored by nobody", "see [3]"})
        CHECK(count(check(group + "# drawbead: " + other + "\n" + bead), "SUP003") == 0);
    const Finding place = only(check(group + "# drawbead: ignore[PAR002, LIN55] x\n" + bead), "SUP003");
    CHECK(place.places.front().column == 28);
}

TEST_CASE("the Starter's verdict and fingerprints do not depend on comments") {
    const std::string comment = "# drawbead: ignore[PAR002] known\n";
    const DeckResult plain = check(group + bead), with = check(comment + group + bead);
    REQUIRE(plain.starter.has_value() == with.starter.has_value());
    if (plain.starter) CHECK(plain.starter->messages == with.starter->messages);
    CHECK(only(plain, "REF005").fingerprint == only(with, "REF005").fingerprint);
}

TEST_CASE("a comment at the end of a file, alone or in a short file, is read") {
    CHECK(count(check(group + bead + "# drawbead: ignore[PAR002] nothing below\n"), "SUP001") == 1);
    MemoryReader reader;
    reader.add("deck.rad", begin + group + bead + "# drawbead: ignore[PAR002] no line end");
    CHECK(count(check_deck("deck.rad", reader, {}, {}), "SUP001") == 1);
}

TEST_CASE("a suppressed finding is not repaired") {
    const auto fixed = [](const std::string& comment) {
        MemoryReader reader;
        reader.add("deck.rad", begin + group + comment + bead + "/END\n");
        FixOptions options;
        options.selection.select = {"PAR002"};
        options.choices.unsafe = true;
        const FixOutcome outcome = run_fixes("deck.rad", reader, {}, options);
        return outcome.applied.size() + outcome.declined.size();
    };
    CHECK(fixed("") == 1);
    CHECK(fixed("# drawbead: ignore[PAR002] pulls on purpose\n") == 0);
}
