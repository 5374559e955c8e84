// Closed forms of the manual's law, to rounding.
#include "force/manual_law.h"

#include <catch2/catch.hpp>
#include <numbers>

using namespace drawbead;

namespace {

constexpr double tight = 1e-14;

bool close(double value, double expected, double scale) {
    return std::abs(value - expected) <= tight * scale;
}

/// A node over a flat blank (normal z) with the line along y: across the bead is −x, tributary `length`.
struct Node {
    BeadLaw<double> law;
    ManualContact<double> at;
    ManualInput<double> input;
    double q = 0;

    explicit Node(double stiffness, double limit, double length = 1) {
        law.ft_first = limit;
        law.depth = 1;
        at.normal = {0, 0, 1};
        at.distance = 0;
        at.stiffness = stiffness;
        input.half_chord = {0, length, 0};
        input.tributary = length;
    }

    template <Restraint R>
    ManualForce<double> step(double displacement, double velocity = 0) {
        const Vec3 u = cross(at.normal, input.half_chord) / norm(cross(at.normal, input.half_chord));
        input.displacement = displacement * u;
        input.velocity = velocity * u;
        return manual_node_force<double, Effects{R, true, true}>(law, at, input, q);
    }
};

/// 8-point Gauss–Legendre on [a, b].
template <class F>
double gauss(double a, double b, F f) {
    constexpr std::array<double, 4> x{0.18343464249564980494, 0.52553240991632898582, 0.79666647741362673959,
                                      0.96028985649753623168};
    constexpr std::array<double, 4> w{0.36268378337836198297, 0.31370664587788728734, 0.22238103445337447054,
                                      0.10122853629037625915};
    const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i)
        sum += w[i] * (f(middle - half * x[i]) + f(middle + half * x[i]));
    return half * sum;
}

template <class F>
double integral(double a, double b, F f) {
    constexpr int panels = 16;
    double sum = 0;
    for (int i = 0; i < panels; ++i)
        sum += gauss(a + (b - a) * i / panels, a + (b - a) * (i + 1) / panels, f);
    return sum;
}

} // namespace

TEST_CASE("slider: elastic up to the limit, then constant") {
    for (const double length : {1.0, 2.5}) {
        Node node(1, 0.4, length);
        double u = 0;
        for (int i = 0; i < 40; ++i) {
            node.step<Restraint::incremental>(0.05);
            u += 0.05;
            CHECK(close(node.q, std::min(u, 0.4 * length), 1));
        }
    }
}

TEST_CASE("loop energy: a virgin cycle costs 0.88, a steady one 4 F (X - F/k), sub-stick cycling nothing") {
    Node node(1, 0.4);
    // Corners of the force over a cycle of amplitude 1 are met exactly, so the trapezium rule is exact.
    auto travel = [&](double from, double to) {
        double work = 0;
        constexpr int steps = 250;
        for (int i = 0; i < steps; ++i) {
            const double before = node.q;
            node.step<Restraint::incremental>((to - from) / steps);
            work += 0.5 * (before + node.q) * (to - from) / steps;
        }
        return work;
    };
    const double virgin = travel(0, 1) + travel(1, -1) + travel(-1, 0);
    CHECK(close(virgin, 0.88, 4));
    const double steady = travel(0, 1) + travel(1, -1) + travel(-1, 0);
    CHECK(close(steady, 4 * 0.4 * (1 - 0.4), 4));
    Node stuck(1, 0.4);
    double work = 0;
    for (const double d : {0.3, -0.6, 0.3}) {
        const double before = stuck.q;
        stuck.step<Restraint::incremental>(d);
        work += 0.5 * (before + stuck.q) * d;
    }
    CHECK(close(work, 0, 1));
    CHECK(close(stuck.q, 0, 1));
}

TEST_CASE("viscous cycle: pi c V^2 / w below the limit, the capped form above") {
    const double stiffness = 4, mass = 0.25, c = std::sqrt(stiffness * mass), w = 3, limit = 0.7;
    auto work = [&](double V) {
        Node node(stiffness, limit);
        node.at.mass = mass;
        auto power = [&](double t) {
            const double v = V * std::sin(w * t);
            return node.step<Restraint::viscous>(0, v).restraint * v;
        };
        const double quarter = std::numbers::pi / (2 * w);
        const double kink = V * c > limit ? std::asin(limit / (c * V)) / w : quarter;
        return 4 * (integral(0, kink, power) + integral(kink, quarter, power));
    };
    CHECK(close(work(0.5), std::numbers::pi * c * 0.25 / w, 1));
    const double V = 2, th = std::asin(limit / (c * V));
    const double capped = 4 / w * (c * V * V * (th / 2 - std::sin(2 * th) / 4) + limit * V * std::cos(th));
    CHECK(close(work(V), capped, capped));
}

TEST_CASE("ramp: linear to the limit, or the blank's stiffness when that is softer") {
    Node node(1000, 50, 2);
    node.law.fn_first = 100;
    node.law.depth = 0.5;
    node.at.half_thickness = 0.4;
    for (const double d : {1.0, 0.9, 0.8, 0.6, 0.4, 0.1, -3.0}) {
        node.at.distance = d;
        const double delta = 0.5 - d + 0.4;
        const ManualForce<double> f = node.step<Restraint::incremental>(1e3);
        const double r = std::clamp(delta / 0.5, 0.0, 1.0);
        INFO("d = " << d);
        CHECK(close(f.normal_force, 200 * r, 200));
        CHECK(close(f.restraint, 100 * r, 100));
        CHECK_FALSE(f.reset);
    }
    node.at.stiffness = 250;
    node.q = 0;
    for (const double d : {1.0, 0.8, 0.5, 0.1, 0.0}) {
        node.at.distance = d;
        const double delta = std::max(0.9 - d, 0.0);
        const ManualForce<double> f = node.step<Restraint::incremental>(1e6);
        CHECK(close(f.normal_force, std::min(250 * delta, 200.0), 200));
        CHECK(close(f.restraint, 100 * f.normal_force / 200, 100));
        CHECK(f.reset == (delta > 0));
    }
}

TEST_CASE("depth 0 is the reset with the step law as limit; negative limits count as 0; the edge lets go") {
    Node node(1e6, 50);
    node.law.fn_first = 10;
    node.law.depth = 0;
    node.at.half_thickness = 0.5;
    node.at.distance = 0.5 - 1e-4;
    CHECK(close(node.step<Restraint::incremental>(1).normal_force, 10, 10));
    node.law.fn_first = -10;
    node.law.ft_first = -1;
    const ManualForce<double> none = node.step<Restraint::incremental>(1);
    CHECK(none.normal_force == 0);
    CHECK(none.restraint == 0);
    node.law.ft_first = 50;
    CHECK(node.step<Restraint::incremental>(1).restraint == 50);
    node.at.on_surface = false;
    CHECK(node.step<Restraint::incremental>(1).restraint == 0);
    CHECK(node.q == 0);
}

TEST_CASE("limits are linear along the line, interpolated before they are cut at 0") {
    CHECK(manual_limit(100.0, 300.0, 0.25) == 150);
    CHECK(manual_limit(100.0, 0.0, 0.25) == 100);
    CHECK(manual_limit(-100.0, 100.0, 0.75) == 50);
    CHECK(manual_limit(-100.0, 100.0, 0.25) == 0);
    CHECK(manual_limit(100.0f, 300.0f, 0.5f) == 200.0f);
}
