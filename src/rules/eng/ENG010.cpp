#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/stb/blank.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

/// How much of a node's force depends on the segment that was taken: 1 where only one of the two laws has a
/// contact, else the shift of the ramp over DEPTH.
double share_at_stake(const BeadNodeContact& n, const ClosestHit& closest, double depth) {
    if (n.segment == n.closest || closest.on_free_edge) return 0; // beside a rim: SRF009
    if (n.inside != n.exact.in_contact_range()) return 1;
    if (!n.inside || depth <= 0) return 0;
    return std::min(std::abs(n.distance - n.exact.d) / depth, 1.0);
}

void check(const RuleContext& context, FindingSink& sink) {
    const UnitSystem& units = context.deck.work_units();
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const InterfaceContact* first = first_cycle(context, *a);
        if (first == nullptr) continue;
        std::vector<std::size_t> found;
        double fn = 0, ft = 0, worst = 0;
        std::size_t worst_node = 0;
        for (std::size_t i = 0; i < a->x.size(); ++i) {
            const double share = share_at_stake(first->contact.node[i], a->hit[i].closest, a->bead->depth);
            if (share == 0) continue;
            found.push_back(i);
            fn += share * std::abs(a->fn_force(i));
            ft += share * std::abs(a->ft_force(i));
            if (share > worst) worst = share, worst_node = i;
        }
        const double of_total = std::max(a->fn_total != 0 ? fn / std::abs(a->fn_total) : 0,
                                         a->ft_total != 0 ? ft / std::abs(a->ft_total) : 0);
        if (of_total < context.limits.ENG010_least_share) continue;
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, worst_node);
        for (const std::size_t i : found) {
            draft.entities.nodes.add(node_id(context, *a, i));
            if (i != worst_node && draft.related.size() < 99) draft.related.push_back(places[i]);
        }
        draft.place_count = found.size();
        if (of_total > context.limits.ENG010_warning_share) draft.severity = Severity::warning;
        const BeadNodeContact& n = first->contact.node[worst_node];
        draft.message =
            counted(found.size(), "node") + " of " + bead_name(*a->bead) +
            ": by the manual the closest segment counts; the solver searches along neighbours (node " +
            std::to_string(node_id(context, *a, worst_node)) + ": closest " +
            segment_name(context, *a->surface, n.closest) + " at " +
            quantity(n.exact.d, units, length_dimension, 3) + ", taken " +
            segment_name(context, *a->surface, n.segment) +
            (n.inside ? " at " + quantity(n.distance, units, length_dimension, 3)
                      : std::string(", beside it")) +
            "): " + force_text(context, *a, fn, ft);
        measure_cost(context, *a, fn, ft, draft);
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule ENG010{{.code = "ENG010",
                          .name = "segment-not-the-closest",
                          .summary = "bead nodes meet another segment in the solver than the closest one",
                          .severity = Severity::info},
                         needs_first_cycle,
                         check};

} // namespace drawbead
