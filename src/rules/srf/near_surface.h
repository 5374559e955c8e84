#pragma once
// The part of a main surface that the rules look at: what can be closest to a bead node, and what is around
// it.
#include "contact/segment_mesh.h"

#include <span>
#include <vector>

namespace drawbead {

struct NearSurface {
    NearMesh mesh;      ///< local numbers: nodes by row, segments by storage order; taken as a whole surface
    double element = 0; ///< largest element size among the segments that were sampled
    std::vector<double>
        margin; ///< per point: everything within this of its closest point of the surface is here
};

/// Holds every segment that is closest to one of the points, and all within `elements` element sizes of the
/// closest point of each; more where `least_margin` asks for it. Two passes over memory, one over all nodes
/// and one over all segments, whatever their order.
///
/// The longest segment is taken from a sample when there are more than some ten thousand: a segment that is
/// longer than all of these and has no corner near the bead may be missed.
NearSurface near_surface(const SegmentMesh&, std::span<const Vec3> points, double elements,
                         double least_margin, unsigned threads);

} // namespace drawbead
