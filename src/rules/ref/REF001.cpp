#include "rules/support.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (bead.group || !cards_usable(context, bead)) continue;
        const Cell& cell = cells_of(bead).group;
        if (!readable(cell)) continue; // said by the rules of numbers and parameters
        Draft draft = draft_at(context, bead, cell);
        if (bead.group_id == 0) {
            draft.message =
                bead_name(bead) + " names no node group: the solver goes on with a group of its own choice";
        } else {
            draft.message = "node group " + std::to_string(bead.group_id) + " of " + bead_name(bead) +
                            " is not defined: the Starter stops";
            note_lost_include(context, "it", draft);
        }
        draft.help = "name a /GRNOD/NODENS that lists the nodes along the bead";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule REF001{{.code = "REF001",
                          .name = "node-group-undefined",
                          .summary = "a drawbead names no node group, or one that does not exist",
                          .severity = Severity::error},
                         Needs::none,
                         check};

} // namespace drawbead
