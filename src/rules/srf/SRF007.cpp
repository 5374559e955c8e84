#include "contact/solver_search.h"
#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace drawbead {

namespace {

struct Misplaced {
    std::size_t node;
    double by;    ///< distance of the solver's point from the exact one; of an element when lost
    double share; ///< of the force that goes to the wrong nodes of the segment; 1 when it is lost
    bool lost;
};

void check(const RuleContext& context, FindingSink& sink) {
    const UnitSystem& units = context.deck.work_units();
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        if (a->hit.empty()) continue;
        const NearMesh& near = context.analysis.surfaces[*a->bead->surface].near;
        std::vector<Misplaced> found;
        for (std::size_t i = 0; i < a->hit.size(); ++i) {
            const ClosestHit& exact = a->hit[i].closest;
            if (!exact.found() || !exact.foot.inside() || !(a->hit[i].element > 0)) continue;
            const Corners c = near.corners(exact.segment);
            if (is_triangle(c)) continue; // weights of triangles are exact
            const SolverHit solver = solver_project(c, false, a->x[i]);
            const Vec3 point = patch_point(c, solver.xi, solver.eta);
            const double by = norm(point - exact.foot.point);
            if (solver.inside && !(by > context.limits.SRF007_misplaced_elements * a->hit[i].element))
                continue;
            const std::array<double, 4> h = bilinear_weights(exact.foot.xi, exact.foot.eta);
            double share = 0;
            for (std::size_t k = 0; k < 4; ++k)
                share += std::abs(h[k] - solver.h[k]) / 2;
            found.push_back({i, by, solver.inside ? share : 1, !solver.inside});
        }
        if (found.empty()) continue;
        const auto worst = std::max_element(found.begin(), found.end(), [](const auto& p, const auto& q) {
            return p.lost != q.lost ? q.lost : p.by < q.by;
        });
        std::vector<uint32_t> segments;
        double fn = 0, ft = 0;
        for (const Misplaced& m : found) {
            segments.push_back(a->hit[m.node].segment);
            fn += m.share * a->fn_force(m.node);
            ft += m.share * a->ft_force(m.node);
        }
        std::sort(segments.begin(), segments.end());
        segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
        Draft draft;
        draft.interface_id = a->bead->id;
        const uint32_t segment_of_worst = a->hit[worst->node].segment;
        draft.primary = segment_place(context, *a->surface, segment_of_worst);
        for (const uint32_t segment : segments) {
            if (segment != segment_of_worst && draft.related.size() < 99)
                draft.related.push_back(segment_place(context, *a->surface, segment));
            add_segment(context, *a->surface, segment, draft.entities);
        }
        draft.place_count = segments.size();
        draft.message = counted(segments.size(), "distorted segment") + " of surface " +
                        std::to_string(a->surface->id) + " under " + bead_name(*a->bead) +
                        ": the solver places node " + std::to_string(node_id(context, *a, worst->node));
        if (worst->lost)
            draft.message += " outside of " + segment_name(context, *a->surface, segment_of_worst) +
                             ", where it has no force";
        else
            draft.message += " " + quantity(worst->by, units, length_dimension, 3) + " (" +
                             number(100 * worst->by / a->hit[worst->node].element, 3) +
                             " % of the element) from its closest point on " +
                             segment_name(context, *a->surface, segment_of_worst);
        draft.message += "; on the wrong nodes: " + force_text(context, *a, fn, ft);
        if (!worst->lost)
            draft.measured.push_back({"misplacement", worst->by, unit_name(units, length_dimension)});
        measure_cost(context, *a, fn, ft, draft);
        draft.help = "mesh the blank more evenly under the bead";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SRF007{{.code = "SRF007",
                          .name = "distorted-segment",
                          .summary = "segments under the bead on which the solver misplaces the force",
                          .severity = Severity::warning},
                         needs_closest,
                         check};

} // namespace drawbead
