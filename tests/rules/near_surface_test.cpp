#include "contact/closest_segment.h"
#include "geometry/closest_point.h"
#include "rules/srf/near_surface.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace drawbead;

namespace {

/// A wavy, graded plate of columns x rows elements; rows of nodes and segments in any order.
struct Plate {
    std::vector<Vec3> x;
    std::vector<uint32_t> id;
    std::vector<SegmentNodes> segment;

    Plate(uint32_t columns, uint32_t rows, bool shuffled, std::mt19937& random) {
        std::vector<uint32_t> row((columns + 1) * (rows + 1));
        std::iota(row.begin(), row.end(), 0u);
        if (shuffled) std::shuffle(row.begin(), row.end(), random);
        x.resize(row.size());
        for (uint32_t j = 0; j <= rows; ++j)
            for (uint32_t i = 0; i <= columns; ++i) {
                const double u = i + 0.02 * i * i, v = 1.3 * j;
                x[row[j * (columns + 1) + i]] = {u, v, 3 * std::sin(0.2 * u) * std::cos(0.3 * v)};
            }
        for (uint32_t j = 0; j < rows; ++j)
            for (uint32_t i = 0; i < columns; ++i) {
                const uint32_t a = j * (columns + 1) + i;
                segment.push_back({row[a], row[a + 1], row[a + columns + 2], row[a + columns + 1]});
            }
        if (shuffled) std::shuffle(segment.begin(), segment.end(), random);
        id.resize(x.size());
        std::iota(id.begin(), id.end(), 1u);
    }
    SegmentMesh mesh() const {
        SegmentMesh m;
        m.segment = SegmentArray(segment);
        m.x = x;
        m.node_id = id;
        return m;
    }
    double distance(Vec3 p) const {
        double d = std::numeric_limits<double>::infinity();
        for (const SegmentNodes& n : segment)
            d = std::min(d, closest_point({x[n[0]], x[n[1]], x[n[2]], x[n[3]]}, p).distance);
        return d;
    }
};

} // namespace

TEST_CASE("the closest segment of a point is in the part near it, and so is what surrounds it") {
    std::mt19937 random(5);
    for (const bool shuffled : {false, true}) {
        const Plate plate(60, 50, shuffled, random);
        for (const double height : {0.3, 6.0, 80.0}) {
            std::vector<Vec3> points;
            for (int i = 0; i < 40; ++i)
                points.push_back({10 + 2.1 * i, 8 + 0.9 * i, height});
            const NearSurface near = near_surface(plate.mesh(), points, 3, 0, 2);
            REQUIRE(near.margin.size() == points.size());
            const ClosestSegment closest(near.mesh);
            std::vector<bool> here(plate.segment.size(), false);
            for (const uint32_t s : near.mesh.segment_index)
                here[s] = true;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const ClosestHit hit = closest.find(points[i]);
                REQUIRE(hit.found());
                CHECK(hit.foot.distance == Approx(plate.distance(points[i])).epsilon(1e-13));
                for (uint32_t s = 0; s < plate.segment.size(); ++s) {
                    const SegmentNodes& n = plate.segment[s];
                    const Corners c{plate.x[n[0]], plate.x[n[1]], plate.x[n[2]], plate.x[n[3]]};
                    if (!here[s]) CHECK(closest_point(c, hit.foot.point).distance > near.margin[i]);
                }
            }
        }
    }
}

TEST_CASE("the part near a bead is small, ordered, and does not depend on the count of threads") {
    std::mt19937 random(6);
    const Plate plate(300, 250, false, random);
    std::vector<Vec3> points;
    for (int i = 0; i < 200; ++i)
        points.push_back({40 + 0.2 * i, 30 + 0.7 * i, 4});
    const NearSurface one = near_surface(plate.mesh(), points, 3, 0, 1);
    const NearSurface four = near_surface(plate.mesh(), points, 3, 0, 4);
    CHECK(one.mesh.segment_index == four.mesh.segment_index);
    CHECK(one.mesh.node_row == four.mesh.node_row);
    CHECK(one.mesh.around == four.mesh.around);
    CHECK(one.mesh.segment.size() < plate.segment.size() / 3);
    CHECK(std::is_sorted(one.mesh.segment_index.begin(), one.mesh.segment_index.end()));
    for (uint32_t s = 0; s < one.mesh.segment.size(); ++s)
        for (std::size_t k = 0; k < 4; ++k)
            CHECK(one.mesh.node_row[one.mesh.segment[s][k]] == plate.segment[one.mesh.segment_index[s]][k]);
}

TEST_CASE("nothing near no points, and the storage order where it differs") {
    std::mt19937 random(7);
    const Plate plate(20, 20, false, random);
    CHECK(near_surface(plate.mesh(), {}, 3, 0, 1).mesh.segment.empty());
    SegmentMesh mesh = plate.mesh();
    mesh.storage_key = [&](uint32_t s) { return 1000 - s; };
    const NearSurface near = near_surface(mesh, std::vector<Vec3>{{5, 5, 1}}, 3, 0, 1);
    CHECK(near.mesh.segment_index.size() > 4);
    CHECK(std::is_sorted(near.mesh.segment_index.rbegin(), near.mesh.segment_index.rend()));
}
