#include "rules/analysis.h"
#include "rules/kin/path_report.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const BeadPath* path = path_of(context, *a);
        if (path == nullptr || !path->bead_moves || a->ft_total == 0) continue;
        const auto moved = [&](const NodePath& node) { return moves_sideways(context, *a, node); };
        const Affected nodes =
            affected(*a, *path, [&](const NodePath& node) { return moved(node) ? 1.0 : 0.0; });
        if (nodes.place.empty()) continue;
        double way = 0;
        for (const NodePath& node : path->node)
            if (moved(node)) way = std::max(way, node.tool_way);
        Draft draft = draft_at_header(context, *a->bead);
        draft.message =
            "restraint of " + bead_name(*a->bead) +
            ": by the manual it acts against sliding; the solver takes the absolute velocity of the "
            "sheet, while the bead itself moves across by " +
            length_text(context, way) + ": up to " + ft_force_text(context, *a, nodes.ft);
        note_blank(*path, draft);
        measure_cost(context, *a, 0, nodes.ft, draft);
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule ENG006{
    {.code = "ENG006",
     .name = "restraint-against-absolute-velocity",
     .summary = "the restraint acts against the sheet's own velocity, not against sliding",
     .severity = Severity::info},
    needs_motion,
    check};

} // namespace drawbead
