#pragma once
// For searches: of many segments that are looked at, most lie beside the point, and one needs its normal.
#include "geometry/closest_point.h"

namespace drawbead {

/// The point, place, distance and edges of closest_point; normal and branch are not told.
Foot closest_foot(const Corners&, Vec3 x);

} // namespace drawbead
