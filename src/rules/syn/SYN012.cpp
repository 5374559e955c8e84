#include "rules/rule.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Notice& notice : context.deck.notices()) {
        if (notice.kind != Notice::Kind::version_unknown && notice.kind != Notice::Kind::version_too_old)
            continue;
        Draft draft;
        draft.primary = notice.place;
        draft.discriminator = notice.subject;
        if (notice.kind == Notice::Kind::version_unknown) {
            draft.message = "version " + notice.subject +
                            " on /BEGIN is not known: the cards are read in the newest layout, "
                            "as the solver does";
            draft.help = "write the version that the deck was made for, such as 2022";
        } else {
            draft.message = "version " + notice.subject +
                            " on /BEGIN has cards of 8 and 16 columns, which present readers "
                            "no longer read in full";
            draft.help = "convert the deck to version 51 or later";
        }
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SYN012{{.code = "SYN012",
                          .name = "version-unknown",
                          .summary = "the version on /BEGIN is not known, or too old for present readers",
                          .severity = Severity::warning},
                         Needs::none,
                         check};

} // namespace drawbead
