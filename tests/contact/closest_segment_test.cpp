#include "contact/closest_segment.h"
#include "sheet.h"

#include <catch2/catch.hpp>

using namespace drawbead;

namespace {

/// Over all segments, by the stated rule: within rounding of the closest, inside before on an edge, then the
/// first.
uint32_t slow_closest(const NearMesh& m, Vec3 x, double& distance) {
    distance = 1e300;
    double magnitude = 0;
    std::vector<Foot> feet;
    for (uint32_t s = 0; s < m.segment.size(); ++s) {
        feet.push_back(closest_point(m.corners(s), x));
        distance = std::min(distance, feet.back().distance);
        for (const Vec3& p : m.corners(s))
            magnitude = std::max({magnitude, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    magnitude = std::max({magnitude, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    const double equal = 16 * std::numeric_limits<double>::epsilon() * magnitude;
    uint32_t best = no_segment;
    for (uint32_t s = 0; s < feet.size(); ++s)
        if (feet[s].distance <= distance + equal &&
            (best == no_segment || (feet[s].inside() && !feet[best].inside())))
            best = s;
    return best;
}

} // namespace

TEST_CASE("the closest segment is the one found over all segments") {
    std::mt19937 random(8);
    for (int round = 0; round < 120; ++round) {
        const Sheet s = random_sheet(round % 6, random);
        const NearMesh m = near_mesh(s.mesh(), {}, whole_surface);
        const ClosestSegment closest(m);
        for (const Vec3& x : random_points(s, 40, random)) {
            double d = 0;
            const uint32_t expected = slow_closest(m, x, d);
            const ClosestHit hit = closest.find(x);
            CAPTURE(round, x.x, x.y, x.z);
            REQUIRE(hit.segment == expected);
            REQUIRE(hit.foot.distance == closest_point(m.corners(expected), x).distance);
            REQUIRE(std::abs(hit.d) == hit.foot.distance);
            REQUIRE(hit.exact);
        }
    }
}

TEST_CASE("a part of the surface gives the same closest segments, for moved points too") {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int round = 0; round < 60; ++round) {
        const Sheet s = random_sheet(round % 6, random);
        const std::vector<Vec3> points = random_points(s, 1 + random() % 8, random);
        const NearMesh all = near_mesh(s.mesh(), {}, whole_surface);
        const double travel = round % 3 == 0 ? 0 : 1.5;
        const NearMesh part = mesh_for_closest(s.mesh(), points, travel);
        const ClosestSegment closest(part), everywhere(all);
        for (const Vec3& p : points)
            for (int k = 0; k < 5; ++k) {
                const Vec3 x = p + travel * 0.5 * Vec3{u(random), u(random), u(random)};
                const ClosestHit ours = closest.find(x), theirs = everywhere.find(x);
                REQUIRE(ours.found());
                REQUIRE(ours.exact);
                REQUIRE(part.segment_index[ours.segment] == all.segment_index[theirs.segment]);
                REQUIRE(ours.d == theirs.d);
                REQUIRE(ours.on_free_edge == theirs.on_free_edge);
                REQUIRE(ours.offset == theirs.offset);
            }
    }
}

TEST_CASE("a point that moves finds what a search from nothing finds, at every size of step") {
    std::mt19937 random(10);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int round = 0; round < 60; ++round) {
        const Sheet s = random_sheet(round % 6, random);
        const NearMesh m = near_mesh(s.mesh(), {}, whole_surface);
        const ClosestSegment closest(m);
        const double pace = std::pow(10.0, -4 + round % 5);
        for (Vec3 x : random_points(s, 6, random)) {
            ClosestTrack track;
            const Vec3 way = pace * Vec3{u(random), u(random), u(random)};
            for (int k = 0; k < 60; ++k, x += k % 20 == 19 ? -3 * way : way) {
                const ClosestHit ours = closest.find(x, track), theirs = closest.find(x);
                CAPTURE(round, k, x.x, x.y, x.z);
                REQUIRE(ours.segment == theirs.segment);
                REQUIRE(ours.d == theirs.d);
                REQUIRE(ours.foot.point == theirs.foot.point);
                REQUIRE(ours.foot.normal == theirs.foot.normal);
                REQUIRE((ours.foot.xi == theirs.foot.xi && ours.foot.eta == theirs.foot.eta));
                REQUIRE(ours.exact == theirs.exact);
                REQUIRE(ours.on_free_edge == theirs.on_free_edge);
            }
        }
    }
    const Sheet flat = flat_sheet(4, 4); // along an edge, where two segments tie
    const NearMesh m = near_mesh(flat.mesh(), {}, whole_surface);
    const ClosestSegment closest(m);
    ClosestTrack track;
    for (int k = 0; k <= 400; ++k)
        REQUIRE(closest.find({2, 0.01 * k, 3}, track).segment == closest.find({2, 0.01 * k, 3}).segment);
}

TEST_CASE("what is not known to be exact says so") {
    const Sheet s = flat_sheet(40, 40);
    const std::vector<Vec3> points{{5.5, 5.5, 1}};
    const NearMesh part = near_mesh(s.mesh(), points, 1.5);
    REQUIRE(part.segment.size() < 200);
    const ClosestSegment closest(part);
    CHECK(closest.find({5.5, 5.5, 1}).exact);
    CHECK_FALSE(closest.find({30.5, 30.5, 1}).exact);
}

TEST_CASE("ties go to the smallest index, feet inside first") {
    const Sheet s = flat_sheet(4, 4);
    const NearMesh m = near_mesh(s.mesh(), {}, whole_surface);
    const ClosestSegment closest(m);
    CHECK(closest.find({2, 1.5, 3}).segment == 5); // on the edge of 5 and 6
    CHECK(closest.find({2, 2, 3}).segment == 5);   // on the corner of 5, 6, 9, 10
    CHECK(closest.find({2 + 1e-9, 1.5, 8}).segment ==
          6); // inside 6 by little: the distance to 5 rounds to the same
    CHECK(closest.find({2 - 1e-9, 1.5, 8}).segment == 5);
}

TEST_CASE("signed distance and free edges") {
    const Sheet s = flat_sheet(4, 4);
    const NearMesh m = near_mesh(s.mesh(), {}, whole_surface);
    const ClosestSegment closest(m);
    CHECK(closest.find({1.5, 1.5, 0.3}).d == 0.3);
    CHECK(closest.find({1.5, 1.5, -0.3}).d == -0.3);
    CHECK_FALSE(closest.find({2, 2, 1}).on_free_edge);
    ClosestHit hit = closest.find({4.04, 1.5, 0.3});
    CHECK(hit.on_free_edge);
    CHECK(hit.offset == Approx(0.04));
    CHECK(hit.in_contact_range());
    hit = closest.find({4.06, 1.5, 0.3});
    CHECK(hit.offset == Approx(0.06));
    CHECK_FALSE(hit.in_contact_range());
    CHECK(closest.find({4.06, 2, 0.3}).on_free_edge); // at a node of the outline, between two segments
    CHECK(closest.find({4.06, 4.06, 0.3}).offset == Approx(0.06 * std::sqrt(2.0)));
}

TEST_CASE("a reentrant corner is part of the outline") {
    Sheet s = flat_sheet(2, 2);
    s.segment.erase(s.segment.begin() + 3); // an L
    const NearMesh m = near_mesh(s.mesh(), {}, whole_surface);
    const ClosestHit hit = ClosestSegment(m).find({1.2, 1.2, 0.5});
    CHECK(hit.on_free_edge);
}

TEST_CASE("another layer") {
    Sheet s = flat_sheet(6, 6);
    const auto nodes = static_cast<uint32_t>(s.x.size());
    for (uint32_t k = 0; k < nodes; ++k)
        s.x.push_back(s.x[k] + Vec3{0.3, 0.3, -1});
    for (std::size_t k = 0; k < 36; ++k) {
        SegmentNodes n = s.segment[k];
        for (uint32_t& row : n)
            row += nodes;
        s.segment.push_back(n);
    }
    s.id.resize(s.x.size());
    std::iota(s.id.begin(), s.id.end(), 1u);
    const NearMesh m = near_mesh(s.mesh(), {}, whole_surface);
    const ClosestSegment closest(m);
    const Vec3 x{3.5, 3.5, 4};
    const ClosestHit hit = closest.find(x);
    CHECK(hit.segment == 21);
    CHECK_FALSE(closest.other_layer(x, hit, 4.99));
    const auto other = closest.other_layer(x, hit, 5.01);
    REQUIRE(other);
    CHECK(other->segment == 36 + 21);
    CHECK(other->d == 5);
    // A single layer has no other, however far the bead is above it.
    const NearMesh one = near_mesh(flat_sheet(6, 6).mesh(), {}, whole_surface);
    const ClosestSegment single(one);
    CHECK_FALSE(single.other_layer({3.5, 3.5, 40}, single.find({3.5, 3.5, 40}), 80));
}

TEST_CASE("no segments") {
    const Sheet s;
    const NearMesh m = near_mesh(s.mesh(), {}, whole_surface);
    CHECK_FALSE(ClosestSegment(m).find({1, 2, 3}).found());
    const std::vector<Vec3> points{{1, 2, 3}};
    CHECK(mesh_for_closest(s.mesh(), points, 0).segment.empty());
}
