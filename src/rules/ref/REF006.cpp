#include "rules/support.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!cards_usable(context, bead)) continue;
        const DrawbeadCells cells = cells_of(bead);
        const bool known =
            readable(cells.fn) && readable(cells.ft) && readable(cells.fn_last) && readable(cells.ft_last);
        if (known && bead.fn_first == 0 && bead.ft_first == 0 && bead.fn_last == 0 && bead.ft_last == 0) {
            Draft draft = draft_at_header(context, bead);
            draft.discriminator = "no force";
            if (bead.cards[1].present) draft.primary = bead.cards[1].line;
            draft.message = "Fn and Ft of " + bead_name(bead) + " are 0: it does nothing";
            draft.help = "give forces per length, or remove the interface";
            sink.add(std::move(draft));
        }
        if (!bead.group) continue;
        const NodeGroup& group = context.model.groups()[*bead.group];
        if (!group.evaluated || !group.nodes.empty() || !group.listed.empty() ||
            group.order == NodeGroup::Order::sorted)
            continue;
        Draft draft = draft_at_header(context, bead);
        draft.discriminator = "no nodes";
        draft.primary = context.deck.blocks()[group.block].header;
        draft.message = "node group " + std::to_string(group.id) + " of " + bead_name(bead) +
                        " is empty: the bead has no nodes and does nothing";
        draft.help = "list the nodes along the bead, or remove the interface";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule REF006{{.code = "REF006",
                          .name = "dead-interface",
                          .summary = "a drawbead has neither Fn nor Ft, or no nodes",
                          .severity = Severity::warning},
                         Needs::coordinates,
                         check};

} // namespace drawbead
