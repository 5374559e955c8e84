#pragma once
// The exact closest point of a surface, in double: what the manual's law uses, and what the solver's search
// is measured against.
#include "contact/segment_mesh.h"
#include "geometry/closest_point.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace drawbead {

inline constexpr uint32_t no_segment = 0xffffffffu;

struct ClosestHit {
    uint32_t segment = no_segment; ///< local number in the NearMesh; no_segment when it has no segments
    Foot foot;                     ///< with the segment's own unit normal at the foot
    double d = 0;                  ///< signed: foot.distance with the sign of normal . (x - foot)
    bool on_free_edge = false;     ///< the foot lies on an edge that no other segment shares
    double offset = 0; ///< part of x - foot perpendicular to the normal, over the root of the segment's
                       ///< area; only on a free edge, else 0
    bool exact = true; ///< false: a part of the surface outside the NearMesh may be closer

    bool found() const { return segment != no_segment; }
    /// The manual law: no contact beside a free edge by more than 5 % of its segment.
    bool in_contact_range() const { return found() && offset <= 0.05; }
};

/// What a search remembers of a point that moves: the segments that were near it, and up to where there are
/// no others. The closest segment is then found among these few until the point has gone too far.
class ClosestTrack {
    friend class ClosestSegment;
    struct Near {
        uint32_t segment;
        double farther; ///< distance plus the way gone when it was measured: less the way gone now, a lower
                        ///< bound
    };
    Vec3 at_;                ///< where the point was last
    double way_ = 0;         ///< that it has gone since the segments were collected
    double reach_ = -1;      ///< there may be others farther than this less the way; -1: nothing is known
    bool covered_ = false;   ///< the mesh has all of the surface up to there
    std::vector<Near> near_; ///< the last closest one first
};

/// Boxes over the segments of a NearMesh, by local numbers. Const and shared by threads and searches.
class SegmentTree {
public:
    explicit SegmentTree(const NearMesh&);

private:
    friend class ClosestSegment;
    friend class NormalCone;
    struct Box {
        Vec3 lo, hi;
        uint32_t begin, end; ///< of order_
        uint32_t right;      ///< 0 for a leaf; the left child follows its parent
    };
    std::vector<Box> box_;
    std::vector<uint32_t> order_; ///< local segments by leaf
    double magnitude_ = 0;        ///< largest coordinate

    void build(const NearMesh&, uint32_t begin, uint32_t end, const std::vector<uint32_t>& key);
};

/// The cone that all normals of a part lie in. Where segments go on all around a node, the surface cannot
/// come closest to a point there unless the point lies in the cone above it or below: a whole box of segments
/// beside the point is then no other layer. (Spatial cones of normals: Johnson and Cohen, 2001.)
class NormalCone {
public:
    NormalCone(const NearMesh&, const SegmentTree&);

private:
    friend class ClosestSegment;
    Vec3 axis_;
    double cos_ = 0, sin_ = 0;    ///< of its half angle; 0: there is no cone narrower than 60 degrees
    std::vector<uint8_t> closed_; ///< by box: segments of it go on all around their nodes
};

/// Searches in a NearMesh, which must outlive it.
/// Ties: when distances agree to rounding, a foot inside a segment wins over one on an edge, then the
/// smallest storage index.
class ClosestSegment {
public:
    explicit ClosestSegment(const NearMesh&);
    /// With the tree of this mesh, or of one that it was copied or moved from.
    ClosestSegment(const NearMesh&, std::shared_ptr<const SegmentTree>);
    const std::shared_ptr<const SegmentTree>& tree() const { return tree_; }

    ClosestHit find(Vec3 x) const;
    /// The same for a point that moves, and sooner; `track` is used with one point and one surface only.
    ClosestHit find(Vec3 x, ClosestTrack& track) const;

    /// The closest of the *other* layers: a foot where the distance has a local minimum on the surface, on a
    /// segment that shares no node with `nearest`'s, not farther than `within`.
    /// Sooner with the cone of this mesh and tree, which pays where many points are asked for.
    std::optional<ClosestHit> other_layer(Vec3 x, const ClosestHit& nearest, double within,
                                          const NormalCone* = nullptr) const;

private:
    const NearMesh& mesh_;
    std::shared_ptr<const SegmentTree> tree_;

    double tie(Vec3 x) const;
    struct Candidates;
    ClosestHit best_of(Vec3 x, const Candidates&, bool covered) const;
    void follow(Vec3 x, ClosestTrack&) const;
    /// Calls visit(segment) for segments whose box is not farther than `radius`, near ones first; it may
    /// shrink it.
    template <class Visit>
    void visit_within(Vec3 x, const double& radius, Visit&& visit, const NormalCone* = nullptr) const;
    ClosestHit complete(Vec3 x, uint32_t segment, const Foot&) const;
    bool is_local_minimum(Vec3 x, uint32_t segment, const Foot&) const;
    /// Whether this segment cannot be another layer: its closest point is farther than `radius`, or no local
    /// minimum. False says nothing.
    bool leads_on(Vec3 x, uint32_t segment, double radius) const;
};

/// The part of a surface in which the closest point of every point within `travel` of one of `points` is
/// exact: grows the reach until it is.
NearMesh mesh_for_closest(const SegmentMesh&, std::span<const Vec3> points, double travel,
                          unsigned threads = 1);

} // namespace drawbead
