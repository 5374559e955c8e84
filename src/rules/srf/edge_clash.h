#pragma once
// Where neighbouring segments of a surface look to different sides.
#include "model/entities.h"

#include <cstdint>
#include <vector>

namespace drawbead {

/// Two segments that run along their common edge in the same direction: their normals disagree.
struct EdgeClash {
    uint32_t first = 0, second = 0;       ///< segments, first < second
    NodeRow from = no_node, to = no_node; ///< the edge as both run along it
};

struct EdgeClashes {
    std::vector<EdgeClash> edges; ///< ascending by (first, second)
    uint64_t segments = 0;        ///< with at least one such edge
};

/// All clashes of a surface. An edge with one segment (border) or with three and more (T-junction, branching
/// sheet) says nothing; nor does a segment that is listed twice. Segments that the Starter turns
/// (solid-backed) and segments with a node row outside [0, nodes) are left out.
///
/// Linear in the number of segments and without allocation per edge: per node, hashes of the next nodes minus
/// hashes of the previous ones are summed; they cancel where all segments around the node agree. Only edges
/// between nodes with a remainder (borders, clashes) are looked at one by one. A clash is missed only when a
/// sum of 32 bits cancels by chance, one edge in two thousand million; a turned segment has several edges.
EdgeClashes edge_clashes(const SegmentList&, uint32_t nodes, unsigned threads);

} // namespace drawbead
