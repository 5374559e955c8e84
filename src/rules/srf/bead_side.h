#pragma once
// Which segments around a bead look at it and which look away. The bead decides, never the majority of the
// surface.
#include "contact/segment_mesh.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace drawbead {

enum class Facing : uint8_t {
    unknown, ///< the bead lies in the surface, or beside it, or on both sides of it
    toward,
    away,
};

/// A bead node over the segment that is closest to it.
struct BeadFoot {
    uint32_t segment = 0; ///< local number in the NearMesh
    Vec3 bead, foot;
    double d = 0;        ///< signed distance
    double element = 0;  ///< size of the segment, root of its area
    bool beside = false; ///< beyond a free edge: the side says nothing
    bool turned = false; ///< the Starter turns the segment in a way that is not known here
};

/// A segment near the bead.
struct ZoneSegment {
    uint32_t segment = 0; ///< local number
    Facing facing = Facing::unknown;
    bool start = false;  ///< closest segment of a bead node
    double distance = 0; ///< of its closest node from the line of feet; 0 for start segments
    double d = 0; ///< of the bead node that is closest along the surface, as if it stood over this segment
};

struct BeadSide {
    std::vector<ZoneSegment> zone; ///< ascending by segment
    uint32_t patches = 0;          ///< edge-connected, each of one orientation
    /// Per foot: whether its side counts (neither beside the surface nor in it), and how its segment was
    /// judged.
    std::vector<bool> decides;
    std::vector<Facing> node;

    uint64_t count(Facing) const;
};

struct SideLimits {
    double reach = 3;         ///< elements on either side of the line that are judged
    double in_surface = 1e-3; ///< of an element: a bead node closer than this lies in the surface
    double minority = 0.1;    ///< a patch with more of its bead's distance on the other side is not judged
};

/// Judges the start segments and the segments within reach of the line of feet. `hops`: pairs of feet that
/// are neighbours on the bead; gaps are none. `solid_backed`: per local segment, turned by the Starter; these
/// are judged only where they hang together with a start segment. Empty: none.
///
/// Neighbours that agree across an edge form a patch. A patch takes the side that its bead nodes stand on;
/// one without bead nodes the opposite of a judged patch that it clashes with along an edge; one that touches
/// no judged patch the side of the bead as seen from each of its segments, if they all see the same.
BeadSide judge_side(const NearMesh&, std::span<const BeadFoot>,
                    std::span<const std::pair<uint32_t, uint32_t>> hops,
                    std::span<const uint8_t> solid_backed = {}, const SideLimits& = {});

} // namespace drawbead
