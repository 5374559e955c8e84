#include "rules/lin/bead_report.h"
#include "rules/lin/list_repair.h"
#include "rules/support.h"
#include "rules/text.h"

#include <cmath>

namespace drawbead {

namespace {

constexpr const char* title = "two beads whose limits meet";

/// A loop that is joined by a node of its own; others have to be closed first.
bool can_be_split(const LineCheck& list) {
    return !list.loop_open && list.repeated.empty() && list.gaps.empty() && list.nodes > 4;
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_order(context)) {
        const LineCheck& list = a->check;
        if (!(list.walk.closed || list.loop_open || list.closed_by_repeat) || list.scrambled) continue;
        const Drawbead& b = *a->bead;
        const double fn_jump = b.fn_first != 0 && b.fn_varies() ? b.fn_first - b.fn_last : 0;
        const double ft_jump = b.ft_varies() ? b.ft_first - b.ft_last : 0;
        if (fn_jump == 0 && ft_jump == 0) continue;
        const std::size_t last = list.loop_open ? list.closing.from : a->x.size() - 1;
        const double seam = list.loop_open ? list.closing.length : list.median_hop;
        const UnitSystem& units = context.deck.work_units();
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, last);
        draft.related.push_back(places.front());
        const auto ends = [&](const char* name, double from, double to) {
            return std::string(name) + " jumps from " + number(to) + " to " +
                   quantity(from, units, force_per_length_dimension);
        };
        draft.message = bead_name(b) + " is a loop and its limits vary: at the seam between nodes " +
                        std::to_string(node_id(context, *a, last)) + " and " +
                        std::to_string(node_id(context, *a, 0)) + " " +
                        (fn_jump != 0 ? ends("Fn", b.fn_first, b.fn_last) : std::string()) +
                        (fn_jump != 0 && ft_jump != 0 ? ", " : "") +
                        (ft_jump != 0 ? ends("Ft", b.ft_first, b.ft_last) : std::string()) +
                        "; over one step " + cost_text(context, *a, fn_jump * seam, ft_jump * seam);
        draft.entities.nodes.add(node_id(context, *a, 0));
        draft.entities.nodes.add(node_id(context, *a, last));
        measure_cost(context, *a, fn_jump * seam, ft_jump * seam, draft);
        draft.help = "split the loop into two beads whose limits meet, or make the limits equal";
        if (can_be_split(list)) draft.fixes.push_back({title, FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const BeadAnalysis* a = analysed_bead(context, draft);
    if (!a || !can_be_split(a->check)) return planner.decline("the loop has to be closed first");
    // Half way round: out with the limits as they are, and back.
    uint32_t half = 1;
    while (half + 2 < a->x.size() && a->line.s[half] < 0.5 * a->line.length)
        ++half;
    LineTurn at;
    at.at = half;
    const Drawbead& bead = *a->bead;
    EndLimits out{bead.fn_first, bead.fn_last, bead.ft_first, bead.ft_last}, back = out;
    if (bead.fn_varies() && bead.fn_first != 0) std::swap(back.fn_first, back.fn_last);
    if (bead.ft_varies()) {
        back.ft_first = bead.ft_last;
        back.ft_last = never_zero(bead.ft_first, bead.ft_last);
    }
    Fix fix{title, FixAvailability::unsafe, {}};
    fix.uncovers = {"LIN"};
    if (!split_bead(context, *a, cut_at_nodes(*a, {at}), {out, back}, planner, fix)) return std::nullopt;
    return fix;
}

} // namespace

extern const Rule LIN007{{.code = "LIN007",
                          .name = "loop-with-variation",
                          .summary = "a closed bead whose limits differ at its two ends: a jump at the seam",
                          .severity = Severity::warning,
                          .fix = FixAvailability::unsafe},
                         needs_closest,
                         check,
                         needs_list_users,
                         fix};

} // namespace drawbead
