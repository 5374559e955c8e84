#include "rules/lin/bead_report.h"
#include "rules/lin/list_repair.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

constexpr const char* title = "list the nodes in walking order";

/// What the nodes carry too much or too little, against the list in walking order: a sum of sizes, since the
/// totals of the two may well be alike.
Forces misplaced(const BeadAnalysis& a) {
    Forces sum;
    const LineWalk& walk = a.check.walk;
    std::vector<Vec3> x;
    for (const uint32_t i : walk.order)
        x.push_back(a.x[i]);
    const BeadLine line = bead_line(x);
    const Drawbead& b = *a.bead;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double fn = normal_limit_along(b.fn_first, b.fn_last, line.s[i], line.length);
        const double ft = limit_along(b.ft_first, b.ft_last, line.s[i], line.length);
        sum.fn += std::abs(a.fn_force(walk.order[i]) - fn * line.tributary[i]);
        sum.ft += std::abs(a.ft_force(walk.order[i]) - ft * line.tributary[i]);
    }
    return sum;
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_order(context)) {
        if (!a->check.scrambled) continue;
        const LineWalk& walk = a->check.walk;
        const auto [fn, ft] = misplaced(*a);
        const UnitSystem& units = context.deck.work_units();

        // Where the list first leaves the walk.
        std::size_t first = 1;
        while (first + 1 < walk.order.size() && walk.order[first] == walk.order[0] + first)
            ++first;
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, std::min(first, places.size() - 1));
        draft.message = "the list of " + bead_name(*a->bead) + " is not a walk along it: " +
                        quantity(a->check.list_length, units, length_dimension) + " from node to node, " +
                        quantity(walk.length, units, length_dimension) +
                        " along the line; nodes carry the wrong lengths, too much or too little by " +
                        force_text(context, *a, fn, ft);
        for (std::size_t i = 0; i < a->x.size(); ++i)
            draft.entities.nodes.add(node_id(context, *a, i));
        draft.measured.push_back(
            {"length of the list", a->check.list_length, unit_name(units, length_dimension)});
        draft.measured.push_back({"length of the walk", walk.length, unit_name(units, length_dimension)});
        measure_cost(context, *a, fn, ft, draft);
        std::string order;
        for (std::size_t i = 0; i < std::min<std::size_t>(walk.order.size(), 8); ++i)
            order += (i == 0 ? "" : " ") + std::to_string(node_id(context, *a, walk.order[i]));
        if (walk.order.size() > 8) order += " and on";
        draft.help = "list the nodes as they stand along the bead: " + order;
        if (list_is_whole(*a))
            draft.fixes.push_back(
                {title, walk_is_safe(a->check, *a->bead) ? FixAvailability::safe : FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const BeadAnalysis* a = analysed_bead(context, draft);
    if (!a || !a->check.scrambled) return planner.decline("the interface has no list of nodes");
    if (!list_is_whole(*a)) return planner.decline(missing_nodes_first);
    Fix fix{title, walk_is_safe(a->check, *a->bead) ? FixAvailability::safe : FixAvailability::unsafe, {}};
    fix.uncovers = hidden_by_list(); // hops and turns of a wrong walk mean nothing
    if (!set_list(context, *a, whole_walk(a->check), planner, fix)) return std::nullopt;
    return fix;
}

} // namespace

extern const Rule LIN002{{.code = "LIN002",
                          .name = "line-scrambled",
                          .summary = "the order of the list is not a walk along the bead",
                          .severity = Severity::error,
                          .fix = FixAvailability::sometimes_safe},
                         needs_closest,
                         check,
                         needs_list_users,
                         fix};

} // namespace drawbead
