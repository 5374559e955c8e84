#include "rules/suppressions.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Suppression& s : context.suppressions.all) {
        if (!s.trouble.empty() || s.has_reason) continue;
        Draft draft;
        draft.primary = s.comment;
        std::string codes;
        for (const SuppressedCode& code : s.codes)
            codes += (codes.empty() ? "" : ", ") + code.word;
        draft.discriminator = codes;
        draft.message = "the comment does not say why " + codes + (s.codes.size() > 1 ? " are" : " is") +
                        " ignored: whoever reads it cannot tell a choice from a mistake";
        draft.help = "write the reason after the bracket";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SUP002{{.code = "SUP002",
                          .name = "suppression-without-reason",
                          .summary = "a comment ignores a rule and does not say why",
                          .severity = Severity::warning},
                         Needs::none,
                         check};

} // namespace drawbead
