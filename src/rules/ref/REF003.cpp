#include "rules/support.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!bead.group || !cards_usable(context, bead)) continue;
        const NodeGroup& group = context.model.groups()[*bead.group];
        if (group.order != NodeGroup::Order::sorted) continue;
        Draft draft = draft_at_header(context, bead);
        draft.primary = context.deck.blocks()[group.block].header;
        const Cell& cell = cells_of(bead).group;
        if (cell.given()) draft.related.push_back(cell.place);
        const bool set = group.type.substr(0, 3) == "SET";
        draft.message =
            "node group " + std::to_string(group.id) + " of " + bead_name(bead) + " is a /" +
            (set ? "SET without a NODENS clause" : "GRNOD/" + group.type) +
            ", which the solver sorts by id: the order along the bead is lost and the Starter stops";
        draft.help = set ? "list the nodes along the bead in one NODENS clause"
                         : "list the nodes in the order along the bead in a /GRNOD/NODENS";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule REF003{{.code = "REF003",
                          .name = "node-group-sorted",
                          .summary = "the node group of a drawbead is of a type that the solver sorts",
                          .severity = Severity::error,
                          .starter_message = 112},
                         Needs::none,
                         check};

} // namespace drawbead
