#include "contact/blank_stiffness.h"

#include <catch2/catch.hpp>

using namespace drawbead;

TEST_CASE("stiffness of shells and solid faces") {
    CHECK(shell_stiffness(210000, 1) == 42000);
    CHECK(solid_face_stiffness(25, 175000, 125) == 175000);
    CHECK(solid_face_stiffness(25, 175000, 0) == 0);
    CHECK(of_shell(210000, 0.8).half_thickness == 0.4);
    const SegmentStiffness both = coated(of_solid_face(25, 100, 125), of_shell(210000, 1));
    CHECK(both.k == 42000);
    CHECK(both.half_thickness == 0.5);
    CHECK(both.smallest == 100); // both are in the minimum
}

TEST_CASE("the minimum leaves segments without element out") {
    const std::vector<SegmentStiffness> s{of_shell(210000, 1), {}, of_shell(210000, 0.5)};
    CHECK(smallest_stiffness(s) == 21000);
    CHECK(smallest_stiffness(std::vector<SegmentStiffness>(3)) == std::numeric_limits<double>::infinity());
}

TEST_CASE("the slope and its reset") {
    CHECK(choose_slope(0, 5, 42000).kind == Slope::none);
    CHECK(choose_slope(0, 0, 42000).kind == Slope::none);
    CHECK(choose_slope(100, 5, 42000).kind == Slope::ramp);
    CHECK(choose_slope(100, 5, 42000).of(42000) == 20);
    CHECK(choose_slope(420, 0.01, 42000).kind == Slope::ramp); // equal is not over
    CHECK(choose_slope(1000, 0.01, 42000).kind == Slope::reset);
    CHECK(choose_slope(1000, 0.01, 42000).of(126000) == 126000);
    CHECK(choose_slope(1000, 0.01, 0).kind == Slope::ramp); // a minimum of 0 never resets
    CHECK(choose_slope(100, 0, 42000).kind == Slope::depth_absent);
    CHECK(choose_slope(100, -5, 42000).kind == Slope::depth_absent);
    CHECK(choose_slope(100, 1e-20, 42000).kind == Slope::depth_absent);
    CHECK(choose_slope(-100, 5, 42000).of(42000) == -20);
}

TEST_CASE("the slope is read with the bead node's place in the list") {
    const std::vector<double> k{42000, 126000};
    const SlopeChoice reset = choose_slope(1000, 0.001, 42000);
    CHECK(slope_read(reset, k, 2, 1) == 126000);
    CHECK_FALSE(slope_read(reset, k, 2, 2));
    const SlopeChoice ramp = choose_slope(100, 5, 42000);
    CHECK(slope_read(ramp, {}, 2, 1) == 20);
    CHECK_FALSE(slope_read(ramp, {}, 2, 2));
    CHECK(slope_read(choose_slope(0, 5, 42000), {}, 2, 0) == 0);
}

TEST_CASE("what the Starter says") {
    const StarterVerdict clean = starter_verdict({true, 2, false, 100, 5, 42000}, {});
    CHECK(clean.clean());
    const StarterVerdict all = starter_verdict({false, 1, true, 1000, 0.01, 42000}, {3, 4});
    CHECK(all.error_112);
    CHECK(all.error_703);
    CHECK(all.warning_1040);
    CHECK_FALSE(all.warning_1043);
    CHECK(all.nodes_346 == std::vector<uint32_t>{3, 4});
    CHECK(all.stops());
    CHECK(starter_verdict({true, 1, false, 100, 0, 42000}, {}).warning_1043);
}
