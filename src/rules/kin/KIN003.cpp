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
        const auto sideways = [&](const NodePath& node) { return moves_sideways(context, *a, node); };
        const Affected nodes =
            affected(*a, *path, [&](const NodePath& node) { return sideways(node) ? 1.0 : 0.0; });
        if (nodes.place.empty()) continue;
        double way = 0, slide = 0, speed = 0;
        for (const NodePath& node : path->node)
            if (sideways(node)) {
                way = std::max(way, node.tool_way);
                slide = std::max(slide, node.slide_way);
                speed = std::max(speed, node.tool_speed);
            }
        Draft draft = draft_at_header(context, *a->bead);
        for (const std::size_t i : nodes.place)
            draft.entities.nodes.add(node_id(context, *a, i));
        draft.message =
            "the tool carries " + counted(nodes.place.size(), "node") + " of " + bead_name(*a->bead) +
            " sideways by " + length_text(context, way) + " at up to " + speed_text(context, speed) +
            " while they hold the sheet; the solver restrains the sheet's own motion and does not "
            "subtract the bead's" +
            (path->blank_known() ? ", where the sheet slides past the bead by " + length_text(context, slide)
                                 : std::string()) +
            ": " + ft_force_text(context, *a, nodes.ft);
        note_blank(*path, draft);
        const UnitSystem& units = context.deck.work_units();
        draft.measured.push_back({"sideways way", way, unit_name(units, length_dimension)});
        draft.measured.push_back(
            {"sideways speed", speed,
             unit_name(units, length_dimension) + "/" + unit_name(units, time_dimension)});
        measure_cost(context, *a, 0, nodes.ft, draft);
        draft.help = "let the tool with the bead stand still sideways and move the other tools and the sheet";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule KIN003{{.code = "KIN003",
                          .name = "bead-moves",
                          .summary = "the tool carries the bead sideways, which the solver does not see",
                          .severity = Severity::error},
                         needs_motion,
                         check};

} // namespace drawbead
