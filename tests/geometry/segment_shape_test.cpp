#include "geometry/segment_shape.h"

#include <catch2/catch.hpp>

using namespace drawbead;

TEST_CASE("areas and normals") {
    const Corners square{{{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}}};
    CHECK(area(square) == 6);
    CHECK(area_vector(square) == Vec3{0, 0, 6});
    CHECK(patch_normal(square, 0.3, -0.7) == Vec3{0, 0, 1});
    const Corners triangle{{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 3, 0}}};
    CHECK(is_triangle(triangle));
    CHECK(area(triangle) == 3);
    CHECK(patch_normal(triangle, 0, 1) == Vec3{0, 0, 1});
    const Corners line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}};
    CHECK(area(line) == 0);
    CHECK(patch_normal(line, 0, 0) == Vec3{});
}

TEST_CASE("the normal of a warped quad turns over it") {
    const Corners saddle{{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}};
    CHECK(patch_normal(saddle, -1, -1) == Vec3{0, 0, 1});
    const Vec3 n = patch_normal(saddle, 1, 1);
    CHECK(n.x == Approx(-1 / std::sqrt(3.0)));
    CHECK(n.y == Approx(-1 / std::sqrt(3.0)));
    CHECK(n.z == Approx(1 / std::sqrt(3.0)));
}

TEST_CASE("weights sum to one and give the corners") {
    const Corners c{{{0, 0, 0}, {4, 1, 0}, {5, 3, 1}, {-1, 2, 0}}};
    CHECK(patch_point(c, -1, -1) == c[0]);
    CHECK(patch_point(c, 1, -1) == c[1]);
    CHECK(patch_point(c, 1, 1) == c[2]);
    CHECK(patch_point(c, -1, 1) == c[3]);
    const auto h = bilinear_weights(0.3, -0.6);
    CHECK(h[0] + h[1] + h[2] + h[3] == Approx(1));
}

TEST_CASE("volume of a solid by one point") {
    std::array<Vec3, 8> box{
        {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}, {0, 0, 4}, {2, 0, 4}, {2, 3, 4}, {0, 3, 4}}};
    CHECK(one_point_volume(box) == 24);
    for (int k = 0; k < 4; ++k)
        std::swap(box[std::size_t(k)], box[std::size_t(k) + 4]); // inside out
    CHECK(one_point_volume(box) == 24);
}

TEST_CASE("which way a face looks") {
    const Corners top{{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
    CHECK(faces_away(top, {0.5, 0.5, 0.5}));
    CHECK_FALSE(faces_away(top, {0.5, 0.5, 1.5}));
}
