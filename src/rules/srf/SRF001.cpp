#include "rules/lin/bead_report.h"
#include "rules/srf/surface_fix.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drawbead {

namespace {

/// A segment that faces away, with the distance of a bead node over it.
struct Away {
    uint32_t segment = 0; ///< index in the surface
    bool start = false;
    double from_line = 0, d = 0;
};

/// Segments under bead nodes first, those nearest to the bead first among them; then by distance from the
/// line.
std::vector<Away> segments_away(const Model& model, const BeadAnalysis& a, const NearMesh& near) {
    std::vector<double> d(near.segment.size(), -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < a.hit.size(); ++i)
        if (a.side.node[i] == Facing::away) {
            double& nearest = d[a.hit[i].closest.segment];
            nearest = std::max(nearest, a.hit[i].closest.d);
        }
    std::vector<Away> away;
    for (const ZoneSegment& z : a.side.zone)
        if (z.facing == Facing::away)
            away.push_back(
                {near.segment_index[z.segment], z.start, z.distance, z.start ? d[z.segment] : z.d});
    const auto id = [&](const Away& one) { // does not depend on the order in the deck
        return value(model.element_id(a.surface->segments[one.segment]));
    };
    std::sort(away.begin(), away.end(), [&](const Away& p, const Away& q) {
        if (p.start != q.start) return p.start;
        if (p.start && p.d != q.d) return p.d > q.d;
        if (p.from_line != q.from_line) return p.from_line < q.from_line;
        return std::pair(id(p), p.segment) < std::pair(id(q), q.segment);
    });
    return away;
}

std::string consequence(const RuleContext& context, const BeadAnalysis& a, bool any_start, double fn,
                        double ft) {
    const Drawbead& b = *a.bead;
    if (b.fn_first == 0 && b.depth <= 0)
        return "; without DEPTH and Fn no force depends on the side: 0 N, 0 % of its total";
    const bool pulls = b.fn_first != 0;
    const std::string force = pulls ? "full Fn" : "full Ft";
    if (!any_start)
        return "; none of them is under a bead node at the start (0 N, 0 % of its total), " + force +
               " acts at any distance where the blank moves there";
    const double cost = pulls ? fn : ft, total = pulls ? a.fn_total : a.ft_total;
    return "; " + force + " acts at any distance" + (pulls ? " and pulls the blank to the bead: +" : ": +") +
           quantity(cost, context.deck.work_units(), force_dimension) + ", " +
           number(total != 0 ? 100 * cost / total : 0, 3) + " % of its total";
}

void offer(const Surface& surface, std::string title, Draft& draft) {
    if (offers_surface_fix(surface)) draft.fixes.push_back({std::move(title), FixAvailability::safe});
}

void check(const RuleContext& context, FindingSink& sink) {
    constexpr std::size_t most_places = 100;
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        if (a->side.zone.empty()) continue;
        const Surface& surface = *a->surface;
        const std::vector<Away> away =
            segments_away(context.model, *a, context.analysis.surfaces[*a->bead->surface].near);
        if (away.empty()) continue;

        Draft draft;
        draft.interface_id = a->bead->id;
        draft.surface_id = surface.id;
        double fn = 0, ft = 0;
        for (std::size_t i = 0; i < a->hit.size(); ++i) {
            if (a->side.node[i] != Facing::away) continue;
            fn += a->fn_force(i);
            ft += a->ft_force(i);
            draft.entities.nodes.add(node_id(context, *a, i));
        }
        bool all_solid = true;
        for (const Away& segment : away) {
            add_segment(context, surface, segment.segment, draft.entities);
            all_solid = all_solid && surface.segments[segment.segment].solid_backed;
        }
        draft.primary = segment_place(context, surface, away.front().segment);
        for (std::size_t i = 1; i < std::min(away.size(), most_places); ++i)
            draft.related.push_back(segment_place(context, surface, away[i].segment));
        draft.place_count = away.size();

        const UnitSystem& units = context.deck.work_units();
        const Away& nearest = away.front();
        draft.message = std::to_string(away.size()) + " of " + std::to_string(a->side.zone.size()) +
                        " segments of surface " + std::to_string(surface.id) + " near " +
                        bead_name(*a->bead) + (away.size() == 1 ? " faces" : " face") +
                        " away from it (nearest: " + segment_name(context, surface, nearest.segment) +
                        ", d = " + quantity(nearest.d, units, length_dimension, 3) + ")" +
                        consequence(context, *a, nearest.start, fn, ft);
        const bool harmless = a->bead->depth <= 0 && a->bead->fn_first == 0;
        if (harmless) draft.severity = Severity::warning;
        draft.measured.push_back({"segments judged", static_cast<double>(a->side.zone.size()), ""});
        draft.measured.push_back(
            {"segments of the surface", static_cast<double>(surface.segments.size()), ""});
        draft.measured.push_back({"distance", nearest.d, unit_name(units, length_dimension)});
        if (harmless) fn = ft = 0;
        measure_cost(context, *a, fn, ft, draft);
        if (a->bead->fn_first != 0 && a->bead->depth <= 0)
            draft.notes.push_back(
                "with DEPTH 0 Fn acts at any distance anyway; here it acts to the wrong side");
        if (all_solid) {
            draft.help =
                "these segments belong to solids and look outward already: list the faces that the bead "
                "stands over, or move the bead";
        } else if (!surface.lines.empty()) {
            draft.help = "write the nodes of these segments in reverse order (4321)";
            offer(surface, "turn these segment lines", draft);
        } else if (away.size() == a->side.zone.size()) {
            draft.help =
                "give the id of the part or group in the surface the other sign, or let the bead use a "
                "surface of its own that is reversed";
            offer(surface, "reversed sign in the surface", draft);
        } else {
            draft.help =
                "put these elements into a group of their own and name it with a minus sign in a surface "
                "of groups";
            offer(surface, "signed groups in a surface of its own", draft);
        }
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SRF001{{.code = "SRF001",
                          .name = "segment-normal-away-from-bead",
                          .summary = "segments under or near the bead whose normal points away from it",
                          .severity = Severity::error,
                          .fix = FixAvailability::sometimes_safe,
                          .starter_message = 346},
                         needs_sides | needs_motion,
                         check,
                         surface_fix_needs,
                         fix_surface};

} // namespace drawbead
