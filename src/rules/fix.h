#pragma once
// Repairs a deck in rounds, and proves each of them. Writes nothing.
//
// A round looks at the families in the order SYN, REF, LIN, SRF, PAR, STB, KIN, CTX, ENG; the first one that
// has a fix to make is the round's. Within it rules run by code and findings in the order of the rule; a fix
// that changes a block that an earlier one of the round changes waits for the next round. The result is read
// and checked again with every rule: a fix is kept when its finding is gone and no error is there that was
// not before. Otherwise the fixes of the round are tried one by one, and those that fail are dropped and
// reported. The rounds end when nothing is left to do; their edits are composed and refer to the files as
// they were.
#include "base/buffer.h"
#include "findings/fix_report.h"
#include "rules/check.h"

#include <map>

namespace drawbead {

struct FixOptions {
    Selection selection; ///< whose findings are repaired; all rules are checked in any case
    FixChoices choices;
    Selection counted{}; ///< whose findings count in the result, beside those that are repaired
    Limits limits{};
    std::map<std::string, Severity> severity{}; ///< as CheckOptions: of what is left, for the report
    unsigned threads = 1;
    unsigned most_rounds = 24;
    bool with_changes = false; ///< `before` says what each repair that is offered would change
};

/// A file that changed.
struct FixedFile {
    std::string path;
    std::string_view original, text;
    EditList edits; ///< of the original
};

/// The outcome, which owns the texts.
struct FixOutcome {
    DeckResult before, after; ///< before.failure when the deck could not be read; `after` is empty then
    std::vector<AppliedFix> applied;
    std::vector<DeclinedFix> declined;
    std::vector<InterfaceOutcome> interfaces; ///< that changed, in deck order, new ones last
    std::vector<FixedFile> files;
    std::string force_unit;
    unsigned rounds = 0;

    std::shared_ptr<const CheckedDeck> original, result; ///< for their decks: the rest was given back
    std::vector<std::shared_ptr<const Buffer<char>>> texts;

    bool changed() const { return !files.empty(); }
};

/// What the outcome says; `with_edits`: all of them, with lines and columns of the original files.
FixReport report_of(const FixOutcome&, bool with_edits);

FixOutcome run_fixes(const std::string& path, FileReader&, const ReadOptions&, const FixOptions&);

} // namespace drawbead
