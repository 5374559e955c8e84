#include "report/text.h"

#include "report/writer.h"

#include <algorithm>
#include <charconv>

namespace drawbead {

Palette::Palette(bool colour) {
    if (!colour) return;
    bold = "\x1b[1m";
    red = "\x1b[1;31m";
    yellow = "\x1b[1;33m";
    cyan = "\x1b[1;36m";
    blue = "\x1b[1;34m";
    reset = "\x1b[0m";
}

std::string_view Palette::of(Severity severity) const {
    switch (severity) {
    case Severity::error:
        return red;
    case Severity::warning:
        return yellow;
    case Severity::info:
        break;
    }
    return cyan;
}

std::string terminal_safe(std::string_view text) {
    std::string out(text);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const auto byte = static_cast<unsigned char>(out[i]);
        const auto next = i + 1 < out.size() ? static_cast<unsigned char>(out[i + 1]) : 0;
        if (byte < 0x20 || byte == 0x7f) out[i] = '?';
        if (byte == 0xc2 && next >= 0x80 && next < 0xa0) out[i] = out[i + 1] = '?';
    }
    return out;
}

std::string place_text(const ResolvedPlace& place) {
    std::string text = terminal_safe(place.file);
    if (place.line) text += ':' + std::to_string(place.line);
    if (place.line && place.column) text += ':' + std::to_string(place.column);
    return text;
}

std::string finding_line(const DeckResult& deck, const Finding& finding, const Palette& palette) {
    std::string text(palette.bold);
    text += finding.places.empty() ? terminal_safe(deck.path) : place_text(finding.places.front());
    text += ':';
    text += palette.reset;
    text += ' ';
    text += palette.of(finding.severity);
    text += name(finding.severity);
    text += ':';
    text += palette.reset;
    text += ' ';
    text += palette.bold;
    text += finding.code;
    text += palette.reset;
    text += ' ';
    text += finding.name;
    text += ": ";
    text += terminal_safe(finding.message);
    for (std::size_t i = 0; i < finding.fixes.size(); ++i) {
        const FixOffer& fix = finding.fixes[i];
        text += i ? "; " : " [";
        text += fix.applicability == FixAvailability::safe ? "fix: " : "unsafe fix: ";
        text += terminal_safe(fix.title);
    }
    if (!finding.fixes.empty()) text += ']';
    return text;
}

std::string plain_path(std::string_view path) {
    std::string out;
    for (std::size_t i = 0; i < path.size();) {
        const std::size_t end = std::min(path.find('/', i), path.size());
        const std::string_view part = path.substr(i, end - i);
        const bool nothing = part == "." || (part.empty() && i > 0);
        if (!nothing) {
            out += part;
            if (end < path.size()) out += '/';
        }
        i = end + 1;
    }
    return out.empty() ? std::string(path) : out;
}

std::string how_many(uint64_t count, std::string_view noun) {
    std::string text = std::to_string(count) + ' ';
    text += noun;
    if (count != 1) text += 's';
    return text;
}

std::string counts_sentence(const Summary& summary) {
    std::string found;
    const auto add = [&](uint64_t count, std::string_view noun, std::string_view end) {
        if (count == 0) return;
        if (!found.empty()) found += ", ";
        found += how_many(count, noun);
        found += end;
    };
    add(summary.errors, "error", "");
    add(summary.warnings, "warning", "");
    add(summary.infos, "note", "");
    if (found.empty() && summary.failed < summary.decks) found = "no findings";
    add(summary.failed, "deck", " not read");
    if (found.empty()) found = "nothing to check";
    std::string besides;
    if (summary.known > 0) besides = std::to_string(summary.known) + " known";
    if (summary.suppressed > 0)
        besides += (besides.empty() ? "" : ", ") + std::to_string(summary.suppressed) + " suppressed";
    if (!besides.empty()) found += " (" + besides + ')';
    if (summary.interrupted)
        found +=
            ", interrupted after " + std::to_string(summary.decks) + " of " + std::to_string(summary.asked);
    return how_many(summary.decks, "deck") + ", " + how_many(summary.interfaces, "interface") + ": " + found;
}

std::string summary_sentence(const Summary& summary) {
    char seconds[32];
    const auto end =
        std::to_chars(seconds, seconds + sizeof seconds, summary.seconds, std::chars_format::fixed, 2);
    return counts_sentence(summary) + " in " + std::string(seconds, end.ptr) + " s";
}

} // namespace drawbead
