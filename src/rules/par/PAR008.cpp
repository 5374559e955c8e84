#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    const double thinnest = context.limits.PAR008_least_thicknesses,
                 thickest = context.limits.PAR008_most_thicknesses;
    const UnitSystem& units = context.deck.work_units();
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const double depth = a->bead->depth;
        if (!(depth > 0)) continue; // PAR003
        double thickness = 0;
        for (const BeadHit& h : a->hit)
            if (h.segment != no_segment)
                if (const Property* p = context.model.property_of(a->surface->segments[h.segment]);
                    p != nullptr && p->has_thickness && p->thickness > 0 &&
                    (thickness == 0 || p->thickness < thickness))
                    thickness = p->thickness;
        if (thickness == 0) continue;
        const double ratio = depth / thickness;
        if (ratio >= thinnest && ratio <= thickest) continue;
        // What stands in reach already: full or part of its force without any closing.
        double fn = 0, ft = 0;
        for (std::size_t i = 0; i < a->hit.size(); ++i)
            if (a->hit[i].closest.in_contact_range() && a->hit[i].closest.d < depth + thickness / 2) {
                fn += a->fn_force(i);
                ft += a->ft_force(i);
            }
        Draft draft = draft_at(context, *a->bead, cells_of(*a->bead).depth);
        draft.message =
            "DEPTH of " + bead_name(*a->bead) + " is " + quantity(depth, units, length_dimension) + ", " +
            number(ratio, 3) + " times the sheet's thickness of " +
            quantity(thickness, units, length_dimension) + "; " +
            (ratio < thinnest ? "the force comes within a fraction of the thickness, almost at once"
                              : "the bead acts long before the tool touches the sheet") +
            "; in reach at the start: " + force_text(context, *a, fn, ft);
        draft.measured.push_back({"depth over thickness", ratio, ""});
        measure_cost(context, *a, fn, ft, draft);
        draft.help = "DEPTH is the height of the real bead, a few times the thickness of the sheet";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule PAR008{{.code = "PAR008",
                          .name = "implausible-depth",
                          .summary = "DEPTH is out of proportion to the thickness of the sheet",
                          .severity = Severity::warning},
                         needs_closest,
                         check};

} // namespace drawbead
