#pragma once
// Where two polylines come close to each other.
#include "geometry/vec3.h"

#include <cstdint>
#include <span>
#include <vector>

namespace drawbead {

/// A straight piece between two points of a line.
struct HopEnds {
    uint32_t from = 0, to = 0;
};

struct LineHops {
    std::span<const Vec3> x;
    std::vector<HopEnds> hops;
};

/// Two hops that are not farther apart than asked for.
struct NearHops {
    HopEnds first, second;
    double distance = 0;
    double along_first = 0, along_second = 0; ///< where they are closest, 0 to 1
    bool ends_meet = false;                   ///< closest at an end of both lines: one continues the other
};

/// Closest points of the segments [p0, p1] and [q0, q1] as parts of their lengths.
struct SegmentPair {
    double s = 0, t = 0, distance = 0;
};
SegmentPair closest_of_segments(Vec3 p0, Vec3 p1, Vec3 q0, Vec3 q1);

/// All pairs of hops within `distance`, by hops of `second`, then of `first`. Fast where hops are of similar
/// lengths.
std::vector<NearHops> near_hops(const LineHops& first, const LineHops& second, double distance);

} // namespace drawbead
