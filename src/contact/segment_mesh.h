#pragma once
// A main surface as the mathematics sees it: segments, positions, user ids. Nothing is owned.
#include "geometry/segment_shape.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace drawbead {

/// Node rows of a segment; a triangle repeats its third.
using SegmentNodes = std::array<uint32_t, 4>;

constexpr bool is_triangle(const SegmentNodes& n) {
    return n[2] == n[3];
}

/// The same segment seen from the other side, as the Starter turns a solid's face: 4321, a triangle 2133.
constexpr SegmentNodes turned(const SegmentNodes& n) {
    return is_triangle(n) ? SegmentNodes{n[1], n[0], n[2], n[3]} : SegmentNodes{n[3], n[2], n[1], n[0]};
}

/// Numbers whose sums say whether edges meet: around a node, those of the next nodes in its segments and
/// those of the previous ones cancel when every edge that leaves the node in one segment comes back in
/// another.
constexpr uint64_t node_hash(uint32_t node) {
    uint64_t h = (uint64_t{node} + 1) * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
    h *= 0xbf58476d1ce4e5b9u;
    return h ^ h >> 32;
}

/// Read-only view of segments that lie in an array of larger records.
class SegmentArray {
public:
    SegmentArray() = default;
    SegmentArray(std::span<const SegmentNodes> s) : SegmentArray(s.data(), s.size(), sizeof(SegmentNodes)) {}
    SegmentArray(const std::vector<SegmentNodes>& s) : SegmentArray(std::span(s)) {}
    /// Records that hold four 32-bit node rows at `first` and every `stride` bytes after it.
    SegmentArray(const void* first, std::size_t count, std::size_t stride)
        : first_(static_cast<const std::byte*>(first)), count_(count), stride_(stride) {}

    std::size_t size() const { return count_; }
    SegmentNodes operator[](std::size_t i) const {
        SegmentNodes n;
        std::memcpy(&n, first_ + i * stride_, sizeof n);
        return n;
    }

private:
    const std::byte* first_ = nullptr;
    std::size_t count_ = 0, stride_ = 0;
};

/// Segments with a node row outside `x` are left out of everything.
struct SegmentMesh {
    SegmentArray segment;
    std::span<const Vec3> x;           ///< by node row
    std::span<const uint32_t> node_id; ///< user id by node row
    /// Ascending in the solver's storage order; empty when the array is in that order already.
    std::function<uint64_t(uint32_t segment)> storage_key;
    /// Segments to take as turned round (solid-backed ones that look inward); empty: none.
    std::function<bool(uint32_t segment)> turn;
};

inline constexpr double whole_surface = std::numeric_limits<double>::infinity();

/// The part of a surface near some points, renumbered: local nodes ascend by user id and local segments by
/// storage order, so that every tie of the solver is a comparison of local numbers.
struct NearMesh {
    std::vector<uint32_t> node_row;      ///< row of a local node
    std::vector<uint32_t> node_id;       ///< user id of a local node, ascending
    std::vector<Vec3> x;                 ///< positions of local nodes
    std::vector<SegmentNodes> segment;   ///< local nodes of a local segment, turned where asked
    std::vector<uint32_t> segment_index; ///< index in the caller's array of a local segment
    std::vector<uint32_t> around_begin;  ///< local nodes + 1: into `around`
    std::vector<uint32_t> around;        ///< local segments around each local node, ascending
    std::vector<uint8_t> complete;       ///< by local node: all its segments are here; empty when all are
    uint32_t surface_nodes = 0;          ///< distinct nodes of the whole surface
    Vec3 surface_min, surface_max;       ///< box of the whole surface
    double reach = whole_surface;        ///< as asked for

    /// Whether everything of the surface that touches this box is here.
    bool covers(Vec3 lo, Vec3 hi) const;
    Corners corners(uint32_t segment_number) const {
        const SegmentNodes& n = segment[segment_number];
        return {x[n[0]], x[n[1]], x[n[2]], x[n[3]]};
    }
    std::span<const uint32_t> segments_around(uint32_t node) const {
        return {around.data() + around_begin[node], around.data() + around_begin[node + 1]};
    }
    bool is_complete(uint32_t node) const { return complete.empty() || complete[node] != 0; }

    // The region that is complete: cells of a coarse grid, one bit each. No cells: the whole surface is here.
    std::vector<uint64_t> cells;
    Vec3 cells_min;
    double cell_size = 0;
    std::array<uint32_t, 3> cell_count{};
};

/// All segments that come within `reach` (along each axis) of one of the points, and more. One pass over the
/// surface.
NearMesh near_mesh(const SegmentMesh&, std::span<const Vec3> points, double reach, unsigned threads = 1);

/// A reach to begin with: a few segments and `around_elements` more, by a sample of them; whole_surface when
/// the sample has no size.
double first_reach(const SegmentMesh&, double around_elements = 0);
/// A larger one after `part` was too small: at least `wanted`, at least to the surface's box, and
/// `whole_surface` when that is no less, or no more than before.
double next_reach(const NearMesh& part, std::span<const Vec3> points, double wanted);

} // namespace drawbead
