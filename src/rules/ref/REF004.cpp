#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!bead.group || !cards_usable(context, bead)) continue;
        const NodeGroup& group = context.model.groups()[*bead.group];
        if (group.order != NodeGroup::Order::lost_in_set) continue;
        Draft draft = draft_at_header(context, bead);
        set_places(draft, group.nodens_clauses);
        if (group.nodens_clauses.empty()) draft.primary = context.deck.blocks()[group.block].header;
        draft.message =
            "set " + std::to_string(group.id) + " of " + bead_name(bead) +
            (group.nodens_clauses.size() > 1 ? " has " + counted(group.nodens_clauses.size(), "NODENS clause")
                                             : " deletes from a NODENS clause or intersects it") +
            ": the solver merges them as if they were sorted, and the order along the bead is lost";
        draft.notes.push_back("tributary lengths follow from the order; no message tells of the loss");
        draft.help = "put all nodes of the bead into one NODENS clause with continuation lines";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule REF004{
    {.code = "REF004",
     .name = "node-order-lost-in-set",
     .summary = "a /SET with several NODENS clauses, or one that deletes or intersects, loses the "
                "order along the bead",
     .severity = Severity::error},
    Needs::none,
    check};

} // namespace drawbead
