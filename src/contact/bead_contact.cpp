#include "contact/bead_contact.h"

#include "base/parallel.h"
#include "bead/bead_line.h"

#include <algorithm>
#include <cmath>

namespace drawbead {
namespace {

constexpr std::size_t piece = 256; ///< bead nodes per piece of work

/// Runs work(i) for i in [0, count), and says whether all returned true.
bool for_all(unsigned threads, std::size_t count, const std::function<bool(std::size_t)>& work) {
    const std::size_t pieces = (count + piece - 1) / piece;
    std::vector<uint8_t> fine(pieces, 1);
    parallel_for(threads, pieces, [&](std::size_t p) {
        for (std::size_t i = p * piece; i < std::min(count, (p + 1) * piece); ++i)
            if (!work(i)) fine[p] = 0;
    });
    return std::all_of(fine.begin(), fine.end(), [](uint8_t f) { return f != 0; });
}

/// The closest point and the other layer. False: the part of the surface is too small.
bool find_closest(const NearMesh& mesh, const ClosestSegment& closest, const ContactOptions& options, Vec3 x,
                  BeadNodeContact& out, double& needed) {
    const ClosestHit hit = closest.find(x);
    if (!hit.found()) return hit.exact;
    const double size = std::sqrt(area(mesh.corners(hit.segment)));
    const double within =
        std::min(options.layer_ratio * hit.foot.distance, hit.foot.distance + options.layer_elements * size);
    needed = std::max(hit.foot.distance + options.around_elements * size, within);
    out.closest = mesh.segment_index[hit.segment];
    out.exact = hit;
    const Vec3 r{needed, needed, needed};
    if (!hit.exact || !mesh.covers(x - r, x + r)) return false;
    if (options.layer_ratio <= 0) return true;
    if (const auto other = closest.other_layer(x, hit, within)) {
        out.other_layer = mesh.segment_index[other->segment];
        out.other_layer_distance = other->d;
    }
    return true;
}

/// False: the part of the surface is too small.
bool first_cycle(const NearMesh& mesh, const BeadInput& bead, std::size_t i, Track track,
                 const std::function<SegmentStiffness(uint32_t)>& stiffness, BeadNodeContact& out) {
    const Vec3 x = bead.x[i];
    out.start_segment = mesh.segment_index[track.segment];
    out.warned_346 =
        warns_346(mesh.corners(track.segment), is_triangle(mesh.segment[track.segment]), x, bead.ipri);
    const SolverHit hit = solver_step(track, mesh, mesh.x, x);
    if (hit.at_rim) return false;
    out.segment = mesh.segment_index[hit.segment];
    for (std::size_t k = 0; k < 4; ++k)
        out.nodes[k] = mesh.node_row[mesh.segment[hit.segment][k]];
    out.xi = hit.xi, out.eta = hit.eta, out.h = hit.h;
    out.inside = hit.inside;
    out.normal = hit.normal;
    out.distance = hit.d;
    const SegmentStiffness s = stiffness(out.segment);
    out.k = s.k;
    out.half_thickness = s.half_thickness;
    out.penetration = solver_penetration(hit, bead.depth, s.half_thickness);
    out.solver_tributary = solver_tributary(hit.normal, half_chord(bead.x, i)).l;
    return true;
}

} // namespace

std::vector<uint32_t> BeadContact::nodes_346() const {
    std::vector<uint32_t> places;
    for (uint32_t i = 0; i < node.size(); ++i)
        if (node[i].warned_346) places.push_back(i);
    return places;
}

SurfaceContact surface_contact(const SegmentMesh& surface, std::span<const BeadInput> beads,
                               const std::function<SegmentStiffness(uint32_t)>& stiffness, double smallest_k,
                               std::span<const double> k_in_storage_order, const ContactOptions& options) {
    std::vector<Vec3> points;
    for (const BeadInput& bead : beads)
        points.insert(points.end(), bead.x.begin(), bead.x.end());

    SurfaceContact out;
    out.bead.resize(beads.size());
    out.track.resize(beads.size());
    double reach = first_reach(surface, options.around_elements) + 2 * options.travel;
    while (true) {
        out.mesh = near_mesh(surface, points, reach, options.threads);
        const bool whole = out.mesh.cells.empty();
        const ClosestSegment closest(out.mesh);
        out.tree = closest.tree();
        bool exact = true;
        double needed = 0;
        for (std::size_t b = 0; b < beads.size(); ++b) {
            const BeadInput& bead = beads[b];
            out.bead[b].node.assign(bead.x.size(), {});
            std::vector<double> radius(bead.x.size(), 0);
            const bool fine = for_all(options.threads, bead.x.size(), [&](std::size_t i) {
                return find_closest(out.mesh, closest, options, bead.x[i], out.bead[b].node[i], radius[i]);
            });
            exact = exact && fine;
            for (const double r : radius)
                needed = std::max(needed, r);
        }
        bool enough = exact;
        for (std::size_t b = 0; b < beads.size() && enough && !out.mesh.segment.empty(); ++b) {
            const BeadInput& bead = beads[b];
            const StartSearch search(out.mesh, bead.x);
            out.track[b].assign(bead.x.size(), {});
            enough = for_all(options.threads, bead.x.size(), [&](std::size_t i) {
                const std::optional<Track> track = solver_start(search, out.mesh, bead.x[i]);
                if (!track) return false;
                out.track[b][i] = *track;
                return first_cycle(out.mesh, bead, i, *track, stiffness, out.bead[b].node[i]);
            });
        }
        needed = needed * (1 + 1e-9) + 2 * options.travel;
        if (whole || (enough && needed <= reach)) break;
        const bool known = enough || (!exact && needed > reach && needed < 2 * reach);
        reach = next_reach(out.mesh, points, known ? needed : 2 * reach);
    }

    for (std::size_t b = 0; b < beads.size(); ++b) {
        out.bead[b].slope = choose_slope(beads[b].fn_first, beads[b].depth, smallest_k);
        for (std::size_t i = 0; i < out.bead[b].node.size(); ++i) {
            BeadNodeContact& node = out.bead[b].node[i];
            if (node.segment == no_segment) continue;
            node.slope = out.bead[b].slope.of(node.k);
            node.slope_read = slope_read(out.bead[b].slope, k_in_storage_order, surface.segment.size(), i);
        }
    }
    return out;
}

std::vector<std::vector<uint32_t>> nodes_346(const SegmentMesh& surface, std::span<const BeadInput> beads,
                                             unsigned threads) {
    std::vector<Vec3> points;
    for (const BeadInput& bead : beads)
        points.insert(points.end(), bead.x.begin(), bead.x.end());
    double reach = first_reach(surface);
    while (true) {
        const NearMesh mesh = near_mesh(surface, points, reach, threads);
        std::vector<std::vector<uint32_t>> out(beads.size());
        bool enough = !mesh.segment.empty();
        for (std::size_t b = 0; b < beads.size() && enough; ++b) {
            const BeadInput& bead = beads[b];
            const StartSearch search(mesh, bead.x);
            std::vector<uint8_t> warned(bead.x.size(), 0);
            enough = for_all(threads, bead.x.size(), [&](std::size_t i) {
                const std::optional<Track> track = solver_start(search, mesh, bead.x[i]);
                if (!track) return false;
                warned[i] = warns_346(mesh.corners(track->segment), is_triangle(mesh.segment[track->segment]),
                                      bead.x[i], bead.ipri);
                return true;
            });
            for (uint32_t i = 0; i < warned.size(); ++i)
                if (warned[i]) out[b].push_back(i);
        }
        if (enough || mesh.cells.empty()) return out;
        reach = next_reach(mesh, points, 2 * reach);
    }
}

} // namespace drawbead
