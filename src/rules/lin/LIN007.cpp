#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <cmath>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_order(context)) {
        const LineCheck& list = a->check;
        if (!(list.walk.closed || list.loop_open || list.closed_by_repeat) || list.scrambled) continue;
        const Drawbead& b = *a->bead;
        const double fn_jump = b.fn_first != 0 && b.fn_varies() ? b.fn_first - b.fn_last : 0;
        const double ft_jump = b.ft_varies() ? b.ft_first - b.ft_last : 0;
        if (fn_jump == 0 && ft_jump == 0) continue;
        const std::size_t last = a->x.size() - 1;
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
        draft.fixes.push_back({"split into two beads whose limits meet", FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule LIN007{{.code = "LIN007",
                          .name = "loop-with-variation",
                          .summary = "a closed bead whose limits differ at its two ends: a jump at the seam",
                          .severity = Severity::warning,
                          .fix = FixAvailability::unsafe},
                         needs_closest,
                         check};

} // namespace drawbead
