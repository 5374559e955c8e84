#pragma once
// The corner of a segment at one of its nodes, as the solver's search looks at it (solver notes 2a).
#include "contact/segment_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace drawbead {

/// The edges from a node to its two neighbours in a segment, and their product.
struct SegmentCorner {
    Vec3 at, u, v, n;
};

/// Place of a node in a segment, its first one; 4 when it is not there.
inline std::size_t place_in(const SegmentNodes& s, uint32_t node) {
    std::size_t p = 0;
    while (p < 4 && s[p] != node)
        ++p;
    return p;
}

/// x[node]: positions. A node that is not in the segment counts as its fourth.
template <class Positions>
SegmentCorner segment_corner(const SegmentNodes& s, uint32_t nearest, const Positions& x) {
    static constexpr std::array<std::size_t, 4> next{1, 2, 3, 0}, previous{3, 0, 1, 2};
    const std::size_t found = place_in(s, nearest), p = found < 4 ? found : 3;
    const Vec3 at = x[nearest];
    const Vec3 u = x[is_triangle(s) && p == 2 ? s[0] : s[next[p]]] - at;
    const Vec3 v = x[s[previous[p]]] - at;
    return {at, u, v, cross(u, v)};
}

/// Does a point lie in the corner, and how well: the smallest of the three barycentric coordinates in the
/// triangle of the node and its neighbours. Every operation as the solver's.
inline double corner_test(const SegmentCorner& c, Vec3 bead) {
    const Vec3 w = bead - c.at;
    const double q = 1 / dot(c.n, c.n);
    const double b2 = dot(cross(c.u, w), c.n) * q;
    const double b1 = dot(cross(w, c.v), c.n) * q;
    const double b0 = 1 - b1 - b2;
    const double b = std::min(std::min(b0, b1), b2);
    // No corner at all where n vanishes.
    return std::isnan(b1 + b2) ? -std::numeric_limits<double>::infinity() : b;
}

} // namespace drawbead
