#pragma once
// The point of a segment that is closest to a given one.
#include "geometry/segment_shape.h"

#include <cstdint>

namespace drawbead {

/// How a foot was found (for counters and tests).
enum class FootBranch : uint8_t {
    triangle, ///< exact
    planar,   ///< a planar quad: projection on its plane and the inverse bilinear map, or the closest edge
    newton,   ///< a warped quad: a stationary point inside
    edge,     ///< a warped quad: the closest point of its outline
};

/// Closest point of a segment. Edge k runs from corner k to corner k + 1 (cyclic); edge 2 of a triangle has
/// no length and is never reported.
struct Foot {
    Vec3 point;
    Vec3 normal; ///< patch_normal at the foot
    double xi = 0, eta = 0;
    double distance = 0; ///< >= 0
    uint8_t edges = 0;   ///< bit k: the foot lies on edge k; two bits at a corner; 0 inside
    FootBranch branch = FootBranch::triangle;

    bool inside() const { return edges == 0; }
};

/// The minimum of |x - S| over the whole patch: triangles exactly, planar quads in closed form, warped quads
/// by damped Newton steps from several starts compared with the outline. A zero-area segment gives the
/// closest point of its outline. Finite input gives finite output.
Foot closest_point(const Corners&, Vec3 x);

/// Distance to the box around the corners, squared: never more than the distance to the segment.
double squared_distance_to_box(const Corners&, Vec3 x);

} // namespace drawbead
