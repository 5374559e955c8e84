#include "rules/support.h"
#include "rules/text.h"

#include <map>
#include <set>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    std::set<std::string> told; // one finding per kind of option
    for (const ReadIssue& issue : context.model.issues()) {
        if (issue.kind != ReadIssue::Kind::not_supported || !told.insert(issue.subject).second) continue;
        Draft draft;
        draft.primary = issue.place;
        draft.discriminator = issue.subject;
        draft.message = quoted(issue.detail.empty() ? issue.subject : issue.subject + " " + issue.detail) +
                        " is not supported: what depends on it is not checked";
        sink.add(std::move(draft));
    }
    for (const Notice& notice : context.deck.notices()) {
        if (notice.kind != Notice::Kind::encrypted || context.model.drawbeads().empty()) continue;
        Draft draft;
        draft.primary = notice.place;
        draft.discriminator = "encrypted";
        draft.message = "encrypted text cannot be read: what depends on its values is not checked";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SYN014{{.code = "SYN014",
                          .name = "not-supported",
                          .summary = "an option that matters for drawbeads and that the tool cannot read",
                          .severity = Severity::info},
                         Needs::blank_elements,
                         check};

} // namespace drawbead
