#include "rules/suppressions.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Suppression& s : context.suppressions.all)
        for (const SuppressedCode& code : s.codes) {
            if (!s.trouble.empty() || code.used || !code.judged) continue;
            Draft draft;
            draft.primary = code.place;
            draft.discriminator = code.word;
            draft.message = "there is nothing of " + code.word + " to ignore " +
                            (s.whole_file ? "in this file" : "in what stands below");
            draft.help =
                s.codes.size() > 1 ? "take " + code.word + " out of the comment" : "take the comment away";
            sink.add(std::move(draft));
        }
}

} // namespace

extern const Rule SUP001{{.code = "SUP001",
                          .name = "suppression-unused",
                          .summary = "a comment ignores a rule that finds nothing there",
                          .severity = Severity::warning},
                         Needs::none,
                         check};

} // namespace drawbead
