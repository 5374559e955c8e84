#include "rules/lin/bead_report.h"
#include "rules/lin/list_repair.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

namespace {

constexpr const char* title = "one interface and group per piece";

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_order(context)) {
        const std::vector<LineHop>& gaps = a->check.gaps;
        if (gaps.empty()) continue;
        const LineHop& longest = *std::max_element(
            gaps.begin(), gaps.end(), [](const LineHop& p, const LineHop& q) { return p.length < q.length; });
        const Forces apart = forces_of_pieces(*a, list_pieces(*a));
        const double fn = a->fn_total - apart.fn, ft = a->ft_total - apart.ft;
        const UnitSystem& units = context.deck.work_units();

        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, longest.to);
        std::string more;
        if (gaps.size() > 1) more = " (the longest of " + std::to_string(gaps.size()) + " gaps)";
        draft.message = "step of " + quantity(longest.length, units, length_dimension) + " from node " +
                        std::to_string(node_id(context, *a, longest.from)) + " to node " +
                        std::to_string(node_id(context, *a, longest.to)) + " of " + bead_name(*a->bead) +
                        more + ", " + number(longest.length / longest.usual, 3) + " times the " +
                        quantity(longest.usual, units, length_dimension) +
                        " around it; the nodes at both ends carry the gap as bead length: " +
                        cost_text(context, *a, fn, ft);
        for (const LineHop& gap : gaps) {
            if (&gap != &longest) draft.related.push_back(places[gap.to]);
            draft.entities.nodes.add(node_id(context, *a, gap.from));
            draft.entities.nodes.add(node_id(context, *a, gap.to));
        }
        draft.measured.push_back({"longest step", longest.length, unit_name(units, length_dimension)});
        draft.measured.push_back({"usual step", longest.usual, unit_name(units, length_dimension)});
        measure_cost(context, *a, fn, ft, draft);
        draft.help = "give each of the " + std::to_string(gaps.size() + 1) +
                     " pieces an interface and a group of its own";
        if (list_is_whole(*a) && pieces_are_lines(*a, list_pieces(*a)))
            draft.fixes.push_back(
                {title, limits_are_constant(*a->bead) ? FixAvailability::safe : FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const BeadAnalysis* a = analysed_bead(context, draft);
    if (!a) return planner.decline("the interface has no list of nodes");
    if (!list_is_whole(*a)) return planner.decline(missing_nodes_first);
    const std::vector<std::vector<uint32_t>> pieces = list_pieces(*a);
    if (!pieces_are_lines(*a, pieces)) return planner.decline("a piece of one node is no line");
    Fix fix{title, limits_are_constant(*a->bead) ? FixAvailability::safe : FixAvailability::unsafe, {}};
    fix.uncovers = hidden_by_list();
    if (!split_bead(context, *a, pieces, present_limits(*a, pieces), planner, fix)) return std::nullopt;
    return fix;
}

} // namespace

extern const Rule LIN001{{.code = "LIN001",
                          .name = "line-has-gap",
                          .summary = "a step along the bead is much longer than its neighbours",
                          .severity = Severity::error,
                          .fix = FixAvailability::sometimes_safe},
                         needs_closest,
                         check,
                         needs_list_users,
                         fix};

} // namespace drawbead
