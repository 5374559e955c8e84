// The reference against closed forms.
#include "sheet.h"
#include "study/reference.h"

#include <catch2/catch.hpp>

using namespace drawbead;
using namespace drawbead::testing;

namespace {

/// A slider of stiffness 1 and limit 0.4 per node: two nodes, half a hop of 8 mm each.
Sheet unit_slider() {
    return Sheet(straight(2, 8), {0, 0, 0.1, 0, 5}, 5);
}

ReferenceBead reference(const Sheet& s, std::size_t steps, Truth truth = Truth::line) {
    EvaluationScene grid = s.scene;
    set_steps(grid, 0, s.scene.time.back(), steps);
    return reference_of(s.scene, 0, grid.time, {truth, 1e-8, 1});
}

} // namespace

TEST_CASE("reference: one period between −1 and 1 costs 0.88, the next ones 0.96") {
    // 4 F (X − F/k) in the loop; from a virgin start one way of the spring less.
    for (const Truth truth : {Truth::line, Truth::nodes, Truth::arc}) {
        Sheet s = unit_slider();
        std::vector<double> at{0}, u{0};
        for (const double x : {1.0, -1.0, 0.0}) {
            at.push_back(at.back() + 0.1 + 0.037 * x);
            u.push_back(x);
        }
        s.blank().terms.push_back(displacement(0, at, u));
        set_steps(s.scene, 0, at.back(), 100);
        const ReferenceBead first = reference(s, 64, truth);
        CHECK(first.absorbed == Approx(2 * 0.88).epsilon(1e-13));
        CHECK(first.dissipated() == Approx(2 * 0.80).epsilon(1e-13));
        CHECK(first.restraint_largest == Approx(2 * 0.4).epsilon(1e-14));
        REQUIRE(first.first_slip);
        CHECK(*first.first_slip == Approx(0.4 * 0.137).epsilon(1e-12));

        Sheet more = unit_slider();
        for (const double x : {1.0, -1.0, 0.0}) {
            at.push_back(at.back() + 0.1 + 0.037 * x);
            u.push_back(x);
        }
        more.blank().terms.push_back(displacement(0, at, u));
        set_steps(more.scene, 0, at.back(), 100);
        CHECK(reference(more, 64, truth).absorbed - first.absorbed == Approx(2 * 0.96).epsilon(1e-13));
    }
}

TEST_CASE("reference: what stays below the limit costs nothing") {
    Sheet s = unit_slider();
    s.blank().terms.push_back(displacement(0, {0, 0.21, 0.55, 1}, {0, 0.39, -0.39, 0}));
    const ReferenceBead r = reference(s, 50);
    CHECK(std::abs(r.absorbed) < 1e-15);
    CHECK_FALSE(r.first_slip);
    CHECK(r.restraint_largest == Approx(2 * 0.39).epsilon(1e-13));
}

TEST_CASE("reference: the capped viscous force and its work") {
    // v = V t, force c V t up to f: work c V²/3 t³ until then, f V/2 (1 − t²) after it.
    Sheet s(straight(2, 8), {0, 0, 0.1, 0, 5});
    s.scene.beads[0].iform = 1;
    const double c = std::sqrt(0.2 * 210000 * 2e-7), V = 2 * 0.4 / c;
    s.blank().terms.push_back(velocity(0, {0, 1}, {0, V}));
    const ReferenceBead r = reference(s, 2000);
    const double expected = 2 * (c * V * V / 3 * 0.125 + 0.4 * V / 2 * 0.75);
    CHECK(r.absorbed == Approx(expected).epsilon(1e-9));
    REQUIRE(r.first_slip);
    CHECK(*r.first_slip == Approx(0.5).epsilon(1e-12));
}

TEST_CASE("reference: contact where the tool comes down, and the ramp") {
    Sheet s(straight(5, 8, 8), {100, 0, 0, 0, 5});
    s.tool().terms.push_back(velocity(2, {0, 1}, {-9, -9}));
    const ReferenceBead r = reference(s, 128);
    REQUIRE(r.first_contact);
    CHECK(*r.first_contact == Approx((8 - 5.5) / 9).epsilon(1e-14));
    for (std::size_t n = 0; n < r.time.size(); ++n) {
        const double deep = 5.5 - (8 - 9 * r.time[n]);
        CHECK(r.normal[n].z == Approx(-3200 * std::clamp(deep / 5, 0.0, 1.0)).margin(1e-10));
    }
}

TEST_CASE("reference: readings of a curved line") {
    const std::size_t hops = 9;
    Sheet s(quarter(hops), {10, 0, 0, 0, 5}, 210000, 0.7);
    const double angle = 0.5 * std::numbers::pi / hops;
    const double by_hops = hops * 80 * std::sin(angle / 2);
    const double by_chords = (hops - 1) * 40 * std::sin(angle) + 80 * std::sin(angle / 2);
    CHECK(reference(s, 8).normal_largest == Approx(10 * by_hops).epsilon(1e-13));
    CHECK(reference(s, 8, Truth::arc).normal_largest == Approx(10 * by_hops).epsilon(1e-13));
    CHECK(reference(s, 8, Truth::nodes).normal_largest == Approx(10 * by_chords).epsilon(1e-13));
}

TEST_CASE("reference: where limits vary along the line the quadrature adapts") {
    Sheet s(straight(4, 10), {10, 30, 0, 0, 5});
    CHECK(reference(s, 8).normal_largest == Approx(20 * 30).epsilon(1e-12));
    // A bead that leaves the sheet: half of its last hop is over it.
    Sheet edge({{72, 130, 0.3}, {72, 140, 0.3}, {72, 160, 0.3}}, {10, 0, 0, 0, 5});
    // Up to 5 % of a segment beyond the edge, y = 150.
    CHECK(reference(edge, 8).normal_largest == Approx(10 * (20 + 0.25)).epsilon(4e-3));
}

TEST_CASE("reference: moved together nothing is felt; a turning sheet under a turning bead") {
    Sheet s(quarter(6), {10, 0, 5, 0, 5});
    for (Motion& m : s.scene.motions) {
        m.turn = Motion::Turn{{50, 50, 0}, {0, 0, 1}, TimeTable({0, 0.4, 1}, {0, 1, -0.5})};
        m.terms.push_back(velocity(1, {0, 1}, {3, -8}));
    }
    const ReferenceBead r = reference(s, 32);
    CHECK(r.restraint_largest < 1e-9);
    CHECK_FALSE(r.first_slip);
}
