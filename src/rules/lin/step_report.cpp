#include "rules/lin/step_report.h"

#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

void report_steps(const RuleContext& context, const BeadAnalysis& a, const std::vector<LineHop>& hops,
                  bool longest, const StepWords& words, FindingSink& sink) {
    if (hops.empty()) return;
    const auto extent = [&](const LineHop& h) { return longest ? h.length / h.usual : h.usual / h.length; };
    const LineHop& worst = *std::max_element(
        hops.begin(), hops.end(), [&](const LineHop& p, const LineHop& q) { return extent(p) < extent(q); });
    // The most that one node of these steps puts on the segment under it.
    double fn = 0, ft = 0;
    for (const LineHop& h : hops)
        for (const uint32_t i : {h.from, h.to}) {
            if (std::abs(a.fn_force(i)) > std::abs(fn)) fn = a.fn_force(i);
            if (std::abs(a.ft_force(i)) > std::abs(ft)) ft = a.ft_force(i);
        }
    const UnitSystem& units = context.deck.work_units();
    const std::vector<Span> places = list_places(context, a);
    Draft draft = draft_at_position(context, a, places, worst.to);
    draft.message = counted(hops.size(), "step") + " of " + bead_name(*a.bead) + " " +
                    (hops.size() == 1 ? "is " : "are ") + words.what + " (from node " +
                    std::to_string(node_id(context, a, worst.from)) + " to node " +
                    std::to_string(node_id(context, a, worst.to)) + " " +
                    quantity(worst.length, units, length_dimension) + ", " + words.usual + " " +
                    quantity(worst.usual, units, length_dimension) + "); " + words.consequence + " " +
                    force_text(context, a, fn, ft);
    for (const LineHop& h : hops) {
        if (&h != &worst && draft.related.size() < 99) draft.related.push_back(places[h.to]);
        draft.entities.nodes.add(node_id(context, a, h.from));
        draft.entities.nodes.add(node_id(context, a, h.to));
    }
    draft.place_count = hops.size();
    draft.measured.push_back({"step", worst.length, unit_name(units, length_dimension)});
    draft.measured.push_back({words.usual, worst.usual, unit_name(units, length_dimension)});
    measure_cost(context, a, fn, ft, draft);
    draft.help = words.help;
    sink.add(std::move(draft));
}

} // namespace drawbead
