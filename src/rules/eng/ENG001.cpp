#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const Drawbead& bead = *a->bead;
        constexpr int first_layout_with_depth = 130;
        if (bead.depth > 0 || a->hit.empty() || (a->fn_total == 0 && a->ft_total == 0)) continue;
        if (scope_of(context.deck, bead).layout < first_layout_with_depth) continue;
        double fn = 0, ft = 0; // where the bead does not touch the sheet
        for (std::size_t i = 0; i < a->hit.size(); ++i) {
            const Property* property = context.model.property_of(a->surface->segments[a->hit[i].segment]);
            const double half = property != nullptr && property->has_thickness ? property->thickness / 2 : 0;
            if (!a->hit[i].closest.in_contact_range() || a->hit[i].closest.foot.distance <= half) continue;
            fn += a->fn_force(i);
            ft += a->ft_force(i);
        }
        Draft draft = draft_at(context, bead, cells_of(bead).depth);
        draft.message = "DEPTH of " + bead_name(bead) + ", " +
                        quantity(bead.depth, context.deck.work_units(), length_dimension) +
                        ": by the manual only the slope becomes the stiffness of the sheet, the solver drops "
                        "the distance from its law; before the bead touches the sheet: " +
                        cost_text(context, *a, fn, ft);
        measure_cost(context, *a, fn, ft, draft);
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule ENG001{
    {.code = "ENG001",
     .name = "gate-lost-without-depth",
     .summary = "without DEPTH the manual replaces a slope, the solver drops the gate by distance",
     .severity = Severity::info},
    needs_closest,
    check};

} // namespace drawbead
