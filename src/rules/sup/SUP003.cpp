#include "rules/suppressions.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Suppression& s : context.suppressions.all) {
        if (s.trouble.empty()) continue;
        Draft draft;
        draft.primary = s.trouble_at;
        draft.discriminator = printable(context.deck.text(s.comment));
        draft.message = "the comment ignores nothing: " + s.trouble;
        draft.help = s.help;
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SUP003{{.code = "SUP003",
                          .name = "suppression-not-understood",
                          .summary = "a comment is meant to ignore a rule and cannot be understood",
                          .severity = Severity::warning},
                         Needs::none,
                         check};

} // namespace drawbead
