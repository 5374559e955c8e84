#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    const UnitSystem& units = context.deck.work_units();
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        std::vector<std::size_t> found;
        double fn = 0, ft = 0;
        for (std::size_t i = 0; i < a->hit.size(); ++i) {
            if (a->hit[i].other_layer == no_segment) continue;
            found.push_back(i);
            fn += a->fn_force(i);
            ft += a->ft_force(i);
        }
        if (found.empty()) continue;
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, found.front());
        for (const std::size_t i : found) {
            draft.entities.nodes.add(node_id(context, *a, i));
            if (i != found.front() && draft.related.size() < 99) draft.related.push_back(places[i]);
        }
        draft.place_count = found.size();
        const BeadHit& h = a->hit[found.front()];
        draft.message =
            counted(found.size(), "node") + " of " + bead_name(*a->bead) +
            (found.size() == 1 ? " meets" : " meet") + " more than one layer of surface " +
            std::to_string(a->surface->id) + " (node " + std::to_string(node_id(context, *a, found.front())) +
            ": " + segment_name(context, *a->surface, h.segment) + " at " +
            quantity(h.closest.d, units, length_dimension, 3) + ", " +
            segment_name(context, *a->surface, h.other_layer) + " at " +
            quantity(h.other_layer_distance, units, length_dimension, 3) +
            "); the solver keeps to the one that its search starts on: " + force_text(context, *a, fn, ft);
        draft.measured.push_back({"distance", h.closest.d, unit_name(units, length_dimension)});
        draft.measured.push_back(
            {"distance of the other layer", h.other_layer_distance, unit_name(units, length_dimension)});
        measure_cost(context, *a, fn, ft, draft);
        draft.help = "use a surface of the one layer that the bead presses";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SRF010{
    {.code = "SRF010",
     .name = "several-layers",
     .summary = "the main surface has a second layer at a similar distance from the bead",
     .severity = Severity::warning},
    needs_layers,
    check};

} // namespace drawbead
