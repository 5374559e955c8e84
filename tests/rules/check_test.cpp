#include "literate.h"
#include "rules/check.h"

#include <catch2/catch.hpp>

using namespace drawbead;

namespace {

DeckResult check_text(const std::string& text, const Selection& selection = {}, unsigned threads = 1) {
    MemoryReader reader;
    reader.add("deck.rad", text);
    CheckOptions options;
    options.selection = selection;
    options.threads = threads;
    return check_deck("deck.rad", reader, {}, options);
}

std::string frame() {
    return literate::text_of_file(DRAWBEAD_TESTS_DIR "/rules/frames/bead.rad");
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    REQUIRE(at != std::string::npos);
    return text.replace(at, what.size(), with);
}

std::vector<std::string> codes(const DeckResult& result) {
    std::vector<std::string> all;
    for (const Finding& finding : result.findings)
        all.push_back(finding.code);
    return all;
}

} // namespace

TEST_CASE("the frame of the pages is clean") {
    const DeckResult result = check_text(frame());
    CHECK_FALSE(result.failed());
    for (const Finding& finding : result.findings)
        UNSCOPED_INFO(finding.code << " " << finding.message);
    CHECK(result.findings.empty());
}

TEST_CASE("line ends of Windows and a missing last one change nothing") {
    std::string text;
    for (const char c : frame())
        text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    CHECK(check_text(text).findings.empty());
    CHECK(check_text(frame().substr(0, frame().size() - 1)).findings.empty());
    const std::string damaged = replaced(text, "/GRNOD/NODENS/2", "/GRNOD/NODE/2");
    CHECK(codes(check_text(damaged)) == std::vector<std::string>{"REF003"});
}

TEST_CASE("what was read of a deck") {
    MemoryReader reader;
    reader.add("deck.rad", frame());
    for (const DeckResult& result : {describe_deck("deck.rad", reader, {}), check_text(frame())}) {
        CHECK(result.info.version == 2022);
        CHECK(result.info.run_name == "bead over a small blank");
        CHECK(result.info.length_unit == "mm");
        CHECK(result.info.files == std::vector<std::string>{"deck.rad"});
        CHECK(result.info.bytes == frame().size());
        CHECK(result.info.nodes == 20);
        CHECK(result.info.shells4 == 8);
        CHECK(result.info.shells3 == 0);
        CHECK(result.info.parts == 1);
        CHECK(result.info.keywords.at("/GRNOD/NODENS") == 1);
        CHECK(result.info.keywords.at("/NODE") == 1);
        REQUIRE(result.info.interfaces.size() == 1);
        CHECK(result.info.interfaces[0].id == 1);
        CHECK(result.info.interfaces[0].title == "bead");
        CHECK(result.info.interfaces[0].nodes == 5);
        CHECK(result.info.interfaces[0].segments == 8);
        CHECK(result.info.interfaces[0].length == Approx(32));
    }
}

TEST_CASE("a deck that cannot be read is a result with the reason") {
    MemoryReader reader;
    const DeckResult missing = check_deck("none.rad", reader, {}, {});
    CHECK(missing.failed());
    CHECK(missing.path == "none.rad");
    CHECK(missing.findings.empty());
    CHECK(check_text("").failed());
    CHECK(check_text("just\nsome text\n").failed());
    CHECK(describe_deck("none.rad", reader, {}).failed());
}

TEST_CASE("rules are selected by code, family, name or ALL, and ignore wins unless select is closer") {
    const auto selected = [](const Selection& s, std::string_view code) { return s(find_rule(code)->info); };
    CHECK(selected({}, "SYN001"));
    CHECK(selected({{"ALL"}, {}}, "SYN001"));
    CHECK(selected({{"SYN"}, {}}, "SYN001"));
    CHECK(selected({{"card-missing"}, {}}, "SYN001"));
    CHECK_FALSE(selected({{"REF"}, {}}, "SYN001"));
    CHECK_FALSE(selected({{}, {"SYN"}}, "SYN001"));
    CHECK_FALSE(selected({{"SYN"}, {"SYN001"}}, "SYN001"));
    CHECK_FALSE(selected({{"SYN001"}, {"SYN001"}}, "SYN001"));
    CHECK(selected({{"SYN001"}, {"SYN"}}, "SYN001"));
    CHECK(selected({{"SYN"}, {"ALL"}}, "SYN001"));
    CHECK_FALSE(selected({{"SYN"}, {"ALL"}}, "REF001"));

    CHECK_FALSE(Selection{{"SYN", "REF001", "ALL"}, {"card-missing"}}.unknown());
    CHECK(Selection{{"SYN", "SYN9"}, {}}.unknown() == "SYN9");
    CHECK(Selection{{}, {"nonsense"}}.unknown() == "nonsense");
}

TEST_CASE("only selected rules speak") {
    const std::string text = replaced(frame(), "/GRNOD/NODENS/2", "/GRNOD/NODE/2");
    CHECK(codes(check_text(text)) == std::vector<std::string>{"REF003"});
    CHECK(codes(check_text(text, {{"SYN"}, {}})).empty());
    CHECK(codes(check_text(text, {{}, {"REF"}})).empty());
}

TEST_CASE("findings are sorted by place and own what they say") {
    std::string text = replaced(frame(), "/GRNOD/NODENS/2", "/GRNOD/NODE/2");
    text = replaced(text, "       101       102       103", "       101       102       999");
    text = replaced(text, "                 80.                100.",
                    "                -80.               -100.");
    const DeckResult result = check_text(text);
    REQUIRE(result.findings.size() >= 3);
    for (std::size_t i = 1; i < result.findings.size(); ++i)
        CHECK(result.findings[i - 1].places.front().line <= result.findings[i].places.front().line);
    for (const Finding& finding : result.findings) {
        const ResolvedPlace& place = finding.places.front();
        CHECK(place.file == "deck.rad");
        CHECK(place.line > 0);
        CHECK(place.column > 0);
        CHECK(place.end_column > place.column);
        CHECK(place.snippet.size() >= place.end_column - 1);
        CHECK(finding.place_count >= finding.places.size());
        CHECK(finding.fingerprint.size() == 16);
    }
}

TEST_CASE("the result does not depend on the number of threads") {
    std::string text = replaced(frame(), "/GRNOD/NODENS/2", "/GRNOD/NODE/2");
    text = replaced(text, "                 80.                100.",
                    "                -80.               -1..0");
    const DeckResult one = check_text(text), four = check_text(text, {}, 4);
    REQUIRE(one.findings.size() == four.findings.size());
    CHECK(one.findings.size() > 1);
    for (std::size_t i = 0; i < one.findings.size(); ++i) {
        CHECK(one.findings[i].message == four.findings[i].message);
        CHECK(one.findings[i].fingerprint == four.findings[i].fingerprint);
        CHECK(one.findings[i].places.front().line == four.findings[i].places.front().line);
    }
}

TEST_CASE("fingerprints do not change when lines are added") {
    const std::string text = replaced(frame(), "/GRNOD/NODENS/2", "/GRNOD/NODE/2");
    const std::string longer = replaced(text, "/MAT/ELAST/1", "# a comment\n# and another\n/MAT/ELAST/1");
    const DeckResult a = check_text(text), b = check_text(longer);
    REQUIRE(a.findings.size() == 1);
    REQUIRE(b.findings.size() == 1);
    CHECK(a.findings[0].fingerprint == b.findings[0].fingerprint);
    CHECK(a.findings[0].places.front().line + 2 == b.findings[0].places.front().line);
}
