#pragma once
// Neighbours among points, for any spacing: a tree of boxes over an index order.
#include "geometry/vec3.h"

#include <cstdint>
#include <span>
#include <vector>

namespace drawbead {

/// Keeps a reference to the points. Built in O(n log n); ties in distance go to the smaller index.
class PointTree {
public:
    static constexpr uint32_t none = 0xffffffffu;
    struct Near {
        uint32_t index = none;
        double squared = 0;
    };

    explicit PointTree(std::span<const Vec3> points);

    /// The closest `count` points to point i, i left out, by ascending distance and index; fewer when there
    /// are fewer. `out` holds `count` entries at least; returns how many were found.
    uint32_t nearest(uint32_t i, uint32_t count, Near* out) const;

    /// The closest point to point i whose label differs from i's, if closer than sqrt(squared_bound) or as
    /// close. Call `set_labels` first.
    Near nearest_other_label(uint32_t i, double squared_bound) const;
    /// One label per point; kept by reference until the next call.
    void set_labels(std::span<const uint32_t> labels);

private:
    struct Box {
        Vec3 lo, hi;
        uint32_t begin, end; ///< of order_
        uint32_t right;      ///< 0 for a leaf; the left child follows its parent
        uint32_t label;      ///< of all points within, or none when they differ
    };
    std::span<const Vec3> points_;
    std::span<const uint32_t> labels_;
    std::vector<uint32_t> order_;
    std::vector<Box> boxes_;

    void build(uint32_t begin, uint32_t end);
};

} // namespace drawbead
