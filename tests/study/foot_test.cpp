// Feet of the studied path against the library's own.
#include "geometry/closest_point.h"
#include "study/segment_foot.h"

#include <catch2/catch.hpp>

#include <random>

using namespace drawbead;

TEST_CASE("closest foot: as the library finds it, on flat, warped and three-cornered segments") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int round = 0; round < 2000; ++round) {
        const double warp = round % 3 == 0 ? 0 : 0.3;
        Corners c{Vec3{-2 + 0.5 * any(random), -2 + 0.5 * any(random), warp * any(random)},
                  Vec3{2 + 0.5 * any(random), -2 + 0.5 * any(random), warp * any(random)},
                  Vec3{2 + 0.5 * any(random), 2 + 0.5 * any(random), warp * any(random)},
                  Vec3{-2 + 0.5 * any(random), 2 + 0.5 * any(random), warp * any(random)}};
        if (round % 4 == 1) c[3] = c[2];
        const Vec3 x{2.5 * any(random), 2.5 * any(random), 2 * any(random)};
        const Foot expected = closest_point(c, x);
        const SegmentFoot<double> foot = closest_foot<double>(c, x);
        CHECK(std::abs(foot.distance) == Approx(expected.distance).epsilon(1e-9).margin(1e-9));
        if (expected.inside()) CHECK(distance(foot.normal, expected.normal) < 1e-6);
        const std::array<BasicVec3<float>, 4> f{BasicVec3<float>{float(c[0].x), float(c[0].y), float(c[0].z)},
                                                {float(c[1].x), float(c[1].y), float(c[1].z)},
                                                {float(c[2].x), float(c[2].y), float(c[2].z)},
                                                {float(c[3].x), float(c[3].y), float(c[3].z)}};
        const SegmentFoot<float> in_float = closest_foot<float>(f, {float(x.x), float(x.y), float(x.z)});
        CHECK(std::abs(double(in_float.distance)) == Approx(expected.distance).epsilon(1e-4).margin(1e-4));
    }
}

TEST_CASE("ratio foot: exact on a trapezoid, beside the closest point on a skewed segment") {
    const Corners trapezoid{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{3, 2, 0}, Vec3{1, 2, 0}};
    const Vec3 x{2.2, 0.9, 0.5};
    CHECK(ratio_foot<double>(trapezoid, x).xi == Approx(closest_point(trapezoid, x).xi).epsilon(1e-12));
    const Corners skewed{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{4.4, 3.1, 0}, Vec3{1, 2, 0}};
    const SegmentFoot<double> ratio = ratio_foot<double>(skewed, {1, 0.9, 0.5}),
                              exact = closest_foot<double>(skewed, {1, 0.9, 0.5});
    CHECK(std::abs(ratio.xi - exact.xi) > 1e-3);
    CHECK(ratio.distance == Approx(exact.distance).epsilon(1e-14)); // flat: the height does not depend on it
}
