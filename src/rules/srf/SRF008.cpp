#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <cmath>

namespace drawbead {

namespace {

/// Whether the solver finds no stiffness behind a segment: no element, or a material without modulus.
bool without_stiffness(const RuleContext& context, const Segment& s) {
    if (s.kind == ElementKind::none) return true;
    const Material* material = context.model.material_of(s);
    if (material == nullptr) return false; // REF has said so
    const double modulus = s.kind == ElementKind::solid ? material->bulk : material->young;
    return (material->is_void && modulus == 0) || material->stiffness == Material::Stiffness::none;
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        if (a->side.zone.empty()) continue;
        const Surface& surface = *a->surface;
        const NearMesh& near = context.analysis.surfaces[*a->bead->surface].near;
        std::vector<bool> soft(near.segment.size(), false);
        std::vector<uint32_t> found;
        for (const ZoneSegment& z : a->side.zone) {
            const uint32_t segment = near.segment_index[z.segment];
            if (!without_stiffness(context, surface.segments[segment])) continue;
            soft[z.segment] = true;
            found.push_back(segment);
        }
        if (found.empty()) continue;
        double fn = 0, ft = 0;
        for (std::size_t i = 0; i < a->hit.size(); ++i)
            if (soft[a->hit[i].closest.segment]) {
                fn -= a->fn_force(i);
                ft -= a->ft_force(i);
            }
        Draft draft;
        draft.interface_id = a->bead->id;
        draft.primary = segment_place(context, surface, found.front());
        for (const uint32_t segment : found) {
            if (segment != found.front() && draft.related.size() < 99)
                draft.related.push_back(segment_place(context, surface, segment));
            add_segment(context, surface, segment, draft.entities);
        }
        draft.place_count = found.size();
        const bool element = surface.segments[found.front()].kind != ElementKind::none;
        draft.message =
            counted(found.size(), "segment") + " of surface " + std::to_string(surface.id) + " near " +
            bead_name(*a->bead) + (found.size() == 1 ? " has " : " have ") +
            (element ? "a material without stiffness" : "no element") + " behind " +
            (found.size() == 1 ? "it (" : "them (") + segment_name(context, surface, found.front()) +
            "); the restraint is built with a stiffness of 0 there: " + cost_text(context, *a, 0, ft);
        if (fn != 0)
            draft.notes.push_back(
                "without stiffness in the surface the check of the normal force against the "
                "stiffness of the blank (message 1040) is off");
        measure_cost(context, *a, 0, ft, draft);
        if (!element) note_lost_include(context, "the elements", draft);
        draft.help = "use segments of the blank's own elements";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SRF008{{.code = "SRF008",
                          .name = "segment-without-stiffness",
                          .summary = "no element, or a void material, behind segments near a bead",
                          .severity = Severity::error},
                         needs_sides,
                         check};

} // namespace drawbead
