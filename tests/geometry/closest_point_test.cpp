#include "geometry/closest_foot.h"
#include "geometry/closest_point.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <random>

using namespace drawbead;

namespace {

/// Smallest distance by samples and a shrinking search around the best ones. Never below the true minimum.
double searched_distance(const Corners& c, Vec3 x) {
    struct At {
        double squared, xi, eta;
    };
    std::vector<At> grid;
    constexpr int n = 24;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) {
            const double xi = 2.0 * i / n - 1, eta = 2.0 * j / n - 1;
            grid.push_back({squared_norm(x - patch_point(c, xi, eta)), xi, eta});
        }
    std::sort(grid.begin(), grid.end(), [](const At& a, const At& b) { return a.squared < b.squared; });
    double best = grid[0].squared;
    for (std::size_t k = 0; k < 6; ++k) {
        At at = grid[k];
        for (double step = 2.0 / n; step > 1e-9; step *= 0.6) {
            bool better = true;
            while (better) {
                better = false;
                for (int i = -1; i <= 1; ++i)
                    for (int j = -1; j <= 1; ++j) {
                        const double xi = std::clamp(at.xi + i * step, -1.0, 1.0);
                        const double eta = std::clamp(at.eta + j * step, -1.0, 1.0);
                        const double squared = squared_norm(x - patch_point(c, xi, eta));
                        if (squared < at.squared) at = {squared, xi, eta}, better = true;
                    }
            }
        }
        best = std::min(best, at.squared);
    }
    return std::sqrt(best);
}

void check_foot(const Corners& c, Vec3 x, double scale) {
    const Foot foot = closest_point(c, x);
    CAPTURE(c[0].x, c[0].y, c[0].z, c[1].x, c[1].y, c[1].z, c[2].x, c[2].y, c[2].z, c[3].x, c[3].y, c[3].z,
            x.x, x.y, x.z, foot.xi, foot.eta, int(foot.branch));
    REQUIRE(std::abs(foot.xi) <= 1);
    REQUIRE(std::abs(foot.eta) <= 1);
    REQUIRE(distance(patch_point(c, foot.xi, foot.eta), foot.point) <= 1e-11 * scale);
    REQUIRE(std::abs(distance(foot.point, x) - foot.distance) <= 1e-13 * scale);
    REQUIRE(foot.distance <= searched_distance(c, x) + 1e-9 * scale);
    if (foot.inside() && foot.branch != FootBranch::edge && foot.distance > 1e-6 * scale) {
        const Vec3 away = (x - foot.point) / foot.distance;
        REQUIRE(std::abs(std::abs(dot(away, foot.normal)) - 1) <= 1e-7);
    }
    const bool on_edge = std::abs(foot.xi) == 1 || std::abs(foot.eta) == 1;
    if (foot.edges != 0) REQUIRE(on_edge);
}

} // namespace

TEST_CASE("a point over the middle, an edge and a corner of a square") {
    const Corners c{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}};
    Foot foot = closest_point(c, {1.5, 1, 3});
    CHECK(foot.point == Vec3{1.5, 1, 0});
    CHECK(foot.xi == Approx(0.5));
    CHECK(foot.eta == Approx(0).margin(1e-15));
    CHECK(foot.distance == 3);
    CHECK(foot.inside());
    CHECK(foot.branch == FootBranch::planar);
    foot = closest_point(c, {1, -4, 3});
    CHECK(foot.point == Vec3{1, 0, 0});
    CHECK(foot.edges == 1);
    CHECK(foot.distance == 5);
    foot = closest_point(c, {5, 6, 0});
    CHECK(foot.point == Vec3{2, 2, 0});
    CHECK(foot.edges == 0b0110);
    foot = closest_point(c, {2, 0.5, 7}); // exactly over an edge: on it, not inside
    CHECK(foot.edges == 0b0010);
    foot = closest_point(c, {0, 0, 7});
    CHECK(foot.edges == 0b1001);
}

TEST_CASE("a triangle has no third edge") {
    const Corners c{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 2, 0}}};
    CHECK(closest_point(c, {0.5, 0.5, 1}).inside());
    CHECK(closest_point(c, {0.5, 0.5, 1}).eta == Approx(-0.5));
    CHECK(closest_point(c, {2, 2, 0}).edges == 0b0010);
    CHECK(closest_point(c, {-1, 1, 0}).edges == 0b1000);
    CHECK(closest_point(c, {0, 5, 0}).edges == 0b1010);
    CHECK(closest_point(c, {0, 5, 0}).eta == 1);
    CHECK(closest_point(c, {-1, -1, 0}).edges == 0b1001);
}

