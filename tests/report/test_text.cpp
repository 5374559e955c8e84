#include "example.h"
#include "report/text.h"
#include "report/writer.h"

#include <catch2/catch.hpp>

using namespace drawbead;

namespace {

std::string written(const Report& report, std::unique_ptr<ReportWriter> (*make)(OutputSink&, bool),
                    bool colour) {
    StringSink out;
    const std::unique_ptr<ReportWriter> writer = make(out, colour);
    for (const DeckResult& deck : report.decks)
        writer->deck(deck);
    writer->end(report.summary);
    return out.text();
}

/// One deck with one finding at this place.
std::string full_text_of(const ResolvedPlace& place) {
    Report report;
    report.decks.resize(1);
    Finding finding;
    finding.code = "SYN005";
    finding.name = "not-a-number";
    finding.severity = Severity::error;
    finding.message = "m";
    finding.places = {place};
    finding.place_count = 1;
    report.decks[0].findings = {finding};
    return written(report, full_writer, false);
}

} // namespace

TEST_CASE("full text, to the letter") {
    CHECK(written(example_report(), full_writer, false) ==
          "decks/hood_0000.rad:1042:11: error: SRF001 segment-normal-away-from-bead: 412 of 9800 segments of "
          "surface 3 "
          "face away from bead 11 [fix: signed groups in a surface of its own; unsafe fix: reverse the "
          "elements]\n"
          "  1042 |       5512      2211      2212      2290      2289\n"
          "       |           ^~~~~~~~~~\n"
          "  also: 1043:1, decks/blank.inc:7:1, 8:1 … and 408 more places\n"
          "  note: full Fn acts at any distance and pulls the blank to the bead\n"
          "  help: reverse the 412 segments, or give the bead a surface of its own\n"
          "\n"
          "decks/hood_0000.rad:9:4: warning: PAR001 unit-suspect: title 'B\xf6rdel ?[31m' of \xce\xbc = 3\n"
          "     9 | \xce\xbc= x\n"
          "       |   ^\n"
          "\n"
          "decks/hood_0000.rad: info: CTX001 no-drawbead: the deck has no /INTER/TYPE8\n"
          "\n");
}

TEST_CASE("concise text is the first line of each finding") {
    CHECK(written(example_report(), concise_writer, false) ==
          "decks/hood_0000.rad:1042:11: error: SRF001 segment-normal-away-from-bead: 412 of 9800 segments of "
          "surface 3 "
          "face away from bead 11 [fix: signed groups in a surface of its own; unsafe fix: reverse the "
          "elements]\n"
          "decks/hood_0000.rad:9:4: warning: PAR001 unit-suspect: title 'B\xf6rdel ?[31m' of \xce\xbc = 3\n"
          "decks/hood_0000.rad: info: CTX001 no-drawbead: the deck has no /INTER/TYPE8\n");
}

TEST_CASE("colours only wrap what is there without them") {
    std::string coloured = written(example_report(), full_writer, true);
    CHECK(coloured.find("\x1b[1mdecks/hood_0000.rad:9:4:\x1b[0m \x1b[1;33mwarning:\x1b[0m "
                        "\x1b[1mPAR001\x1b[0m unit-suspect") != std::string::npos);
    for (std::size_t at; (at = coloured.find('\x1b')) != std::string::npos;)
        coloured.erase(at, coloured.find('m', at) + 1 - at);
    CHECK(coloured == written(example_report(), full_writer, false));
}

TEST_CASE("the caret stays within the line that is shown") {
    const std::string head = "a.rad:3:5: error: SYN005 not-a-number: m\n     3 | 12345678\n";
    CHECK(full_text_of({"a.rad", 3, 5, 7, "12345678"}) == head + "       |     ^~\n\n");
    CHECK(full_text_of({"a.rad", 3, 5, 5, "12345678"}) == head + "       |     ^\n\n"); // an empty place
    CHECK(full_text_of({"a.rad", 3, 5, 900, "12345678"}) == head + "       |     ^~~~\n\n");
    CHECK(full_text_of({"a.rad", 3, 9, 12, "12345678"}) ==
          "a.rad:3:9: error: SYN005 not-a-number: m\n     3 | 12345678\n\n"); // beyond it: no caret
    CHECK(full_text_of({"a.rad", 3, 0, 0, ""}) == "a.rad:3: error: SYN005 not-a-number: m\n\n");
    CHECK(full_text_of({"a.rad", 12345678, 1, 2, "x"}) ==
          "a.rad:12345678:1: error: SYN005 not-a-number: m\n12345678 | x\n         | ^\n\n");
}

TEST_CASE("further places are named up to three, the rest is counted") {
    Report report;
    report.decks.resize(1);
    Finding finding;
    finding.code = "LIN003";
    finding.name = "node-repeated";
    finding.message = "m";
    for (uint64_t line = 1; line <= 100; ++line)
        finding.places.push_back({"a.rad", line, 1, 2, ""});
    finding.place_count = 100;
    const auto also = [&] {
        report.decks[0].findings = {finding};
        const std::string text = written(report, full_writer, false);
        const std::size_t at = text.find("  also: ");
        return at == std::string::npos ? "" : text.substr(at, text.find('\n', at) - at);
    };
    CHECK(also() == "  also: 2:1, 3:1, 4:1 … and 96 more places");
    finding.places.resize(1);
    CHECK(also() == "  also: 99 more places");
    finding.place_count = 2;
    CHECK(also() == "  also: 1 more place");
    finding.place_count = 0; // never less than what is listed
    CHECK(also().empty());
}

TEST_CASE("summary sentences") {
    Summary summary;
    summary.decks = 3;
    summary.interfaces = 7;
    summary.errors = 2;
    summary.warnings = 1;
    summary.seconds = 0.12;
    CHECK(summary_sentence(summary) == "3 decks, 7 interfaces: 2 errors, 1 warning in 0.12 s");
    summary.errors = summary.warnings = 0;
    CHECK(summary_sentence(summary) == "3 decks, 7 interfaces: no findings in 0.12 s");
    summary.failed = 1;
    CHECK(summary_sentence(summary) == "3 decks, 7 interfaces: no findings, 1 deck not read in 0.12 s");
    summary = {};
    summary.decks = summary.failed = 1;
    CHECK(summary_sentence(summary) == "1 deck, 0 interfaces: 1 deck not read in 0.00 s");
    summary = {};
    summary.decks = summary.interfaces = summary.infos = 1;
    summary.seconds = 61.5;
    CHECK(summary_sentence(summary) == "1 deck, 1 interface: 1 note in 61.50 s");
    summary.suppressed = 2;
    CHECK(summary_sentence(summary) == "1 deck, 1 interface: 1 note (2 suppressed) in 61.50 s");
    summary.known = 3;
    CHECK(summary_sentence(summary) == "1 deck, 1 interface: 1 note (3 known, 2 suppressed) in 61.50 s");
}

TEST_CASE("deck text cannot drive a terminal") {
    CHECK(terminal_safe("a\x1b]0;x\x07\tb\x7f\n") == "a?]0;x??b??");
    CHECK(terminal_safe("\xc2\x9b"
                        "1m \xc2\xb5m \xf6") == "??1m \xc2\xb5m \xf6");
}
