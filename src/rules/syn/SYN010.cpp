#include "rules/support.h"
#include "rules/syn/cells.h"
#include "rules/text.h"

#include <array>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    constexpr std::array kinds{ReadIssue::Kind::unknown_parameter};
    for (CellTrouble& trouble : cell_troubles(context, kinds)) {
        Draft draft;
        draft.interface_id = trouble.interface_id;
        draft.discriminator = trouble.where + " " + trouble.text;
        set_places(draft, trouble.places);
        draft.place_count = trouble.count;
        draft.message = quoted(trouble.text) + " in " + trouble.where +
                        " is not defined by a /PARAMETER: it is read as 0";
        if (trouble.count > 1) draft.message += " (first of " + std::to_string(trouble.count) + ")";
        note_lost_include(context, "the parameter", draft);
        draft.help = "define the parameter; names are case-sensitive, at most 9 characters";
        sink.add(std::move(draft));
    }
    for (const Notice& notice : context.deck.notices()) {
        if (notice.kind != Notice::Kind::unknown_parameter) continue;
        Draft draft;
        draft.primary = notice.place;
        draft.discriminator = notice.subject;
        // In a header, unless the notice says where.
        draft.message =
            quoted("&" + notice.subject) + " in " + (notice.detail.empty() ? "a header" : notice.detail) +
            " is not defined by a /PARAMETER: " + (notice.detail.empty() ? "the id" : "it") + " is read as 0";
        note_lost_include(context, "the parameter", draft);
        draft.help = "define the parameter; names are case-sensitive, at most 9 characters";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SYN010{{.code = "SYN010",
                          .name = "unknown-parameter",
                          .summary = "a field or a header refers to a parameter that is not defined",
                          .severity = Severity::error},
                         Needs::none,
                         check};

} // namespace drawbead
