#include "bead/spanning_tree.h"

#include "geometry/point_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace drawbead {
namespace {

constexpr uint32_t neighbours = 4;

struct Link {
    double squared = std::numeric_limits<double>::infinity();
    uint32_t a = 0, b = 0;

    friend bool operator<(const Link& p, const Link& q) {
        return std::tie(p.squared, p.a, p.b) < std::tie(q.squared, q.a, q.b);
    }
};

Link link(uint32_t i, const PointTree::Near& near) {
    return {near.squared, std::min(i, near.index), std::max(i, near.index)};
}

uint32_t root(std::vector<uint32_t>& parent, uint32_t i) {
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

} // namespace

// Boruvka's rounds. Every point knows its nearest few; only where all of them are already in its own part,
// and where the farthest of them is not too far to matter, the tree of boxes is asked again.
std::vector<TreeEdge> spanning_tree(std::span<const Vec3> points) {
    const auto n = static_cast<uint32_t>(points.size());
    std::vector<TreeEdge> edges;
    if (n < 2) return edges;
    PointTree tree(points);
    std::vector<std::array<PointTree::Near, neighbours>> near(n);
    std::vector<uint8_t> known(n), next(n, 0);
    for (uint32_t i = 0; i < n; ++i)
        known[i] = static_cast<uint8_t>(tree.nearest(i, neighbours, near[i].data()));
    std::vector<uint32_t> parent(n), part(n);
    std::iota(parent.begin(), parent.end(), 0u);
    part = parent;
    std::vector<Link> best(n);
    while (edges.size() + 1 < n) {
        std::fill(best.begin(), best.end(), Link{});
        for (uint32_t i = 0; i < n; ++i) {
            while (next[i] < known[i] && part[near[i][next[i]].index] == part[i])
                ++next[i];
            if (next[i] < known[i]) best[part[i]] = std::min(best[part[i]], link(i, near[i][next[i]]));
        }
        bool labelled = false;
        for (uint32_t i = 0; i < n; ++i) {
            if (next[i] < known[i] || known[i] + 1u >= n) continue;
            if (near[i][known[i] - 1u].squared > best[part[i]].squared) continue;
            if (!labelled) tree.set_labels(part);
            labelled = true;
            const auto found = tree.nearest_other_label(i, best[part[i]].squared);
            if (found.index != PointTree::none) best[part[i]] = std::min(best[part[i]], link(i, found));
        }
        const std::size_t before = edges.size();
        for (uint32_t i = 0; i < n; ++i) {
            if (part[i] != i || best[i].a == best[i].b) continue;
            const uint32_t p = root(parent, best[i].a), q = root(parent, best[i].b);
            if (p == q) continue;
            parent[std::max(p, q)] = std::min(p, q);
            edges.push_back({best[i].a, best[i].b, std::sqrt(best[i].squared)});
        }
        for (uint32_t i = 0; i < n; ++i)
            part[i] = root(parent, i);
        if (edges.size() > before) continue;
        // Squares beyond the largest double: all that is left is equally far.
        for (uint32_t i = 1; i < n; ++i) {
            const uint32_t p = root(parent, 0), q = root(parent, i);
            if (p == q) continue;
            parent[std::max(p, q)] = std::min(p, q);
            edges.push_back({0, i, std::numeric_limits<double>::infinity()});
        }
    }
    return edges;
}

} // namespace drawbead
