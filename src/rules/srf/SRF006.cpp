#include "geometry/segment_shape.h"
#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

/// Whether the segment has no area to speak of: repeated nodes beyond a triangle, or all corners on a line.
bool degenerate(const Corners& c, double flat) {
    double longest = 0;
    for (std::size_t k = 0; k < 4; ++k)
        longest = std::max(longest, squared_norm(c[(k + 1) % 4] - c[k]));
    return !(area(c) > flat * longest);
}

void check(const RuleContext& context, FindingSink& sink) {
    for (std::size_t s = 0; s < context.analysis.surfaces.size(); ++s) {
        const NearMesh& near = context.analysis.surfaces[s].near;
        std::vector<uint32_t> found;
        for (uint32_t i = 0; i < near.segment.size(); ++i)
            if (degenerate(near.corners(i), context.limits.SRF006_flat_area)) found.push_back(i);
        if (found.empty()) continue;
        const Surface& surface = context.model.surfaces()[s];
        double fn = 0, total = 0;
        for (const BeadAnalysis& a : context.analysis.beads)
            for (std::size_t i = 0; a.surface == &surface && i < a.hit.size(); ++i) {
                total += std::abs(a.fn_force(i));
                if (std::binary_search(found.begin(), found.end(), a.hit[i].closest.segment))
                    fn += a.fn_force(i);
            }
        Draft draft;
        draft.surface_id = surface.id;
        draft.discriminator = "surface " + std::to_string(surface.id);
        for (const uint32_t i : found) {
            const Span place = segment_place(context, surface, near.segment_index[i]);
            if (i == found.front())
                draft.primary = place;
            else if (draft.related.size() < 99)
                draft.related.push_back(place);
            add_segment(context, surface, near.segment_index[i], draft.entities);
        }
        draft.place_count = found.size();
        const UnitSystem& units = context.deck.work_units();
        draft.message =
            counted(found.size(), "segment") + " of surface " + std::to_string(surface.id) +
            " near its beads " + (found.size() == 1 ? "has" : "have") + " no area (" +
            segment_name(context, surface, near.segment_index[found.front()]) +
            "); the solver divides by it for a bead node there: " + quantity(fn, units, force_dimension) +
            " of Fn, " + number(total != 0 ? 100 * fn / total : 0, 3) + " % of the total, at the start";
        draft.measured.push_back({"normal force", fn, unit_name(units, force_dimension)});
        draft.help = "correct the nodes of these segments, or take the segments out of the surface";
        draft.fixes.push_back({"drop the segments", FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SRF006{{.code = "SRF006",
                          .name = "degenerate-segment",
                          .summary = "main segments without area near a bead",
                          .severity = Severity::error,
                          .fix = FixAvailability::unsafe},
                         needs_sides,
                         check};

} // namespace drawbead
