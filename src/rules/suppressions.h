#pragma once
// Comments in a deck that say which findings its author knows of:
//
//   # drawbead: ignore[LIN005, SRF] the corner is there in the tool, too
//   # drawbead: ignore-file[ENG] we know the solver
//
// The first kind speaks of the line below it: when that is a keyword line, of its block, and of the interface
// or surface that it defines, wherever their findings stand; else of findings that stand on the line. The
// second kind speaks of its file in the same way.
#include "rules/rule.h"

#include <set>
#include <string>
#include <vector>

namespace drawbead {

/// One code, family or name between the brackets.
struct SuppressedCode {
    std::string word; ///< codes and families in capitals
    Span place;
    bool known = false; ///< names a rule, a family or ALL
    bool used = false;  ///< something was suppressed by it
    bool judged = true; ///< all rules that it names were run, so that `used` says something
};

struct Suppression {
    Span comment; ///< the line without its end
    bool whole_file = false;
    std::vector<SuppressedCode> codes;
    bool has_reason = false;
    std::string trouble, help; ///< why it suppresses nothing; `trouble` is empty when it does
    Span trouble_at;

    Span subject; ///< the text that it speaks of
    std::set<InterfaceId> interfaces;
    std::set<SurfaceId> surfaces;
};

struct Suppressions {
    std::vector<Suppression> all; ///< by file, then place
};

/// Reads only the comments that SourceFile::remarks() lists.
Suppressions read_suppressions(const Deck&, const Model&);

/// Whether something suppresses the draft of this rule; marks all that do as used.
bool is_suppressed(Suppressions&, const Rule&, const Draft&);

/// Says which codes can be judged, from the rules that were run.
void judge_suppressions(Suppressions&, std::span<const Rule* const> run);

} // namespace drawbead
