#include "contact/rigid_tracks.h"

#include "contact/segment_corner.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drawbead {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double safety = 8; // on estimates of errors, which are of first order

} // namespace

RigidTracks::RigidTracks(const NearMesh& mesh, double error)
    : mesh_(mesh), error_(safety * error), ring_of_(mesh.x.size(), 0),
      corner_of_(4 * mesh.segment.size(), 0) {}

const RigidTracks::Ring& RigidTracks::ring(uint32_t node) {
    if (ring_of_[node] != 0) return rings_[ring_of_[node] - 1];
    Ring ring;
    ring.begin = static_cast<uint32_t>(bisector_.size());
    double shortest = infinity;
    const Vec3 from = mesh_.x[node];
    for (const uint32_t s : mesh_.segments_around(node))
        for (const uint32_t other : mesh_.segment[s]) {
            const auto known = bisector_.begin() + ring.begin;
            if (other == node ||
                std::any_of(known, bisector_.end(), [other](const Bisector& b) { return b.other == other; }))
                continue;
            const Vec3 to = mesh_.x[other];
            const double length = distance(from, to);
            const Vec3 inward = (1 / length) * (from - to); // NaN for two nodes in one place: always in doubt
            bisector_.push_back({inward, -0.5 * dot(inward, from + to), 2 * length, other});
            ring.longest = std::max(ring.longest, 2 * length);
            shortest = std::min(shortest, length);
        }
    ring.end = static_cast<uint32_t>(bisector_.size());
    ring.per_length = 1 / shortest;
    rings_.push_back(ring);
    ring_of_[node] = static_cast<uint32_t>(rings_.size());
    return rings_.back();
}

const RigidTracks::Corner& RigidTracks::corner(uint32_t segment, std::size_t place) {
    uint32_t& number = corner_of_[4 * std::size_t{segment} + place];
    if (number != 0) return corners_[number - 1];
    const SegmentNodes& nodes = mesh_.segment[segment];
    const SegmentCorner c = segment_corner(nodes, nodes[place], mesh_.x);
    const double squared = dot(c.n, c.n), per_squared = 1 / squared, per_length = std::sqrt(per_squared);
    Corner out;
    out.at = c.at;
    out.gradient_1 = per_squared * cross(c.v, c.n);
    out.gradient_2 = per_squared * cross(c.n, c.u);
    const double u = norm(c.u), v = norm(c.v);
    out.size = {distance(c.u, c.v) * per_length, v * per_length, u * per_length};
    out.largest = std::max({out.size[0], out.size[1], out.size[2]});
    out.turn = 1 / std::min(u, v) + 3 * (u + v) * per_length;
    corners_.push_back(out);
    number = static_cast<uint32_t>(corners_.size());
    return corners_.back();
}

/// The least distance of y to the bisectors of a ring, inward.
double RigidTracks::least(const Ring& r, Vec3 y) const {
    double out = infinity;
    for (uint32_t k = r.begin; k < r.end; ++k) {
        const double d = dot(bisector_[k].inward, y) + bisector_[k].offset;
        out = d >= out ? out : d; // NaN stays
    }
    return out;
}

/// The node itself or one of its ring, ties to the smaller number.
uint32_t RigidTracks::closest_of_ring(const Ring& r, uint32_t node, double unsure, Vec3 y, Vec3 bead,
                                      SurfaceNow& now) const {
    // Squared distances less that of the node itself.
    const auto less = [&](const Bisector& b) { return b.twice * (dot(b.inward, y) + b.offset); };
    double best = 0;
    for (uint32_t k = r.begin; k < r.end; ++k)
        best = std::min(best, less(bisector_[k]));
    const double bound = best + 2 * r.longest * unsure;

    uint32_t first = 0, nearest = 0, count = 0;
    double closest = infinity;
    const auto compare = [&](uint32_t one) {
        const double squared = squared_norm(bead - now.at(one));
        if (squared < closest || (squared == closest && one < nearest)) closest = squared, nearest = one;
    };
    const auto take = [&](uint32_t one) {
        if (++count == 1) {
            first = one;
            return;
        }
        if (count == 2) nearest = first, compare(first);
        compare(one);
    };
    if (!(bound < 0)) take(node);
    for (uint32_t k = r.begin; k < r.end; ++k)
        if (!(less(bisector_[k]) > bound)) take(bisector_[k].other);
    return count == 1 ? first : nearest;
}

RigidTracks::Inside RigidTracks::inside(uint32_t segment, uint32_t nearest, Vec3 y) {
    const std::size_t place = place_in(mesh_.segment[segment], nearest);
    if (place == 4) return {0, infinity, 0};
    const Corner& c = corner(segment, place);
    const Vec3 w = y - c.at;
    const double b1 = dot(c.gradient_1, w), b2 = dot(c.gradient_2, w), b0 = 1 - b1 - b2;
    Inside out;
    out.least = std::min(std::min(b0, b1), b2);
    out.error = c.largest * error_ * (1 + norm(w) * c.turn);
    out.margin = std::min(std::min((b0 - out.error) / c.size[0], (b1 - out.error) / c.size[1]),
                          (b2 - out.error) / c.size[2]);
    if (!(out.error < infinity) || std::isnan(b0)) out = {0, infinity, 0};
    return out;
}

RigidTracks::Inside RigidTracks::exactly(uint32_t segment, uint32_t nearest, Vec3 bead,
                                         SurfaceNow& now) const {
    struct {
        SurfaceNow& now;
        const Vec3& operator[](uint32_t node) const { return now.at(node); }
    } const x{now};
    return {corner_test(segment_corner(mesh_.segment[segment], nearest, x), bead), 0, 0};
}

RigidTracks::Step RigidTracks::follow(Track& track, Vec3 y, Vec3 bead, SurfaceNow& now) {
    Step out;
    const auto doubt = [&](const Ring& r, uint32_t node) {
        return error_ * (1 + distance(mesh_.x[node], y) * r.per_length);
    };
    uint32_t nearest = track.nearest;
    Ring around = ring(nearest);
    double unsure = doubt(around, nearest), left = least(around, y);
    if (!(left > unsure)) {
        out.searched = true;
        nearest = closest_of_ring(around, nearest, unsure, y, bead, now);
        if (nearest != track.nearest) {
            around = ring(nearest);
            unsure = doubt(around, nearest);
            left = least(around, y);
        }
    }
    out.complete = mesh_.is_complete(track.nearest) && mesh_.is_complete(nearest);

    uint32_t segment = track.segment;
    const auto settle = [&](Inside& one, uint32_t s) {
        if (one.error != 0) one = exactly(s, nearest, bead, now);
    };
    Inside best = inside(segment, nearest, y);
    if (!(best.least > best.error)) {
        out.searched = true;
        if (best.in_doubt()) settle(best, segment);
        if (best.least < 0) {
            for (const uint32_t s : mesh_.segments_around(nearest)) {
                if (s == track.segment) continue;
                Inside one = inside(s, nearest, y);
                if (one.in_doubt()) settle(one, s);
                if (!(std::abs(one.least - best.least) > one.error + best.error)) {
                    settle(best, segment);
                    settle(one, s);
                }
                if (one.least > best.least ||
                    (one.least == best.least && mesh_.segment[s] < mesh_.segment[segment])) {
                    best = one;
                    segment = s;
                }
                if (one.least >= 0) break;
            }
        }
    }
    track = {nearest, segment};
    const double margin = (1 - 1e-6) * std::min(left - unsure, best.margin);
    out.margin = margin > 0 ? margin : 0;
    return out;
}

} // namespace drawbead
