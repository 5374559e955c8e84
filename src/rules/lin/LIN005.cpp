#include "rules/lin/bead_report.h"
#include "rules/lin/list_repair.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

namespace {

constexpr const char* title = "one interface and group per side";

/// Whether there are sides between the corners. Corners at neighbouring nodes are a curve with too few nodes.
bool has_sides(const BeadAnalysis& a) {
    const std::vector<std::vector<uint32_t>> sides = cut_at_nodes(a, a.check.corners);
    return !a.check.loop_open &&
           std::all_of(sides.begin(), sides.end(),
                       [](const std::vector<uint32_t>& side) { return side.size() > 2; });
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_order(context)) {
        const std::vector<LineTurn>& corners = a->check.corners;
        if (corners.empty()) continue;
        double fn = 0, ft = 0, lost = 0;
        for (const LineTurn& corner : corners) {
            fn -= a->fn[corner.at] * corner.lost;
            ft -= a->ft[corner.at] * corner.lost;
            lost += corner.lost;
        }
        const LineTurn& worst =
            *std::max_element(corners.begin(), corners.end(),
                              [](const LineTurn& p, const LineTurn& q) { return p.degrees < q.degrees; });
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, worst.at);
        draft.message = bead_name(*a->bead) + " turns by " + number(worst.degrees, 3) + " degrees at node " +
                        std::to_string(node_id(context, *a, worst.at));
        if (corners.size() > 1)
            draft.message += " (the sharpest of " + std::to_string(corners.size()) + " corners)";
        draft.message +=
            "; the chord over a corner is shorter than the bead: " + cost_text(context, *a, fn, ft);
        for (const LineTurn& corner : corners) {
            if (&corner != &worst) draft.related.push_back(places[corner.at]);
            draft.entities.nodes.add(node_id(context, *a, corner.at));
        }
        draft.measured.push_back({"turn", worst.degrees, "degrees"});
        draft.measured.push_back(
            {"lost length", lost, unit_name(context.deck.work_units(), length_dimension)});
        measure_cost(context, *a, fn, ft, draft);
        draft.help = "round the corner with more nodes, or split the bead there";
        if (has_sides(*a)) draft.fixes.push_back({title, FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const BeadAnalysis* a = analysed_bead(context, draft);
    if (!a) return planner.decline("the interface has no list of nodes");
    if (a->check.loop_open) return planner.decline("the loop has to be closed first");
    if (!has_sides(*a))
        return planner.decline("corners at neighbouring nodes are a curve that needs more nodes");
    const std::vector<std::vector<uint32_t>> sides = cut_at_nodes(*a, a->check.corners);
    Fix fix{title, FixAvailability::unsafe, {}};
    fix.uncovers = {"LIN"};
    if (!split_bead(context, *a, sides, present_limits(*a, sides), planner, fix)) return std::nullopt;
    return fix;
}

} // namespace

extern const Rule LIN005{{.code = "LIN005",
                          .name = "sharp-corner",
                          .summary = "the bead turns so sharply that the chords of its nodes lose length",
                          .severity = Severity::warning,
                          .fix = FixAvailability::unsafe},
                         needs_closest,
                         check,
                         needs_list_users,
                         fix};

} // namespace drawbead
