#pragma once
// The exact closest point of a surface, in double: what the manual's law uses, and what the solver's search
// is measured against.
#include "contact/segment_mesh.h"
#include "geometry/closest_point.h"

#include <cstdint>
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

/// A tree of boxes over the segments of a NearMesh, which must outlive it. Const and shared by threads.
/// Ties: when distances agree to rounding, a foot inside a segment wins over one on an edge, then the
/// smallest storage index.
class ClosestSegment {
public:
    explicit ClosestSegment(const NearMesh&);

    ClosestHit find(Vec3 x) const;
    /// The same for a point that moves, and sooner; `track` is used with one point and one surface only.
    ClosestHit find(Vec3 x, ClosestTrack& track) const;

    /// The closest of the *other* layers: a foot where the distance has a local minimum on the surface, on a
    /// segment that shares no node with `nearest`'s, not farther than `within`.
    std::optional<ClosestHit> other_layer(Vec3 x, const ClosestHit& nearest, double within) const;

private:
    struct Box {
        Vec3 lo, hi;
        uint32_t begin, end; ///< of order_
        uint32_t right;      ///< 0 for a leaf; the left child follows its parent
    };
    const NearMesh& mesh_;
    std::vector<Box> tree_;
    std::vector<uint32_t> order_; ///< local segments by leaf
    double magnitude_ = 0;        ///< largest coordinate

    void build(uint32_t begin, uint32_t end, const std::vector<uint32_t>& key);
    double tie(Vec3 x) const;
    struct Candidates;
    ClosestHit best_of(Vec3 x, const Candidates&, bool covered) const;
    void follow(Vec3 x, ClosestTrack&) const;
    /// Calls visit(segment) for segments whose box is not farther than `radius`, near ones first; it may
    /// shrink it.
    template <class Visit>
    void visit_within(Vec3 x, const double& radius, Visit&& visit) const;
    ClosestHit complete(Vec3 x, uint32_t segment, const Foot&) const;
    bool is_local_minimum(Vec3 x, uint32_t segment, const Foot&) const;
};

/// The part of a surface in which the closest point of every point within `travel` of one of `points` is
/// exact: grows the reach until it is.
NearMesh mesh_for_closest(const SegmentMesh&, std::span<const Vec3> points, double travel,
                          unsigned threads = 1);

} // namespace drawbead
