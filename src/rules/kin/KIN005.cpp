#include "rules/analysis.h"
#include "rules/kin/path_report.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <limits>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    const auto about = [&](double t) { return quantity(t, context.deck.work_units(), time_dimension, 2); };
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const BeadPath* path = path_of(context, *a);
        if (path == nullptr || !path->blank_known()) continue;
        const Affected nodes =
            affected(*a, *path, [](const NodePath& node) { return node.left ? -1.0 : 0.0; });
        if (nodes.place.empty()) continue;
        double first = std::numeric_limits<double>::infinity(), last = 0;
        for (const NodePath& node : path->node)
            if (node.left) {
                first = std::min(first, *node.left);
                last = std::max(last, *node.left);
            }
        Draft draft = draft_at_affected(context, *a, nodes);
        draft.message = "the rim of the sheet passes " + counted(nodes.place.size(), "node") + " of " +
                        bead_name(*a->bead) + " at about " + about(first) +
                        (last > first ? " to " + about(last) : std::string()) + "; " +
                        length_text(context, nodes.length) +
                        " of the bead let go, node by node: " + cost_text(context, *a, nodes.fn, nodes.ft);
        const UnitSystem& units = context.deck.work_units();
        draft.measured.push_back({"first node lost", first, unit_name(units, time_dimension)});
        draft.measured.push_back({"length lost", nodes.length, unit_name(units, length_dimension)});
        measure_cost(context, *a, nodes.fn, nodes.ft, draft);
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule KIN005{{.code = "KIN005",
                          .name = "leaves-the-blank",
                          .summary = "the rim of the sheet is drawn in past bead nodes",
                          .severity = Severity::info},
                         needs_motion,
                         check};

} // namespace drawbead
