#include "bead/bead_line.h"

#include <catch2/catch.hpp>

using namespace drawbead;

TEST_CASE("a straight line with uneven steps") {
    const std::vector<Vec3> x{{0, 0, 0}, {0, 1, 0}, {0, 4, 0}, {0, 6, 0}};
    const BeadLine line = bead_line(x);
    CHECK(line.s == std::vector<double>{0, 1, 4, 6});
    CHECK(line.hop == std::vector<double>{1, 3, 2});
    CHECK(line.tributary == std::vector<double>{0.5, 2, 2.5, 1});
    CHECK(line.length == 6);
    CHECK(line.half_chord[0] == Vec3{0, 0.5, 0});
    CHECK(arc_tributary(line, 0) == 0.5);
    CHECK(arc_tributary(line, 1) == 2);
    CHECK(arc_tributary(line, 3) == 1);
}

TEST_CASE("at a right angle the chord loses 29 %") {
    const BeadLine line = bead_line(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
    CHECK(line.tributary[1] == Approx(std::sqrt(0.5)));
    CHECK(arc_tributary(line, 1) == 1);
}

TEST_CASE("lines without length") {
    CHECK(bead_line({}).size() == 0);
    const BeadLine single = bead_line(std::vector<Vec3>{{1, 2, 3}});
    CHECK(single.tributary == std::vector<double>{0});
    CHECK(single.length == 0);
    CHECK(arc_tributary(single, 0) == 0);
    CHECK(limit_along(100, 300, 0, 0) == 100);
}

TEST_CASE("limits along the line") {
    CHECK(limit_along(100, 300, 1, 4) == 150);
    CHECK(limit_along(100, 0, 1, 4) == 100); // a last of 0 means constant
    CHECK(limit_along(0, 10, 4, 4) == 10);
    CHECK(normal_limit_along(0, 300, 2, 4) == 0);
    CHECK(normal_limit_along(100, 300, 4, 4) == 300);
}
