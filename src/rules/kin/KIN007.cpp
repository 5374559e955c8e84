#include "rules/analysis.h"
#include "rules/kin/path_report.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const BeadPath* path = path_of(context, *a);
        if (path == nullptr || !path->blank_known() || !path->opens || a->bead->t_start <= 0) continue;
        const auto far = [](const NodePath& node) { return node.travel_before > node.element; };
        const Affected nodes =
            affected(*a, *path, [&](const NodePath& node) { return far(node) ? -1.0 : 0.0; });
        if (nodes.place.empty()) continue;
        double travel = 0, elements = 0;
        for (const NodePath& node : path->node)
            if (far(node)) {
                travel = std::max(travel, node.travel_before);
                elements = std::max(elements, node.travel_before / node.element);
            }
        Draft draft = draft_at(context, *a->bead, cells_of(*a->bead).t_start);
        for (const std::size_t i : nodes.place)
            draft.entities.nodes.add(node_id(context, *a, i));
        draft.message =
            "the sheet travels " + length_text(context, travel) + ", " + number(elements, 3) +
            " elements, past " + bead_name(*a->bead) + " before its window opens at " +
            time_text(context, a->bead->t_start) +
            "; the solver's search starts from the segments of the first cycle and comes nearer by one "
            "ring of elements per cycle, until then " +
            counted(nodes.place.size(), "node") + (nodes.place.size() == 1 ? " has" : " have") +
            " no force or that of another place: " + cost_text(context, *a, nodes.fn, nodes.ft);
        draft.notes.push_back(
            "on a folded or graded sheet the search may never come to the segment under the node");
        draft.measured.push_back({"travel", travel, unit_name(context.deck.work_units(), length_dimension)});
        measure_cost(context, *a, nodes.fn, nodes.ft, draft);
        draft.help = "leave Tstart at 0 where the distance gates the bead anyway";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule KIN007{{.code = "KIN007",
                          .name = "late-window-stale-search",
                          .summary = "the sheet travels more than an element before the window opens",
                          .severity = Severity::warning},
                         needs_motion,
                         check};

} // namespace drawbead
