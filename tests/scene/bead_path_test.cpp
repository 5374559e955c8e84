// When a motion ends by itself, and what holds a tool. How beads go over their blank:
// tests/rules/motion_test.cpp.
#include "scene/bead_path.h"
#include "scene/holding_force.h"

#include <catch2/catch.hpp>

using namespace drawbead;

namespace {

Motion moved(bool velocity, const std::vector<double>& t, const std::vector<double>& y, double scale = 1,
             double time_scale = 1) {
    Motion motion;
    motion.terms.push_back({velocity, 0, scale, time_scale, TimeTable(t, y)});
    return motion;
}

} // namespace

TEST_CASE("a motion ends where its tables stay at rest") {
    CHECK(rest_time(Motion{}) == 0.0);
    CHECK(rest_time(moved(true, {0, 1, 2, 3}, {0, 5, 0, 0})) == 2.0);
    CHECK(rest_time(moved(true, {0, 1, 2, 3}, {0, 5, 0, 0}, 1, 0.5)) == 1.0);
    CHECK(rest_time(moved(true, {0, 1}, {0, 0})) == 0.0);
    CHECK_FALSE(rest_time(moved(true, {0, 1, 2}, {0, 5, 0}))); // the line goes on below 0
    CHECK_FALSE(rest_time(moved(true, {0, 1}, {3, 3})));
    CHECK(rest_time(moved(true, {0, 1}, {3, 3}, 0)) == 0.0);
    CHECK(rest_time(moved(false, {0, 1, 2, 3}, {0, 5, 5, 5})) == 1.0);
    CHECK_FALSE(rest_time(moved(false, {0, 1, 2}, {0, 5, 6})));
    CHECK(rest_time(moved(false, {0, 1}, {4, 4})) == 0.0);
    Motion both = moved(true, {0, 1, 2, 3}, {0, 5, 0, 0});
    both.terms.push_back({true, 1, 1, 1, TimeTable({0, 4, 5}, {1, 0, 0})});
    CHECK(rest_time(both) == 4.0);
    both.turn = Motion::Turn{{}, {0, 0, 1}, TimeTable({0, 6, 7}, {0, 1, 1})};
    CHECK(rest_time(both) == 6.0);
    both.turn->angle = TimeTable({0, 6}, {0, 1});
    CHECK_FALSE(rest_time(both));
}

TEST_CASE("a holding force is the sum of its loads over time") {
    HoldingForce force;
    force.terms.push_back({2, -10, 1, TimeTable({0, 1}, {0, 1})});
    force.terms.push_back({0, 3, 2, TimeTable({0, 1}, {1, 1})});
    CHECK(force.at(0.5).z == -5);
    CHECK(force.at(0.5).x == 3);
    CHECK(force.times() == std::vector<double>{0, 1, 2});
}
