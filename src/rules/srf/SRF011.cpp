#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

/// Property types whose segments take the thickness of the element.
bool takes_element_thickness(const Property& p) {
    return p.type == 17 || p.type == 51 || p.type == 52;
}

void check(const RuleContext& context, FindingSink& sink) {
    const UnitSystem& units = context.deck.work_units();
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const double depth = a->bead->depth;
        if (depth <= 0) continue; // no gate by distance: PAR003
        std::vector<uint32_t> segments;
        double fn = 0, ft = 0, worst = 0, own_of_worst = 0, property_of_worst = 0;
        for (std::size_t i = 0; i < a->hit.size(); ++i) {
            if (a->hit[i].segment == no_segment) continue;
            const Segment& s = a->surface->segments[a->hit[i].segment];
            const Property* property = context.model.property_of(s);
            const double own = context.model.own_thickness(s);
            if (property == nullptr || !property->has_thickness || own <= 0 ||
                takes_element_thickness(*property))
                continue;
            const double shift = (own - property->thickness) / 2; // of where the ramp starts
            if (std::abs(shift) <= context.limits.SRF011_least_share * property->thickness) continue;
            segments.push_back(a->hit[i].segment);
            const double share = std::min(std::abs(shift) / depth, 1.0);
            fn += share * std::abs(a->fn_force(i));
            ft += share * std::abs(a->ft_force(i));
            if (std::abs(shift) > std::abs(worst))
                worst = shift, own_of_worst = own, property_of_worst = property->thickness;
        }
        if (segments.empty()) continue;
        std::sort(segments.begin(), segments.end());
        segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
        Draft draft;
        draft.interface_id = a->bead->id;
        for (const uint32_t segment : segments) {
            const Span place = segment_place(context, *a->surface, segment);
            if (segment == segments.front())
                draft.primary = place;
            else if (draft.related.size() < 99)
                draft.related.push_back(place);
            add_segment(context, *a->surface, segment, draft.entities);
        }
        draft.place_count = segments.size();
        draft.message =
            counted(segments.size(), "element") + " under " + bead_name(*a->bead) +
            (segments.size() == 1 ? " has" : " have") + " a thickness of " +
            (segments.size() == 1 ? "its" : "their") + " own, which the bead ignores (at most " +
            quantity(own_of_worst, units, length_dimension) + " against " +
            quantity(property_of_worst, units, length_dimension) + " of the property): the ramp starts " +
            quantity(std::abs(worst), units, length_dimension) + (worst > 0 ? " too late" : " too early") +
            ", on it " +
            (a->bead->fn_first != 0 ? force_text(context, *a, fn, ft) : force_text(context, *a, 0, 0));
        if (a->bead->fn_first == 0) {
            draft.notes.push_back("without Fn the restraint has no ramp; it switches on that much " +
                                  std::string(worst > 0 ? "later" : "earlier"));
            ft = 0;
        }
        if (std::abs(worst) < context.limits.SRF011_warning_share * depth) draft.severity = Severity::info;
        draft.measured.push_back({"shift of the ramp", worst, unit_name(units, length_dimension)});
        measure_cost(context, *a, fn, ft, draft);
        draft.help = "give such elements a property of their own with this thickness";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SRF011{{.code = "SRF011",
                          .name = "element-thickness-ignored",
                          .summary = "elements under the bead have a thickness that TYPE8 does not look at",
                          .severity = Severity::warning},
                         needs_closest | Needs::element_thickness,
                         check};

} // namespace drawbead
