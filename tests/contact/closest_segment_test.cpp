#include "contact/closest_segment.h"
#include "sheet.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <vector>

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

std::vector<std::size_t> foot_edges(const Foot& foot) {
    std::vector<std::size_t> edges;
    for (std::size_t k = 0; k < 4; ++k)
        if (foot.edges >> k & 1) edges.push_back(k);
    return edges;
}

/// The definition: of all segments without a node of the closest one, the closest whose foot no segment that
/// shares it comes under.
std::optional<uint32_t> slow_other_layer(const NearMesh& m, Vec3 x, uint32_t nearest, double within) {
    double magnitude = 0;
    for (const Vec3& p : m.x)
        magnitude = std::max({magnitude, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    magnitude = std::max({magnitude, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    const double equal = 16 * std::numeric_limits<double>::epsilon() * magnitude;
    const auto holds = [&](uint32_t segment, uint32_t node) {
        const SegmentNodes& n = m.segment[segment];
        return std::find(n.begin(), n.end(), node) != n.end();
    };
    std::optional<uint32_t> best;
    double distance = within;
    for (uint32_t s = 0; s < m.segment.size(); ++s) {
        const SegmentNodes& n = m.segment[s];
        if (std::any_of(n.begin(), n.end(), [&](uint32_t node) { return holds(nearest, node); })) continue;
        const Foot foot = closest_point(m.corners(s), x);
        if (foot.distance > distance || (best && foot.distance == distance)) continue;
        std::vector<uint32_t> at; // nodes that every edge at the foot has
        for (std::size_t k = 0; k < 4; ++k) {
            const std::vector<std::size_t> edges = foot_edges(foot);
            const bool here = std::all_of(edges.begin(), edges.end(), [&](std::size_t e) {
                return n[e] == n[k] || n[(e + 1) % 4] == n[k];
            });
            if (foot.edges != 0 && here) at.push_back(n[k]);
        }
        bool lowest = true;
        for (uint32_t t = 0; t < m.segment.size() && !at.empty(); ++t)
            if (t != s && std::all_of(at.begin(), at.end(), [&](uint32_t node) { return holds(t, node); }))
                lowest = lowest && !(closest_point(m.corners(t), x).distance < foot.distance - equal);
        if (!lowest) continue;
        best = s;
        distance = foot.distance;
    }
    return best;
}

/// Another sheet under or beside the first, with nodes of its own.
Sheet with_second(Sheet s, const Sheet& second, Vec3 shift) {
    const auto nodes = static_cast<uint32_t>(s.x.size());
    for (const Vec3& p : second.x)
        s.x.push_back(p + shift);
    for (SegmentNodes n : second.segment) {
        for (uint32_t& row : n)
            row += nodes;
        s.segment.push_back(n);
    }
    s.id.resize(s.x.size());
    std::iota(s.id.begin(), s.id.end(), 1u);
    return s;
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

TEST_CASE("another layer is the one found over all segments") {
    std::mt19937 random(21);
    std::uniform_real_distribution<double> u(-1, 1);
    std::size_t found = 0, none = 0;
    for (int round = 0; round < 240; ++round) {
        Sheet s = random_sheet(round % 6, random);
        if (round % 4 != 0)
            s = with_second(std::move(s), random_sheet(round / 6 % 6, random),
                            {u(random), u(random), -1.5 + u(random)});
        if (round % 2 == 0) // within a cone that is neither closed nor too wide
            for (Vec3& p : s.x)
                p.z = 0.4 * p.z + 0.3 * std::sin(0.9 * p.x) * std::cos(0.7 * p.y);
        const NearMesh m = near_mesh(s.mesh(), {}, whole_surface);
        const ClosestSegment closest(m);
        const NormalCone cone(m, *closest.tree());
        for (const Vec3& x : random_points(s, 20, random)) {
            const ClosestHit hit = closest.find(x);
            const double within = (2.5 + 1.5 * u(random)) * hit.foot.distance;
            const auto expected = slow_other_layer(m, x, hit.segment, within);
            const auto other = closest.other_layer(x, hit, within);
            CAPTURE(round, x.x, x.y, x.z);
            REQUIRE(other.has_value() == expected.has_value());
            const auto with_cone = closest.other_layer(x, hit, within, &cone);
            REQUIRE(with_cone.has_value() == other.has_value());
            if (other) REQUIRE(with_cone->segment == other->segment);
            ++(expected ? found : none);
            if (!expected) continue;
            REQUIRE(other->foot.distance == closest_point(m.corners(*expected), x).distance);
            REQUIRE(other->segment == *expected);
        }
    }
    CHECK(found > 500);
    CHECK(none > 500);
}

TEST_CASE("no segments") {
    const Sheet s;
    const NearMesh m = near_mesh(s.mesh(), {}, whole_surface);
    CHECK_FALSE(ClosestSegment(m).find({1, 2, 3}).found());
    const std::vector<Vec3> points{{1, 2, 3}};
    CHECK(mesh_for_closest(s.mesh(), points, 0).segment.empty());
}
