#include "findings/report.h"

#include <catch2/catch.hpp>

using namespace drawbead;

TEST_CASE("severities have names and come back from them") {
    CHECK(name(Severity::error) == "error");
    CHECK(name(Severity::warning) == "warning");
    CHECK(name(Severity::info) == "info");
    for (const Severity s : {Severity::info, Severity::warning, Severity::error})
        CHECK(severity_from(name(s)) == s);
    CHECK_FALSE(severity_from("fatal"));
    CHECK(name(FixAvailability::sometimes_safe) == "sometimes safe");
}

TEST_CASE("a list of entities counts all and keeps a hundred") {
    EntityList list;
    for (int64_t id = 1; id <= 250; ++id)
        list.add(id);
    CHECK(list.count == 250);
    REQUIRE(list.ids.size() == EntityList::most);
    CHECK(list.ids.front() == 1);
    CHECK(list.ids.back() == 100);
}

TEST_CASE("a fingerprint tells findings apart and is the same everywhere") {
    Entities nodes, segments;
    nodes.nodes.add(7);
    segments.segments.add(7);
    const std::string one = fingerprint("LIN001", 3, nodes, "");
    CHECK(one == fingerprint("LIN001", 3, nodes, ""));
    CHECK(one.size() == 16);
    CHECK(one.find_first_not_of("0123456789abcdef") == std::string::npos);
    CHECK(one != fingerprint("LIN002", 3, nodes, ""));
    CHECK(one != fingerprint("LIN001", 4, nodes, ""));
    CHECK(one != fingerprint("LIN001", std::nullopt, nodes, ""));
    CHECK(one != fingerprint("LIN001", 3, segments, ""));
    CHECK(one != fingerprint("LIN001", 3, nodes, "second"));
}

TEST_CASE("a summary counts decks, interfaces and findings") {
    std::vector<DeckResult> decks(3);
    decks[0].info.interfaces.resize(2);
    for (const Severity s : {Severity::error, Severity::warning, Severity::warning, Severity::info}) {
        decks[0].findings.emplace_back();
        decks[0].findings.back().severity = s;
    }
    decks[1].failure = "no /BEGIN";
    const Summary summary = summarise(decks);
    CHECK(summary.decks == 3);
    CHECK(summary.failed == 1);
    CHECK(summary.interfaces == 2);
    CHECK(summary.errors == 1);
    CHECK(summary.warnings == 2);
    CHECK(summary.infos == 1);
    CHECK(summary.seconds == 0);
}
