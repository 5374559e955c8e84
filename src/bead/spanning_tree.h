#pragma once
#include "geometry/vec3.h"

#include <cstdint>
#include <span>
#include <vector>

namespace drawbead {

struct TreeEdge {
    uint32_t a = 0, b = 0; ///< a < b
    double length = 0;
};

/// Euclidean minimum spanning tree (n - 1 edges, in no special order), O(n log n) for points along lines.
/// Equal lengths go by the smaller indices, so the tree is unique.
std::vector<TreeEdge> spanning_tree(std::span<const Vec3> points);

} // namespace drawbead
