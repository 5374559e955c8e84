#include "rules/analysis.h"
#include "rules/kin/path_report.h"
#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    const auto about = [&](double t) { return quantity(t, context.deck.work_units(), time_dimension, 2); };
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const Drawbead& bead = *a->bead;
        const BeadPath* path = path_of(context, *a);
        if (path == nullptr || bead.iform == 1 || bead.depth <= 0 || a->ft_total == 0) continue;
        const auto lifts = [&](const NodePath& node) {
            return node.lift && node.lift->height > context.limits.KIN006_lift_depths * bead.depth;
        };
        const Affected nodes =
            affected(*a, *path, [&](const NodePath& node) { return lifts(node) ? 1.0 : 0.0; });
        if (nodes.place.empty()) continue;
        const NodePath::Lift* worst = nullptr;
        for (const NodePath& node : path->node)
            if (lifts(node) && (worst == nullptr || node.lift->height > worst->height)) worst = &*node.lift;
        Draft draft = draft_at_header(context, bead);
        for (const std::size_t i : nodes.place)
            draft.entities.nodes.add(node_id(context, *a, i));
        draft.message =
            counted(nodes.place.size(), "node") + " of " + bead_name(bead) +
            (nodes.place.size() == 1 ? " lifts" : " lift") + " off by up to " +
            length_text(context, worst->height) + " at about " + about(worst->off) + " and " +
            (nodes.place.size() == 1 ? "comes" : "come") + " back at " + about(worst->back) +
            "; with Iform 2 the restraint that they had stored acts again at once, against a sheet "
            "that has not moved: up to " +
            ft_force_text(context, *a, nodes.ft);
        note_blank(*path, draft);
        draft.measured.push_back(
            {"lift", worst->height, unit_name(context.deck.work_units(), length_dimension)});
        measure_cost(context, *a, 0, nodes.ft, draft);
        draft.help = "give each closing a bead of its own, with a window from its Tstart to its Tstop";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule KIN006{
    {.code = "KIN006",
     .name = "stale-stick",
     .summary = "bead nodes lift off and come back with the restraint that they had stored",
     .severity = Severity::warning},
    needs_motion,
    check};

} // namespace drawbead
