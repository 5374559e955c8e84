#include "rules/rule.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Notice& notice : context.deck.notices()) {
        if (notice.kind != Notice::Kind::bad_parameter) continue;
        Draft draft;
        draft.primary = notice.place;
        draft.discriminator = notice.subject;
        if (notice.subject.empty()) {
            draft.message = "the /PARAMETER has no name: nothing can refer to it";
            draft.help = "behind the title, write a line with the name in columns 1 to 10, then the value";
            sink.add(std::move(draft));
            continue;
        }
        draft.message = "the value " + quoted(notice.detail) + " of parameter " + quoted(notice.subject) +
                        " cannot be evaluated: it is taken as 0";
        draft.help = "look for names that are not defined, and for parameters that refer to one another";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SYN015{{.code = "SYN015",
                          .name = "parameter-without-value",
                          .summary = "the value or expression of a parameter cannot be evaluated",
                          .severity = Severity::warning},
                         Needs::none,
                         check};

} // namespace drawbead
