#include "rules/lin/bead_report.h"
#include "rules/srf/surface_fix.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

namespace {

/// Segments that clash with a neighbour, those with most clashing edges first: a single turned one clashes
/// with all of its neighbours, each of these only with it. Then by element, whatever their order in the deck.
std::vector<std::pair<uint32_t, uint32_t>> clashing_segments(const Model& model, const Surface& surface,
                                                             const EdgeClashes& clashes) {
    std::vector<uint32_t> all;
    all.reserve(clashes.edges.size() * 2);
    for (const EdgeClash& edge : clashes.edges)
        all.insert(all.end(), {edge.first, edge.second});
    std::sort(all.begin(), all.end());
    std::vector<std::pair<uint32_t, uint32_t>> counted; // edges, segment
    for (const uint32_t segment : all) {
        if (counted.empty() || counted.back().second != segment) counted.emplace_back(0, segment);
        ++counted.back().first;
    }
    const auto id = [&](uint32_t segment) { return value(model.element_id(surface.segments[segment])); };
    std::sort(counted.begin(), counted.end(), [&](const auto& p, const auto& q) {
        if (p.first != q.first) return p.first > q.first;
        return std::pair(id(p.second), p.second) < std::pair(id(q.second), q.second);
    });
    return counted;
}

void check(const RuleContext& context, FindingSink& sink) {
    constexpr std::size_t most_places = 100;
    for (std::size_t s = 0; s < context.analysis.surfaces.size(); ++s) {
        const EdgeClashes& clashes = context.analysis.surfaces[s].clashes;
        if (clashes.edges.empty()) continue;
        const Surface& surface = context.model.surfaces()[s];
        double fn = 0, fn_total = 0;
        std::vector<int64_t> users;
        bool side_known = false;
        for (const BeadAnalysis* a : beads_with_nodes(context)) {
            if (a->surface != &surface) continue;
            users.push_back(a->bead->id);
            side_known = side_known || a->side.count(Facing::unknown) < a->side.zone.size();
            for (std::size_t i = 0; i < a->x.size(); ++i) {
                fn_total += a->fn_force(i);
                if (i < a->side.node.size() && a->side.node[i] == Facing::away) fn += a->fn_force(i);
            }
        }
        if (users.empty()) continue;

        Draft draft;
        if (users.size() == 1) draft.interface_id = users.front();
        draft.surface_id = surface.id;
        draft.discriminator = "surface " + std::to_string(surface.id);
        const auto segments = clashing_segments(context.model, surface, clashes);
        draft.primary = segment_place(context, surface, segments.front().second);
        for (std::size_t i = 0; i < segments.size(); ++i) {
            if (i != 0 && i < most_places)
                draft.related.push_back(segment_place(context, surface, segments[i].second));
            add_segment(context, surface, segments[i].second, draft.entities);
        }
        draft.place_count = segments.size();
        const UnitSystem& units = context.deck.work_units();
        draft.message = "neighbours look to different sides across " + counted(clashes.edges.size(), "edge") +
                        " of surface " + std::to_string(surface.id) + " (" +
                        counted(clashes.segments, "segment") + " of " +
                        std::to_string(surface.segments.size()) +
                        (segments.front().first > 1 ? ", first " : ", among them ") +
                        segment_name(context, surface, segments.front().second) +
                        "); where the blank brings such an edge under " +
                        (users.size() == 1 ? "bead " : "one of the beads ") + listed(users) +
                        ", Fn changes its direction: " + quantity(fn, units, force_dimension) + ", " +
                        number(fn_total != 0 ? 100 * fn / fn_total : 0, 3) +
                        " % of the total, look away from the bead at the start";
        draft.measured.push_back({"edges", static_cast<double>(clashes.edges.size()), ""});
        draft.measured.push_back({"segments", static_cast<double>(clashes.segments), ""});
        draft.measured.push_back({"normal force on the wrong side", fn, unit_name(units, force_dimension)});
        draft.help = "turn the segments on one side of these edges so that all face the bead";
        if (side_known && offers_surface_fix(surface))
            draft.fixes.push_back({surface.lines.empty() ? "signed groups in a surface of its own"
                                                         : "turn the segment lines that face away",
                                   FixAvailability::safe});
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SRF002{{.code = "SRF002",
                          .name = "normals-inconsistent",
                          .summary = "neighbouring segments of a surface look to different sides",
                          .severity = Severity::error,
                          .fix = FixAvailability::sometimes_safe},
                         needs_clashes | needs_sides,
                         check,
                         surface_fix_needs,
                         fix_surface};

} // namespace drawbead
