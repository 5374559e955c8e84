#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        if (!a->check.too_short) continue;
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, 0);
        const std::string node = std::to_string(node_id(context, *a, 0));
        draft.message = a->x.size() == 1 ? bead_name(*a->bead) + " has a single node, " + node
                                         : "all " + counted(a->x.size(), "node") + " of " +
                                               bead_name(*a->bead) + " stand at the place of node " + node;
        draft.message += "; its length is 0 and so is its force: 0 N instead of Fn and Ft";
        if (a->bead->fn_varies() || a->bead->ft_varies())
            draft.notes.push_back("with Fn_last or Ft_last the Engine divides 0 by 0 for the limit");
        for (std::size_t i = 0; i < a->x.size(); ++i)
            draft.entities.nodes.add(node_id(context, *a, i));
        draft.help = "list at least two nodes along the bead";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule LIN012{{.code = "LIN012",
                          .name = "single-node",
                          .summary = "the bead has fewer than two places, so no length and no force",
                          .severity = Severity::error},
                         needs_lines,
                         check};

} // namespace drawbead
