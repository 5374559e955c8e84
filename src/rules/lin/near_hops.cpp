#include "rules/lin/near_hops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace drawbead {

namespace {

struct Box {
    Vec3 lo{1, 1, 1}, hi{-1, -1, -1};
    bool empty = true;

    void add(Vec3 x) {
        if (empty) lo = hi = x;
        empty = false;
        lo = {std::min(lo.x, x.x), std::min(lo.y, x.y), std::min(lo.z, x.z)};
        hi = {std::max(hi.x, x.x), std::max(hi.y, x.y), std::max(hi.z, x.z)};
    }
    bool meets(const Box& o, double gap) const {
        return !empty && !o.empty && lo.x <= o.hi.x + gap && o.lo.x <= hi.x + gap && lo.y <= o.hi.y + gap &&
               o.lo.y <= hi.y + gap && lo.z <= o.hi.z + gap && o.lo.z <= hi.z + gap;
    }
};

Box box_of(const LineHops& line, const HopEnds& hop) {
    Box box;
    box.add(line.x[hop.from]);
    box.add(line.x[hop.to]);
    return box;
}

/// Whether a place on a hop is the first or last point of its line.
bool at_end(const LineHops& line, const HopEnds& hop, double along) {
    return (along <= 0 && hop.from == line.hops.front().from) ||
           (along >= 1 && hop.to == line.hops.back().to);
}

} // namespace

SegmentPair closest_of_segments(Vec3 p0, Vec3 p1, Vec3 q0, Vec3 q1) {
    const Vec3 u = p1 - p0, v = q1 - q0;
    SegmentPair best;
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](double s, double t) {
        const double d = squared_norm((p0 + s * u) - (q0 + t * v));
        if (d < least) least = d, best.s = s, best.t = t;
    };
    // Each end against the other segment, and the inner minimum where there is one: the distance is convex,
    // so the least of these is the minimum.
    const auto foot = [](Vec3 x, Vec3 from, Vec3 along) {
        const double square = squared_norm(along);
        return square > 0 ? std::clamp(dot(x - from, along) / square, 0.0, 1.0) : 0.0;
    };
    consider(foot(q0, p0, u), 0);
    consider(foot(q1, p0, u), 1);
    consider(0, foot(p0, q0, v));
    consider(1, foot(p1, q0, v));
    const double uu = squared_norm(u), vv = squared_norm(v), uv = dot(u, v);
    const double determinant = uu * vv - uv * uv;
    if (determinant > 1e-12 * uu * vv) {
        const Vec3 w = p0 - q0;
        const double s = (uv * dot(v, w) - vv * dot(u, w)) / determinant;
        const double t = (uu * dot(v, w) - uv * dot(u, w)) / determinant;
        if (s > 0 && s < 1 && t > 0 && t < 1) consider(s, t);
    }
    best.distance = std::sqrt(least);
    return best;
}

std::vector<NearHops> near_hops(const LineHops& first, const LineHops& second, double distance) {
    std::vector<NearHops> found;
    Box all_first, all_second;
    for (const HopEnds& hop : first.hops)
        all_first.add(first.x[hop.from]), all_first.add(first.x[hop.to]);
    for (const HopEnds& hop : second.hops)
        all_second.add(second.x[hop.from]), all_second.add(second.x[hop.to]);
    if (!all_first.meets(all_second, distance)) return found;

    // Hops of the first line that can matter, by cells of a grid. A cell is as wide as the longest of them
    // and the distance, so that a hop lies in few cells.
    double cell = distance;
    std::vector<uint32_t> candidates;
    for (uint32_t i = 0; i < first.hops.size(); ++i)
        if (box_of(first, first.hops[i]).meets(all_second, distance)) {
            candidates.push_back(i);
            cell = std::max(cell, norm(first.x[first.hops[i].to] - first.x[first.hops[i].from]));
        }
    if (candidates.empty() || !(cell > 0)) return found;
    using GridCell = std::array<int64_t, 3>;
    const auto cell_of = [&](Vec3 x) {
        constexpr double farthest = 1e15;
        const Vec3 r = x - all_first.lo;
        const auto part = [&](double v) {
            return static_cast<int64_t>(std::clamp(std::floor(v / cell), -farthest, farthest));
        };
        return GridCell{part(r.x), part(r.y), part(r.z)};
    };
    const auto each_cell = [&](const Box& box, auto&& visit) {
        const GridCell lo = cell_of(box.lo), hi = cell_of(box.hi);
        for (int64_t x = lo[0]; x <= hi[0]; ++x)
            for (int64_t y = lo[1]; y <= hi[1]; ++y)
                for (int64_t z = lo[2]; z <= hi[2]; ++z)
                    visit(GridCell{x, y, z});
    };
    std::vector<std::pair<GridCell, uint32_t>> grid;
    for (const uint32_t i : candidates)
        each_cell(box_of(first, first.hops[i]), [&](const GridCell& c) { grid.emplace_back(c, i); });
    std::sort(grid.begin(), grid.end());

    std::vector<uint32_t> near;
    for (const HopEnds& hop : second.hops) {
        Box box = box_of(second, hop);
        if (!box.meets(all_first, distance)) continue;
        const Vec3 margin{distance, distance, distance};
        box.lo = box.lo - margin, box.hi = box.hi + margin;
        near.clear();
        const Vec3 size = (1 / cell) * (box.hi - box.lo);
        if (size.x * size.y * size.z > 1000) { // a hop much longer than those of the first line
            near = candidates;
        } else {
            each_cell(box, [&](const GridCell& c) {
                for (auto at =
                         std::lower_bound(grid.begin(), grid.end(), std::pair<GridCell, uint32_t>(c, 0));
                     at != grid.end() && at->first == c; ++at)
                    near.push_back(at->second);
            });
            std::sort(near.begin(), near.end());
            near.erase(std::unique(near.begin(), near.end()), near.end());
        }
        for (const uint32_t i : near) {
            const HopEnds& other = first.hops[i];
            const SegmentPair pair = closest_of_segments(first.x[other.from], first.x[other.to],
                                                         second.x[hop.from], second.x[hop.to]);
            if (pair.distance > distance) continue;
            found.push_back({other, hop, pair.distance, pair.s, pair.t,
                             at_end(first, other, pair.s) && at_end(second, hop, pair.t)});
        }
    }
    return found;
}

} // namespace drawbead
