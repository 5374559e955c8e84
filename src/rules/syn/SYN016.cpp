#include "rules/rule.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Notice& notice : context.deck.notices()) {
        Draft draft;
        draft.primary = notice.place;
        draft.discriminator = notice.subject;
        if (notice.kind == Notice::Kind::version_in_include) {
            draft.message = "/BEGIN in an include says version " + notice.subject + ", the deck says " +
                            notice.detail + ": the manual ignores it, readers take it for this file";
            draft.help = "use one version in all files";
        } else if (notice.kind == Notice::Kind::submodel_version) {
            draft.message = quoted(notice.subject) +
                            " on //SUBMODEL is not applied by readers: its cards are read in the "
                            "layout of the main file";
            draft.help = "convert the submodel to the version of the main file";
        } else {
            continue;
        }
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SYN016{{.code = "SYN016",
                          .name = "version-disputed",
                          .summary = "an include or submodel names another version than the deck",
                          .severity = Severity::warning},
                         Needs::none,
                         check};

} // namespace drawbead
