#include "geometry/point_tree.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace drawbead {
namespace {

constexpr uint32_t leaf_size = 8;

double outside(double lo, double hi, double at) {
    return std::max({lo - at, at - hi, 0.0});
}

double squared_distance(Vec3 lo, Vec3 hi, Vec3 x) {
    return squared_norm({outside(lo.x, hi.x, x.x), outside(lo.y, hi.y, x.y), outside(lo.z, hi.z, x.z)});
}

} // namespace

PointTree::PointTree(std::span<const Vec3> points) : points_(points), order_(points.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    boxes_.reserve(points.size() / 2 + 1);
    if (!points.empty()) build(0, static_cast<uint32_t>(points.size()));
}

void PointTree::build(uint32_t begin, uint32_t end) {
    const std::size_t self = boxes_.size();
    Vec3 lo = points_[order_[begin]], hi = lo;
    for (uint32_t k = begin; k < end; ++k) {
        const Vec3 p = points_[order_[k]];
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    boxes_.push_back({lo, hi, begin, end, 0, none});
    if (end - begin <= leaf_size) return;
    const Vec3 size = hi - lo;
    const auto axis = size.x >= size.y && size.x >= size.z ? &Vec3::x
                      : size.y >= size.z                   ? &Vec3::y
                                                           : &Vec3::z;
    const uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](uint32_t i, uint32_t j) {
                         const double a = points_[i].*axis, b = points_[j].*axis;
                         return a != b ? a < b : i < j;
                     });
    build(begin, middle);
    boxes_[self].right = static_cast<uint32_t>(boxes_.size());
    build(middle, end);
}

uint32_t PointTree::nearest(uint32_t i, uint32_t count, Near* out) const {
    uint32_t found = 0;
    const Vec3 x = points_[i];
    const auto closer = [](const Near& a, const Near& b) {
        return a.squared != b.squared ? a.squared < b.squared : a.index < b.index;
    };
    struct Pending {
        uint32_t box;
        double squared;
    };
    std::array<Pending, 64> stack;
    std::size_t depth = 0;
    if (!boxes_.empty() && count > 0) stack[depth++] = {0, 0.0};
    while (depth > 0) {
        const Pending top = stack[--depth];
        if (found == count && top.squared > out[found - 1].squared) continue;
        const Box& box = boxes_[top.box];
        if (box.right == 0) {
            for (uint32_t k = box.begin; k < box.end; ++k) {
                const Near near{order_[k], squared_norm(points_[order_[k]] - x)};
                if (near.index == i || (found == count && !closer(near, out[found - 1]))) continue;
                uint32_t at = found < count ? found++ : found - 1;
                for (; at > 0 && closer(near, out[at - 1]); --at)
                    out[at] = out[at - 1];
                out[at] = near;
            }
            continue;
        }
        const Box &a = boxes_[top.box + 1], &b = boxes_[box.right];
        const Pending left{top.box + 1, squared_distance(a.lo, a.hi, x)};
        const Pending right{box.right, squared_distance(b.lo, b.hi, x)};
        stack[depth++] = left.squared <= right.squared ? right : left;
        stack[depth++] = left.squared <= right.squared ? left : right;
    }
    return found;
}

void PointTree::set_labels(std::span<const uint32_t> labels) {
    labels_ = labels;
    for (std::size_t k = boxes_.size(); k-- > 0;) {
        Box& box = boxes_[k];
        if (box.right == 0) {
            box.label = labels[order_[box.begin]];
            for (uint32_t m = box.begin + 1; m < box.end; ++m)
                if (labels[order_[m]] != box.label) box.label = none;
        } else {
            const uint32_t left = boxes_[k + 1].label;
            box.label = left == boxes_[box.right].label ? left : none;
        }
    }
}

PointTree::Near PointTree::nearest_other_label(uint32_t i, double squared_bound) const {
    Near best{none, squared_bound};
    const Vec3 x = points_[i];
    const uint32_t own = labels_[i];
    struct Pending {
        uint32_t box;
        double squared;
    };
    std::array<Pending, 64> stack;
    std::size_t depth = 0;
    if (!boxes_.empty()) stack[depth++] = {0, 0.0};
    while (depth > 0) {
        const Pending top = stack[--depth];
        const Box& box = boxes_[top.box];
        if (top.squared > best.squared || box.label == own) continue;
        if (box.right == 0) {
            for (uint32_t k = box.begin; k < box.end; ++k) {
                const uint32_t j = order_[k];
                if (labels_[j] == own) continue;
                const double squared = squared_norm(points_[j] - x);
                if (squared < best.squared || (squared == best.squared && j < best.index))
                    best = {j, squared};
            }
            continue;
        }
        const Box &a = boxes_[top.box + 1], &b = boxes_[box.right];
        const Pending left{top.box + 1, squared_distance(a.lo, a.hi, x)};
        const Pending right{box.right, squared_distance(b.lo, b.hi, x)};
        stack[depth++] = left.squared <= right.squared ? right : left;
        stack[depth++] = left.squared <= right.squared ? left : right;
    }
    return best;
}

} // namespace drawbead
