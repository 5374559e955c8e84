#include "rules/rule.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Notice& notice : context.deck.notices()) {
        Draft draft;
        const std::string path = quoted(notice.subject, 200);
        switch (notice.kind) {
        case Notice::Kind::include_missing:
            draft.message = notice.subject.empty() ? "the include names no file"
                                                   : "the include " + path + " is not found";
            draft.help = "give its folder with --include-path, or correct the path: it is relative to this "
                         "file, then to "
                         "the main one";
            break;
        case Notice::Kind::include_unreadable:
            draft.message = "the include " + path + " cannot be read: " + printable(notice.detail);
            draft.help = "see to its permissions";
            break;
        case Notice::Kind::include_cycle:
            draft.message = "the include " + path + " includes itself";
            draft.help = "take the line out of one of the files";
            break;
        case Notice::Kind::include_too_deep:
            draft.message =
                notice.detail == "count"
                    ? "the include " + path + " is one of too many: the rest of the deck is not read"
                    : "the include " + path + " lies too deep and is not read";
            draft.help = "look for files that include one another";
            break;
        case Notice::Kind::include_outside_root:
            draft.message =
                "the include " + path + " lies outside of " + quoted(notice.detail, 200) + " and is not read";
            draft.help = "move it there, or allow its folder";
            break;
        default:
            continue;
        }
        draft.primary = notice.place;
        draft.discriminator = notice.subject;
        draft.notes.push_back("what it defines is unknown; the rest of the deck is checked");
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SYN009{{.code = "SYN009",
                          .name = "include-unreadable",
                          .summary = "an included file is not found, cannot be read, or includes itself",
                          .severity = Severity::error},
                         Needs::none,
                         check};

} // namespace drawbead
