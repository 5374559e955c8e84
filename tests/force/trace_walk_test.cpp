// A blank that moves as one, as one bead's rows tell it.
#include "force/trace_walk.h"

#include <catch2/catch.hpp>

using namespace drawbead;
using C = TraceColumn;

namespace {

/// 3 × 3 nodes 1 to 9, spaced by 0.1; a row looks at the segment 1 2 5 4.
NearMesh nine_nodes() {
    NearMesh mesh;
    for (uint32_t j = 0; j < 3; ++j)
        for (uint32_t i = 0; i < 3; ++i) {
            mesh.node_id.push_back(3 * j + i + 1);
            mesh.x.push_back({0.1 * i, 0.1 * j, 0});
        }
    mesh.surface_min = {0, 0, 0};
    mesh.surface_max = {0.2, 0.2, 0};
    return mesh;
}

TraceRow row(int cycle, double dt, const std::vector<Vec3>& x, Vec3 v) {
    TraceRow row{};
    const auto put = [&](C column, double value) { row.value[static_cast<std::size_t>(column)] = value; };
    put(C::ncycle, cycle);
    put(C::dt1, dt);
    const std::array<uint32_t, 4> nodes{1, 2, 5, 4};
    for (std::size_t k = 0; k < 4; ++k) {
        put(after(C::seg_n1, k), nodes[k]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            put(after(C::x1, 3 * k + axis), x[nodes[k] - 1].*axes[axis]);
            put(after(C::vx1, 3 * k + axis), v.*axes[axis]);
        }
    }
    return row;
}

} // namespace

TEST_CASE("from a late first cycle on, nodes in line with recorded ones are where the solver has them") {
    const NearMesh mesh = nine_nodes();
    const Vec3 v{0.7, 0.3, 0};
    const double dt = 1.0 / 3;
    std::vector<Vec3> x = mesh.x; // as the solver sums them
    RigidBlank blank(mesh);
    bool rounded = false;
    for (int cycle = 1; cycle <= 40; ++cycle) {
        for (Vec3& p : x)
            p += dt * v;
        if (cycle < 30) continue;
        const std::array rows{row(cycle, dt, x, v)};
        REQUIRE(blank.follow(rows));
        // Nodes 1, 2, 4 and 5 are recorded; 3 and 6 share their y with them, 7 and 8 their x.
        for (const std::size_t i : {0U, 1U, 3U, 4U})
            CHECK(blank.x()[i] == x[i]);
        CHECK(blank.x()[2].y == x[2].y);
        CHECK(blank.x()[6].x == x[6].x);
        CHECK(blank.x()[7].x == x[7].x);
        CHECK(distance(blank.x()[8], x[8]) < 1e-13);
        for (std::size_t i = 0; i < 9; ++i)
            rounded = rounded || x[i] != mesh.x[i] + (x[0] - mesh.x[0]);
    }
    CHECK(rounded); // moving all by one vector would not have been the same
    CHECK(blank.velocity() == v);
    CHECK(distance(blank.moved(), 40 * dt * v) < 1e-13);
}

TEST_CASE("a blank that does not move as one is not followed any further, and why is said") {
    const NearMesh mesh = nine_nodes();
    RigidBlank blank(mesh);
    const std::array still{row(0, 0, mesh.x, {})};
    REQUIRE(blank.follow(still));
    std::vector<Vec3> bent = mesh.x;
    bent[4].z = 0.01;
    const std::array rows{row(1, 0.1, bent, {})};
    CHECK_FALSE(blank.follow(rows));
    CHECK(blank.why_not() == "the blank does not move as one from cycle 1 on");
    CHECK_FALSE(blank.follow(still));
}
