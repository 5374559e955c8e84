#include "geometry/point_tree.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <random>

using namespace drawbead;

TEST_CASE("neighbours as a search over all points finds them") {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int round = 0; round < 20; ++round) {
        const std::size_t n = 1 + random() % 200;
        std::vector<Vec3> x;
        for (std::size_t k = 0; k < n; ++k)
            x.push_back(round % 2 ? Vec3{unit(random), unit(random), 0}
                                  : Vec3{double(random() % 5), double(random() % 5), 0}); // many ties
        std::vector<uint32_t> label;
        for (std::size_t k = 0; k < n; ++k)
            label.push_back(static_cast<uint32_t>(random() % 3));
        PointTree tree(x);
        tree.set_labels(label);
        for (uint32_t i = 0; i < n; ++i) {
            std::vector<std::pair<double, uint32_t>> all, other;
            for (uint32_t j = 0; j < n; ++j) {
                if (j != i) all.emplace_back(squared_norm(x[j] - x[i]), j);
                if (label[j] != label[i]) other.emplace_back(squared_norm(x[j] - x[i]), j);
            }
            std::sort(all.begin(), all.end());
            std::sort(other.begin(), other.end());
            std::array<PointTree::Near, 5> near;
            const uint32_t found = tree.nearest(i, 5, near.data());
            REQUIRE(found == std::min<std::size_t>(5, n - 1));
            for (uint32_t k = 0; k < found; ++k)
                REQUIRE(near[k].index == all[k].second);
            const auto closest = tree.nearest_other_label(i, 1e300);
            REQUIRE(closest.index == (other.empty() ? PointTree::none : other[0].second));
        }
    }
}
