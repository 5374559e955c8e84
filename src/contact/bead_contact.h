#pragma once
// Beads over a surface: one call that gives every bead node's contact, by the solver's search and by the
// exact one.
#include "contact/blank_stiffness.h"
#include "contact/closest_segment.h"
#include "contact/segment_mesh.h"
#include "contact/solver_search.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace drawbead {

/// A bead as contact needs it.
struct BeadInput {
    std::vector<Vec3> x; ///< positions in list order
    double fn_first = 0, depth = 0;
    int ipri = 0; ///< of /IOFLAG
};

/// The first cycle of one bead node in place. Segments are indices in the caller's array.
struct BeadNodeContact {
    // the solver's
    uint32_t start_segment = no_segment; ///< the Starter's
    bool warned_346 = false;
    uint32_t segment = no_segment;
    SegmentNodes nodes{}; ///< node rows, the solver's order
    double xi = 0, eta = 0;
    std::array<double, 4> h{};
    bool inside = false; ///< `xface`
    Vec3 normal;
    double distance = 0; ///< d, signed
    double half_thickness = 0, penetration = 0;
    double k = 0, slope = 0;          ///< of the segment
    std::optional<double> slope_read; ///< what the node reads instead; empty: past the end of the table
    double solver_tributary = 0;      ///< |n x l|
    // the exact closest point of the surface
    uint32_t closest = no_segment;
    ClosestHit exact;                  ///< its segment by its local number in SurfaceContact::mesh
    uint32_t other_layer = no_segment; ///< a second layer at a similar distance
    double other_layer_distance = 0;   ///< signed
};

struct BeadContact {
    std::vector<BeadNodeContact> node; ///< by place in the bead's list
    SlopeChoice slope;

    std::vector<uint32_t> nodes_346() const; ///< places in the list, ascending
};

struct ContactOptions {
    double travel = 0; ///< how far the beads will be moved over `mesh` afterwards
    double layer_ratio =
        1.5; ///< another layer up to this times the closest distance counts (0: none is looked for),
    double layer_elements = 2; ///< but no farther behind it than so many segments
    double around_elements =
        0; ///< `mesh` holds all that is no farther than the closest segment and so many of its sizes
    unsigned threads = 1;
};

/// All beads of one surface at once. A surface without segments gives nodes without segments.
struct SurfaceContact {
    NearMesh mesh; ///< what the beads need of the surface; solver tracks refer to it
    std::shared_ptr<const SegmentTree> tree; ///< of `mesh`
    std::vector<BeadContact> bead;
    std::vector<std::vector<Track>> track; ///< per bead and node: the state before the first cycle
};

/// `stiffness(i)` of the caller's segment i; `smallest_k` over the whole surface; `k_in_storage_order` as in
/// slope_read (may be empty: then slope_read is empty too unless all slopes are equal).
SurfaceContact surface_contact(const SegmentMesh&, std::span<const BeadInput>,
                               const std::function<SegmentStiffness(uint32_t)>& stiffness, double smallest_k,
                               std::span<const double> k_in_storage_order, const ContactOptions& = {});

/// Places in the list of each bead that warning 346 names, ascending: the Starter's part of surface_contact
/// alone.
std::vector<std::vector<uint32_t>> nodes_346(const SegmentMesh&, std::span<const BeadInput>,
                                             unsigned threads = 1);

} // namespace drawbead
