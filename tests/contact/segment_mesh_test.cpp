#include "contact/segment_mesh.h"
#include "sheet.h"

#include <catch2/catch.hpp>

#include <set>

using namespace drawbead;

TEST_CASE("a segment seen from the other side") {
    CHECK(turned({1, 2, 3, 4}) == SegmentNodes{4, 3, 2, 1});
    CHECK(turned({1, 2, 3, 3}) == SegmentNodes{2, 1, 3, 3});
}

TEST_CASE("the whole surface, renumbered by user id and storage order") {
    Sheet s = flat_sheet(2, 1);
    s.id = {60, 50, 40, 30, 20, 10};
    SegmentMesh mesh = s.mesh();
    mesh.storage_key = [](uint32_t k) { return uint64_t{10 - k}; };
    mesh.turn = [](uint32_t k) { return k == 0; };
    const NearMesh m = near_mesh(mesh, {}, whole_surface);
    CHECK(m.node_id == std::vector<uint32_t>{10, 20, 30, 40, 50, 60});
    CHECK(m.node_row == std::vector<uint32_t>{5, 4, 3, 2, 1, 0});
    CHECK(m.segment_index == std::vector<uint32_t>{1, 0});
    CHECK(m.segment[0] == SegmentNodes{4, 3, 0, 1});
    CHECK(m.segment[1] == SegmentNodes{2, 1, 4, 5}); // 0 1 4 3 turned
    CHECK(m.surface_nodes == 6);
    CHECK(m.surface_max == Vec3{2, 1, 0});
    CHECK(std::vector<uint32_t>(m.segments_around(4).begin(), m.segments_around(4).end()) ==
          std::vector<uint32_t>{0, 1});
    CHECK(m.covers({-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}));
}

TEST_CASE("segments with missing nodes are left out") {
    Sheet s = flat_sheet(2, 1);
    s.segment.push_back({0, 1, 0xffffffffu, 2});
    const NearMesh m = near_mesh(s.mesh(), {}, whole_surface);
    CHECK(m.segment.size() == 2);
}

TEST_CASE("a reach always grows, and ends with the whole surface") {
    Sheet point = flat_sheet(1, 1);
    for (Vec3& x : point.x)
        x = {}; // a segment without a size
    CHECK(first_reach(point.mesh()) == whole_surface);
    const Sheet s = flat_sheet(8, 8);
    const std::vector<Vec3> points{{4, 4, 1}};
    CHECK(first_reach(s.mesh(), 1) > first_reach(s.mesh()));
    const NearMesh part = near_mesh(s.mesh(), points, 0.5);
    CHECK(next_reach(part, points, 2) == 2);
    CHECK(next_reach(part, points, 0.5) == 1.25); // a little more than to the surface
    CHECK(next_reach(near_mesh(s.mesh(), points, 2), points, 2) == whole_surface);
    CHECK(next_reach(part, points, 100) == whole_surface);
}

TEST_CASE("near the points: all that comes within reach, whatever the count of threads") {
    std::mt19937 random(1);
    for (int round = 0; round < 60; ++round) {
        const Sheet s = random_sheet(round % 6, random);
        const std::vector<Vec3> points = random_points(s, 1 + random() % 20, random);
        const double reach = 0.1 * (1 << random() % 6);
        const NearMesh m = near_mesh(s.mesh(), points, reach, 1 + round % 2);
        const NearMesh all = near_mesh(s.mesh(), {}, whole_surface);
        CHECK(m.surface_nodes == all.surface_nodes);
        CHECK(m.surface_min == all.surface_min);
        CHECK(m.surface_max == all.surface_max);
        const std::set<uint32_t> have(m.segment_index.begin(), m.segment_index.end());
        for (uint32_t k = 0; k < s.segment.size(); ++k) {
            Vec3 lo{1e300, 1e300, 1e300}, hi{-1e300, -1e300, -1e300};
            for (const uint32_t n : s.segment[k]) {
                lo = {std::min(lo.x, s.x[n].x), std::min(lo.y, s.x[n].y), std::min(lo.z, s.x[n].z)};
                hi = {std::max(hi.x, s.x[n].x), std::max(hi.y, s.x[n].y), std::max(hi.z, s.x[n].z)};
            }
            for (const Vec3& p : points) {
                const bool touches = lo.x <= p.x + reach && p.x - reach <= hi.x && lo.y <= p.y + reach &&
                                     p.y - reach <= hi.y && lo.z <= p.z + reach && p.z - reach <= hi.z;
                if (touches) REQUIRE(have.count(k) == 1);
            }
        }
        for (const Vec3& p : points) {
            const Vec3 r = 0.999 * Vec3{reach, reach, reach};
            REQUIRE(m.covers(p - r, p + r));
        }
        // A complete node has all segments that the whole surface has around it.
        for (uint32_t i = 0; i < m.x.size(); ++i) {
            if (!m.is_complete(i)) continue;
            const auto at = std::lower_bound(all.node_id.begin(), all.node_id.end(), m.node_id[i]);
            const auto there = all.segments_around(static_cast<uint32_t>(at - all.node_id.begin()));
            REQUIRE(m.segments_around(i).size() == there.size());
            for (std::size_t k = 0; k < there.size(); ++k)
                REQUIRE(m.segment_index[m.segments_around(i)[k]] == all.segment_index[there[k]]);
        }
    }
}
