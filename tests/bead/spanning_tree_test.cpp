#include "bead/spanning_tree.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace drawbead;

namespace {

/// Prim's, O(n^2).
double slow_length(const std::vector<Vec3>& x) {
    std::vector<double> to_tree(x.size(), 1e300);
    std::vector<bool> in(x.size(), false);
    double sum = 0;
    std::size_t at = 0;
    for (std::size_t k = 1; k < x.size(); ++k) {
        in[at] = true;
        std::size_t best = x.size();
        for (std::size_t j = 0; j < x.size(); ++j) {
            if (in[j]) continue;
            to_tree[j] = std::min(to_tree[j], distance(x[at], x[j]));
            if (best == x.size() || to_tree[j] < to_tree[best]) best = j;
        }
        sum += to_tree[best];
        at = best;
    }
    return sum;
}

double length(const std::vector<TreeEdge>& edges) {
    double sum = 0;
    for (const TreeEdge& e : edges)
        sum += e.length;
    return sum;
}

} // namespace

TEST_CASE("the tree is as short as a slow one finds it") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int round = 0; round < 60; ++round) {
        const std::size_t n = 2 + random() % 300;
        std::vector<Vec3> x;
        for (std::size_t k = 0; k < n; ++k) {
            switch (round % 4) {
            case 0:
                x.push_back({unit(random), unit(random), unit(random)});
                break;
            case 1:
                x.push_back({unit(random), 0, 0});
                break;
            case 2:
                x.push_back({double(random() % 8), double(random() % 8), 0});
                break; // ties and repeats
            default: { // clusters far apart
                const double c = double(random() % 5) * 100;
                x.push_back({c + unit(random), unit(random), 0});
            }
            }
        }
        const auto edges = spanning_tree(x);
        REQUIRE(edges.size() == n - 1);
        REQUIRE(length(edges) == Approx(slow_length(x)).epsilon(1e-12));
    }
}

TEST_CASE("places whose distance squared is beyond the largest double come to an end, too") {
    for (const double far : {1e155, 1e300}) {
        std::vector<Vec3> x;
        for (int i = 0; i < 30; ++i)
            x.push_back({static_cast<double>(i), 0, 0});
        x[7].x = far, x[12].y = -far, x[13].z = far;
        const auto edges = spanning_tree(x);
        CHECK(edges.size() == 29);
        CHECK(std::count_if(edges.begin(), edges.end(),
                            [](const TreeEdge& e) { return !std::isfinite(e.length); }) == 3);
    }
}

TEST_CASE("points at one place") {
    const auto edges = spanning_tree(std::vector<Vec3>(100, Vec3{1, 2, 3}));
    CHECK(edges.size() == 99);
    CHECK(length(edges) == 0);
    CHECK(spanning_tree({}).empty());
    CHECK(spanning_tree(std::vector<Vec3>(1)).empty());
}
