#include "rules/support.h"
#include "rules/syn/cells.h"
#include "rules/text.h"

#include <array>

namespace drawbead {

namespace {

std::string explain(const CellTrouble& trouble) {
    const std::string cell = quoted(trouble.text) + " in " + trouble.where;
    switch (trouble.kind) {
    case ReadIssue::Kind::not_finite:
        return cell + " is not a finite number that the solver can hold";
    case ReadIssue::Kind::id_overflow:
        return cell + " is larger than any id can be";
    case ReadIssue::Kind::id_missing:
        return "a line of " + trouble.where + " has no id above 0";
    default:
        return cell + " is not a number: the solver reads 0";
    }
}

void check(const RuleContext& context, FindingSink& sink) {
    constexpr std::array kinds{ReadIssue::Kind::not_a_number, ReadIssue::Kind::not_finite,
                               ReadIssue::Kind::id_overflow, ReadIssue::Kind::id_missing};
    for (CellTrouble& trouble : cell_troubles(context, kinds)) {
        Draft draft;
        draft.interface_id = trouble.interface_id;
        draft.discriminator = trouble.where + " " + trouble.text;
        set_places(draft, trouble.places);
        draft.place_count = trouble.count;
        // Parts, properties and materials are all read, and most of them have nothing to do with a bead.
        if (!trouble.concerns_beads) {
            if (context.model.drawbeads().empty()) continue;
            draft.severity = Severity::warning;
        }
        draft.message = explain(trouble);
        if (trouble.count > 1) draft.message += " (first of " + std::to_string(trouble.count) + ")";
        draft.help = "write a number such as 80., 8.0E1 or 8.0D1";
        sink.add(std::move(draft));
    }
    for (const Notice& notice : context.deck.notices()) {
        if (notice.kind != Notice::Kind::header_id_overflow &&
            notice.kind != Notice::Kind::offset_not_understood)
            continue;
        Draft draft;
        draft.primary = notice.place;
        draft.discriminator = notice.subject;
        if (notice.kind == Notice::Kind::offset_not_understood) {
            draft.message = quoted(notice.subject) + " in " + notice.detail;
            draft.help = "write the offset as a whole number in its ten columns";
            sink.add(std::move(draft));
            continue;
        }
        draft.severity = Severity::warning;
        draft.message = quoted(notice.subject) + " in a header is larger than any id can be";
        draft.help = "ids end at 1100000000";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SYN005{{.code = "SYN005",
                          .name = "not-a-number",
                          .summary = "a field that is read holds something that is not a finite number",
                          .severity = Severity::error},
                         Needs::none,
                         check};

} // namespace drawbead