TEST_CASE("random segments of all shapes: the true minimum") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> u(-1, 1);
    std::map<FootBranch, int> branch;
    for (int round = 0; round < 4000; ++round) {
        Corners c{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};
        const int kind = round % 8;
        const double jitter = kind == 2 || kind == 3 ? 0.95 : 0.3;
        const double warp = kind == 0 || kind == 6 ? 0 : kind == 1 ? 0.1 : kind == 7 ? 1e-9 : 1.0;
        for (Vec3& p : c)
            p = p + Vec3{jitter * u(random), jitter * u(random), warp * u(random)};
        if (kind == 4) c[2] = c[3];
        if (kind == 5) { // a needle
            for (Vec3& p : c)
                p.y *= 1e-3, p.z *= 1e-3;
        }
        if (kind == 6 && round % 16 < 8) c[3] = c[0] + c[2] - c[1]; // parallelogram
        const Vec3 x{2.5 * u(random), 2.5 * u(random), 2.5 * u(random)};
        ++branch[closest_point(c, x).branch];
        check_foot(c, x, 5);
    }
    CHECK(branch[FootBranch::triangle] > 100);
    CHECK(branch[FootBranch::planar] > 100);
    CHECK(branch[FootBranch::newton] > 100);
    CHECK(branch[FootBranch::edge] > 100);
}

TEST_CASE("points on a segment find themselves") {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> u(-0.99, 0.99);
    for (int round = 0; round < 2000; ++round) {
        Corners c{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};
        const double warp = round % 3 == 0 ? 0 : 0.4;
        for (Vec3& p : c)
            p = p + Vec3{0.3 * u(random), 0.3 * u(random), warp * u(random)};
        const double xi = u(random), eta = u(random);
        const Foot foot = closest_point(c, patch_point(c, xi, eta));
        REQUIRE(foot.distance <= 1e-14);
        REQUIRE(foot.xi == Approx(xi).margin(1e-13));
        REQUIRE(foot.eta == Approx(eta).margin(1e-13));
        REQUIRE(foot.inside());
    }
}

TEST_CASE("a quad whose map has a second root outside") {
    const Corners c{{{0, 0, 0}, {4, 0, 0}, {4.2, 0.4, 0}, {0, 3, 0}}};
    for (const double xi : {-0.99, -0.5, 0.0, 0.7, 0.99})
        for (const double eta : {-0.99, -0.2, 0.6, 0.99}) {
            const Foot foot = closest_point(c, patch_point(c, xi, eta) + Vec3{0, 0, 2});
            CHECK(foot.xi == Approx(xi).margin(1e-12));
            CHECK(foot.eta == Approx(eta).margin(1e-12));
            CHECK(foot.distance == Approx(2));
        }
}

TEST_CASE("two minima over a saddle: the lower one") {
    const Corners saddle{{{-1, -1, 1}, {1, -1, -1}, {1, 1, 1}, {-1, 1, -1}}};
    for (int k = -10; k <= 10; ++k)
        check_foot(saddle, {0.02 * k, 0, 3}, 5);
    check_foot(saddle, {0, 0, 0}, 5);
    check_foot(saddle, {0, 0, 100}, 100);
}

TEST_CASE("segments without area, and huge or tiny ones") {
    const Vec3 x{1, 2, 3};
    CHECK(closest_point({}, x).distance == Approx(std::sqrt(14.0)));
    CHECK(closest_point({{{0, 0, 0}, {4, 0, 0}, {4, 0, 0}, {0, 0, 0}}}, x).point == Vec3{1, 0, 0});
    CHECK(closest_point({{{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {8, 0, 0}}}, x).distance ==
          Approx(std::sqrt(13.0)));
    CHECK(closest_point({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}}}, {2, 3, 1}).distance ==
          1); // a bow tie
    for (const double s : {1e-12, 1e-6, 1e6, 1e12}) {
        Corners c{{{-1, -1, 0}, {1.2, -1, 0.2}, {1, 1.1, 0}, {-1, 1, 0.3}}};
        const Foot one = closest_point(c, {0.3, 0.4, 2});
        for (Vec3& p : c)
            p = s * p;
        const Foot foot = closest_point(c, s * Vec3{0.3, 0.4, 2});
        CHECK(foot.distance == Approx(s * one.distance));
        CHECK(foot.xi == Approx(one.xi));
        CHECK(foot.eta == Approx(one.eta));
    }
}

TEST_CASE("the box is never farther than the segment") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int round = 0; round < 1000; ++round) {
        Corners c;
        for (Vec3& p : c)
            p = {u(random), u(random), u(random)};
        const Vec3 x{3 * u(random), 3 * u(random), 3 * u(random)};
        REQUIRE(std::sqrt(squared_distance_to_box(c, x)) <= closest_point(c, x).distance * (1 + 1e-15));
    }
}

TEST_CASE("the quick foot is the foot") {
    // Planar, warped, folded and triangular quads, with points over them, beside them and far away.
    const std::vector<Corners> quads{{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
                                     {{{0, 0, 0}, {1, 0, 0.3}, {1.2, 1, -0.2}, {0, 0.9, 0.4}}},
                                     {{{0, 0, 0}, {2, 0, 0}, {0.4, 0.3, 0.1}, {0, 2, 0}}},
                                     {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}, {0, 1, 0.5}}}};
    for (const Corners& c : quads)
        for (int i = -6; i <= 9; ++i)
            for (int j = -6; j <= 9; ++j)
                for (const double height : {-2.0, -0.1, 0.0, 0.4, 5.0}) {
                    const Vec3 x{0.25 * i, 0.25 * j, height};
                    const Foot quick = closest_foot(c, x), foot = closest_point(c, x);
                    CHECK(quick.distance == foot.distance);
                    CHECK(squared_norm(quick.point - foot.point) == 0);
                    CHECK(quick.edges == foot.edges);
                }
}
