#include "rules/rule.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Notice& notice : context.deck.notices()) {
        if (notice.kind != Notice::Kind::keyword_indented) continue;
        Draft draft;
        draft.primary = notice.place;
        draft.discriminator = notice.subject;
        draft.message = "blanks stand before the keyword " + quoted(trim(notice.subject)) +
                        ": it is read as a keyword here, but not by every reader";
        draft.help = "begin the line with the slash";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SYN017{{.code = "SYN017",
                          .name = "keyword-indented",
                          .summary = "blanks stand before the slash of a keyword",
                          .severity = Severity::warning},
                         Needs::none,
                         check};

} // namespace drawbead
