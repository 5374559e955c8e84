#pragma once
// A hand-made report that holds one of everything a format has to cope with.
#include "findings/report.h"

#include <limits>

namespace drawbead {

inline Report example_report() {
    Finding flipped;
    flipped.code = "SRF001";
    flipped.name = "segment-normal-away-from-bead";
    flipped.severity = Severity::error;
    flipped.message = "412 of 9800 segments of surface 3 face away from bead 11";
    flipped.interface_id = 11;
    flipped.places = {
        {"decks/hood_0000.rad", 1042, 11, 21, "      5512      2211      2212      2290      2289"},
        {"decks/hood_0000.rad", 1043, 1, 51, ""},
        {"decks/blank.inc", 7, 1, 51, ""},
        {"decks/blank.inc", 8, 1, 51, ""},
        {"decks/blank.inc", 9, 1, 51, ""}};
    flipped.place_count = 412;
    for (int i = 0; i < 412; ++i)
        flipped.entities.segments.add(5512 + i);
    flipped.entities.segments.ids.resize(3);
    flipped.measured = {{"excess force", 4100, "N"},
                        {"distance", -8.25, "mm"},
                        {"distance", std::numeric_limits<double>::infinity(), "mm"}};
    flipped.notes = {"full Fn acts at any distance and pulls the blank to the bead"};
    flipped.help = "reverse the 412 segments, or give the bead a surface of its own";
    flipped.fixes = {{"signed groups in a surface of its own", FixAvailability::safe},
                     {"reverse the elements", FixAvailability::unsafe}};
    // In a line that begins with a word in UTF-8, and a text in Latin-1.
    FileEdit turned{120, 4, {"", 12, 4, 8, "", 3, 7}, 12, "B\xf6rdel {new}\n"};
    FileEdit dropped{300, 11, {"", 15, 1, 1, "", 0, 0}, 16, ""};
    flipped.fixes[0].changes = {{"decks/blank.inc", {turned, dropped}}};
    flipped.fingerprint = "0123456789abcdef";

    // Latin-1 in a name, an escape sequence in a title, UTF-8 before the caret.
    Finding odd;
    odd.code = "PAR001";
    odd.name = "unit-suspect";
    odd.severity = Severity::warning;
    odd.message = "title 'B\xf6rdel \x1b[31m' of \xce\xbc = 3";
    odd.places = {{"decks/hood_0000.rad", 9, 4, 5, "\xce\xbc= x", 3, 4}};
    odd.fingerprint = "00000000000000ff";

    // No place at all.
    Finding whole;
    whole.code = "CTX001";
    whole.name = "no-drawbead";
    whole.severity = Severity::info;
    whole.message = "the deck has no /INTER/TYPE8";
    whole.fingerprint = "0000000000000001";

    DeckResult hood;
    hood.path = "decks/hood_0000.rad";
    hood.info.version = 2022;
    hood.info.run_name = "hood";
    hood.info.mass_unit = hood.info.input_mass_unit = "Mg";
    hood.info.length_unit = "mm";
    hood.info.input_length_unit = "m";
    hood.info.time_unit = hood.info.input_time_unit = "s";
    hood.info.files = {"decks/hood_0000.rad", "decks/blank.inc"};
    hood.info.bytes = 123456;
    hood.info.nodes = 10000;
    hood.info.shells4 = 9800;
    hood.info.shells3 = 12;
    hood.info.solids = 1;
    hood.info.parts = 4;
    hood.info.interfaces = {{11, "bead \"A\"", 42, 9800, 205.5}, {12, "", 7, 9800, 1.0 / 3.0}};
    hood.info.keywords = {{"/INTER/TYPE8", 2}, {"/NODE", 1}};
    StarterMessages starter;
    starter.messages = {346, 1040};
    starter.interfaces = {{11, {346, 1040}, {501, 502}}, {12, {}, {}}};
    hood.starter = starter;
    hood.findings = {flipped, odd, whole};
    hood.suppressed = 2;
    hood.known = 3;
    hood.gone = {{"00000000000000aa", "LIN005", 11, 1}, {"00000000000000bb", "SRF002", std::nullopt, 4}};

    DeckResult missing;
    missing.path = "decks/lost_0000.rad";
    missing.failure = "no such file or folder";
    missing.failure_help = "did you mean 'decks/last_0000.rad'?";

    Report report;
    report.tool_version = "1.2.3";
    report.decks = {hood, missing};
    report.summary = summarise(report.decks);
    report.summary.seconds = 0.125;
    return report;
}

} // namespace drawbead
