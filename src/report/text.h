#pragma once
// What the text formats share.
#include "findings/report.h"

#include <string>
#include <string_view>

namespace drawbead {

/// Terminal colours, or nothing at all.
struct Palette {
    std::string_view bold, red, yellow, cyan, blue, reset;
    explicit Palette(bool colour);
    std::string_view of(Severity) const;
};

/// The same bytes, but every control byte, C1 controls in UTF-8 too, is a '?': names and deck text must not
/// drive a terminal.
std::string terminal_safe(std::string_view text);

/// "path:line:column"; the line and column only where known.
std::string place_text(const ResolvedPlace&);

/// "path:line:column: severity: CODE name: message [fix: title]", without a line end. A finding without a
/// place stands at the deck.
std::string finding_line(const DeckResult&, const Finding&, const Palette&);

/// The path without what does not matter: "./" and doubled slashes. Nothing is looked up.
std::string plain_path(std::string_view path);

/// "1 deck", "2 decks".
std::string how_many(uint64_t count, std::string_view noun);

} // namespace drawbead
