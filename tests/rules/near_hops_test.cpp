#include "rules/lin/near_hops.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace drawbead;

namespace {

LineHops whole(const std::vector<Vec3>& x) {
    LineHops line{x, {}};
    for (uint32_t i = 0; i + 1 < x.size(); ++i)
        line.hops.push_back({i, i + 1});
    return line;
}

std::vector<Vec3> straight(Vec3 from, Vec3 to, int count) {
    std::vector<Vec3> x;
    for (int i = 0; i < count; ++i)
        x.push_back(from + (i / (count - 1.0)) * (to - from));
    return x;
}

} // namespace

TEST_CASE("the closest points of two segments are not beaten by any sample") {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> u(-1, 1);
    const auto point = [&] { return Vec3{u(random), u(random), u(random)}; };
    for (int round = 0; round < 300; ++round) {
        const Vec3 p0 = point(), p1 = point(), q0 = point(), q1 = round % 7 == 0 ? q0 : point();
        const SegmentPair best = closest_of_segments(p0, p1, q0, q1);
        CHECK(norm((p0 + best.s * (p1 - p0)) - (q0 + best.t * (q1 - q0))) ==
              Approx(best.distance).margin(1e-15));
        double least = 1e300;
        for (int i = 0; i <= 40; ++i)
            for (int j = 0; j <= 40; ++j)
                least = std::min(least, norm((p0 + (i / 40.0) * (p1 - p0)) - (q0 + (j / 40.0) * (q1 - q0))));
        CHECK(best.distance <= least * (1 + 1e-12));
        CHECK(best.distance >= least - 0.1); // the samples are at most that far apart
    }
}

TEST_CASE("near hops are those that all pairs give") {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int round = 0; round < 20; ++round) {
        std::vector<Vec3> a, b;
        for (int i = 0; i < 60; ++i) {
            a.push_back({i * 0.5, std::sin(i * 0.3) + 0.1 * u(random), 0.05 * u(random)});
            b.push_back({i * 0.4 + 2, std::cos(i * 0.2) + 0.1 * u(random), 0.05 * u(random)});
        }
        if (round % 4 == 0) b.push_back({-500, 0, 0}); // a hop that is much longer than the others
        const LineHops first = whole(a), second = whole(b);
        const double distance = 0.05 + 0.02 * round;
        std::size_t expected = 0;
        for (const HopEnds& p : first.hops)
            for (const HopEnds& q : second.hops)
                expected += closest_of_segments(a[p.from], a[p.to], b[q.from], b[q.to]).distance <= distance;
        CHECK(expected > 0);
        CHECK(near_hops(first, second, distance).size() == expected);
    }
}

TEST_CASE("a line that goes on where another ends meets it at its end") {
    const std::vector<Vec3> a = straight({0, 0, 0}, {10, 0, 0}, 6), b = straight({10.5, 0, 0}, {20, 3, 0}, 6),
                            c = straight({5, 0.5, 0}, {5, 9, 0}, 6);
    const auto on = near_hops(whole(a), whole(b), 1);
    REQUIRE(on.size() == 1);
    CHECK(on.front().ends_meet);
    const auto tee = near_hops(whole(a), whole(c), 1);
    REQUIRE_FALSE(tee.empty());
    for (const NearHops& pair : tee)
        CHECK_FALSE(pair.ends_meet);
    CHECK(near_hops(whole(a), whole(c), 0.4).empty());
}
