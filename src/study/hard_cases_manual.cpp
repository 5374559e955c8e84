// Hard cases of the manual's law: one bead node, as the kernel sees it.
#include "force/manual_law.h"
#include "study/hard_case_table.h"

#include <array>

namespace drawbead {

namespace {

/// A node over a flat blank (normal z), the line along y: across the bead is −x. On the plateau.
template <class Real>
struct Node {
    BeadLaw<Real> law{100, 0, 50, 0, 5};
    ManualContact<Real> at;
    ManualInput<Real> in;
    Real q = 0;

    Node() {
        at.normal = {0, 0, 1};
        at.distance = Real(0.25);
        at.stiffness = 42000;
        at.half_thickness = Real(0.5);
        at.mass = Real(2e-7);
        in.half_chord = {0, 4, 0};
        in.tributary = 4;
    }

    /// The blank goes `way` across the bead, at `speed`.
    template <Effects E>
    ManualForce<Real> run(Real way, Real speed) {
        in.displacement = {-way, 0, 0};
        in.velocity = {-speed, 0, 0};
        return manual_node_force<Real, E>(law, at, in, q);
    }
    ManualForce<Real> stick(Real way) { return run<Effects{Restraint::incremental, true, true}>(way, 0); }
    ManualForce<Real> drag(Real speed) { return run<Effects{Restraint::viscous, true, true}>(0, speed); }
    /// Compiled for limits that do not change along the bead.
    ManualForce<Real> stick_constant(Real way) {
        return run<Effects{Restraint::incremental, true, false}>(way, 0);
    }
};

template <class Real>
bool is_finite(const ManualForce<Real>& f) {
    return std::isfinite(f.restraint) && std::isfinite(f.normal_force) && std::isfinite(f.slip) &&
           std::isfinite(f.ramp) && std::isfinite(f.total.x) && std::isfinite(f.total.y) &&
           std::isfinite(f.total.z);
}

template <class Real>
HardCaseResult rest_viscous() {
    Node<Real> node;
    const auto f = node.drag(0);
    return within(std::abs(f.restraint) + std::abs(f.normal_force - 400), 0);
}

template <class Real>
HardCaseResult rest_incremental() {
    Node<Real> node;
    node.q = 123;
    Largest error;
    for (int i = 0; i < 10; ++i)
        error.add(std::abs(node.stick(0).restraint - 123));
    return within(error.value(), 0);
}

template <class Real>
HardCaseResult reversal_each_step() {
    Node<Real> node;
    Largest over;
    for (int i = 0; i < 200; ++i) {
        node.stick(i % 2 == 0 ? Real(1) : Real(-1));
        over.add(std::abs(node.q) / 200 - 1);
    }
    return within(over.value(), 0);
}

/// Travel from one place to the other in steps that meet every corner of the force; the work taken up.
template <class Real>
double travel(Node<Real>& node, double from, double to, int steps) {
    double work = 0;
    const double way = (to - from) / steps;
    for (int i = 0; i < steps; ++i) {
        const double before = node.q;
        node.stick(static_cast<Real>(way));
        work += 0.5 * (before + static_cast<double>(node.q)) * way;
    }
    return work;
}

/// k = 1, limit 0.4, amplitude 1.
template <class Real>
Node<Real> unit_slider() {
    Node<Real> node;
    node.law.ft_first = Real(0.1);
    node.at.stiffness = 1;
    node.law.fn_first = 0;
    return node;
}

template <class Real>
HardCaseResult cyclic_slip() {
    Node<Real> node = unit_slider<Real>();
    const double virgin = travel(node, 0, 1, 250) + travel(node, 1, -1, 250) + travel(node, -1, 0, 250);
    const double steady = travel(node, 0, 1, 250) + travel(node, 1, -1, 250) + travel(node, -1, 0, 250);
    return within(std::abs(virgin - 0.88) + std::abs(steady - 4 * 0.4 * (1 - 0.4)), 400 * eps<Real>);
}

template <class Real>
HardCaseResult sub_stick_cycle() {
    Node<Real> node = unit_slider<Real>();
    double work = 0;
    for (int cycle = 0; cycle < 50; ++cycle)
        work += travel(node, 0, 0.25, 4) + travel(node, 0.25, -0.25, 8) + travel(node, -0.25, 0, 4);
    return within(std::abs(work) + std::abs(node.q), 0); // powers of two: nothing is rounded
}

template <class Real>
HardCaseResult ramp_start() {
    Node<Real> node;
    const Real step = 8 * eps<Real>;
    node.at.distance = Real(5.5) - step;
    const double inside = node.stick(0).normal_force;
    node.at.distance = Real(5.5) + step;
    return within(std::abs(inside - static_cast<double>(node.stick(0).normal_force)), 80 * 2 * step);
}

template <class Real>
HardCaseResult first_touch_without_normal_force() {
    Node<Real> node;
    node.law.fn_first = 0;
    const Real step = 8 * eps<Real>;
    node.at.distance = Real(5.5) - step;
    return within(node.stick(1000).restraint, 200 * 2 * step / 5);
}

template <class Real>
HardCaseResult plateau_edge() {
    Node<Real> node;
    Largest error;
    node.at.distance = Real(0.5); // δ = DEPTH
    error.add(std::abs(node.stick(0).normal_force - 400));
    for (const Real past : {eps<Real>, Real(0.01), Real(10), Real(1e6)}) {
        node.at.distance = Real(0.5) - past;
        error.add(std::abs(node.stick(0).normal_force - 400));
    }
    return within(error.value(), 0);
}

template <class Real>
HardCaseResult restraint_past_depth() {
    Node<Real> node;
    node.law.fn_first = 0;
    node.at.distance = -20;
    return within(node.stick(1000).restraint - 200, 0);
}

template <class Real>
HardCaseResult soft_blank() {
    Node<Real> node;
    node.at.stiffness = 10; // the ramp of 80 is steeper
    Largest error;
    for (const Real d : {Real(5.5), Real(5), Real(1), Real(-34.5), Real(-35), Real(-1e4)}) {
        node.at.distance = d;
        const double expected = std::min(10.0 * (5.5 - static_cast<double>(d)), 400.0);
        error.add(std::abs(node.stick(0).normal_force - expected));
    }
    return within(error.value(), 0);
}

/// Limits of the force at DEPTH → 0 against those at DEPTH = 0.
template <class Real>
HardCaseResult vanishing_depth() {
    Node<Real> at_zero;
    at_zero.law.depth = 0;
    Largest error;
    for (const Real depth : {Real(1e-10), Real(1e-30), std::numeric_limits<Real>::min(),
                             std::numeric_limits<Real>::denorm_min(), Real(0)}) {
        for (const Real d : {Real(0.5), Real(0.4990), Real(0.25), Real(-1)}) {
            Node<Real> node;
            node.law.depth = depth;
            node.at.distance = at_zero.at.distance = d;
            at_zero.q = 0;
            const auto f = node.stick(1000), expected = at_zero.stick(1000);
            if (!is_finite(f)) error.add(HUGE_VAL);
            error.add(std::abs(f.normal_force - expected.normal_force));
        }
    }
    return within(error.value(), 42000 * 1e-10 * (1 + 1e-3));
}

template <class Real>
HardCaseResult negative_depth() {
    Node<Real> node, at_zero;
    node.law.depth = -3;
    at_zero.law.depth = 0;
    Largest error;
    for (const Real d : {Real(2), Real(0.5), Real(0.498), Real(0)}) {
        node.at.distance = at_zero.at.distance = d;
        error.add(std::abs(node.stick(0).normal_force - at_zero.stick(0).normal_force));
    }
    return within(error.value(), 0);
}

template <class Real>
HardCaseResult negative_restraint() {
    Node<Real> node;
    node.law.ft_first = -50;
    return within(std::abs(node.stick_constant(1000).restraint), 0);
}

template <class Real>
HardCaseResult negative_normal_force() {
    Node<Real> node;
    node.law.fn_first = -100;
    return within(std::abs(node.stick_constant(0).normal_force), 0);
}

template <class Real>
HardCaseResult limit_crosses_zero() {
    Node<Real> node;
    node.law.ft_first = -50;
    node.law.ft_last = 50;
    Largest error;
    for (int i = 0; i <= 8; ++i) {
        node.in.s_fraction = Real(i) / 8;
        node.q = 0;
        error.add(std::abs(node.stick(1000).restraint - 4 * std::max(-50 + 100 * i / 8.0, 0.0)));
    }
    return within(error.value(), 0);
}

template <class Real>
HardCaseResult zero_last_is_constant() {
    Node<Real> node;
    node.in.s_fraction = 1;
    return within(std::abs(node.stick(1000).restraint - 200), 0);
}

template <class Real>
HardCaseResult no_first_normal_force() {
    Node<Real> node;
    node.law.fn_first = 0;
    node.law.fn_last = 100;
    node.in.s_fraction = Real(0.5);
    return within(std::abs(node.stick(0).normal_force), 0);
}

template <class Real>
HardCaseResult lift_off() {
    Node<Real> node;
    node.stick(1);
    node.at.distance = 20;
    node.stick(0);
    node.at.distance = Real(0.25);
    return within(std::abs(node.stick(0).restraint), 0);
}

template <class Real>
HardCaseResult beside_the_edge() {
    Node<Real> node;
    node.at.on_surface = false;
    const auto f = node.stick(1);
    return within(std::abs(f.restraint) + std::abs(f.normal_force), 0);
}

template <class Real>
HardCaseResult no_stiffness() {
    Node<Real> node;
    node.at.stiffness = 0;
    const auto f = node.stick(1);
    return within(is_finite(f) ? std::abs(f.restraint) + std::abs(f.slip) : HUGE_VAL, 0);
}

template <class Real>
HardCaseResult coincident_nodes() {
    Node<Real> node;
    node.in.half_chord = {};
    node.in.tributary = 0;
    const auto f = node.stick(1);
    return within(is_finite(f) ? norm(f.total) : HUGE_VAL, 0);
}

template <class Real>
HardCaseResult perpendicular_bead() {
    Node<Real> node;
    node.in.half_chord = {0, 0, 4};
    const auto f = node.stick(1);
    return within(is_finite(f) ? std::abs(f.restraint) + std::abs(f.normal_force - 400) : HUGE_VAL, 0);
}

template <class Real>
HardCaseResult huge_speed() {
    Node<Real> node;
    Largest over;
    for (const Real speed : {Real(1e6), Real(1e20), std::numeric_limits<Real>::max() / 4})
        over.add(std::abs(node.drag(speed).restraint) / 200 - 1);
    return within(over.value(), 0);
}

template <class Real>
HardCaseResult huge_stiffness() {
    Node<Real> node;
    node.at.stiffness = Real(1e30);
    Largest error;
    for (const Real way : {Real(1e-3), Real(1e-3), Real(-1e-3), Real(1e-3)}) {
        const auto f = node.stick(way);
        error.add(std::abs(f.restraint - std::copysign(Real(200), way)));
        error.add(is_finite(f) ? 0 : HUGE_VAL);
    }
    return within(error.value(), 0);
}

template <class Real>
HardCaseResult any_direction() {
    Largest error;
    for (int degrees = 0; degrees < 360; degrees += 5) {
        Node<Real> node;
        const Real angle = Real(degrees) * Real(3.14159265358979323846 / 180);
        node.in.displacement = {std::cos(angle), std::sin(angle), 0};
        const auto f = manual_node_force<Real, Effects{Restraint::incremental, false, true}>(
            node.law, node.at, node.in, node.q);
        error.add(std::abs(f.total.y));
        error.add(std::abs(f.total.z));
        const Real across = node.in.displacement.x;
        const double expected = std::min(42000 * std::abs(across), Real(200));
        error.add(std::abs(std::abs(f.total.x) - expected));
        error.add(std::max(f.total.x * across, Real(0))); // never along the motion
    }
    return within(error.value(), 0);
}

template <class Real>
HardCaseResult step_in_two() {
    Largest error;
    for (const Real way : {Real(1e-4), Real(0.003), Real(0.0047), Real(0.01), Real(100)}) {
        Node<Real> one, two;
        one.stick(way);
        two.stick(Real(0.3125) * way);
        two.stick(way - Real(0.3125) * way);
        error.add(std::abs(one.q - two.q));
    }
    return within(error.value(), 200 * 2 * eps<Real>);
}

/// Each number of the law over its whole range, the others as they are.
template <class Real>
HardCaseResult any_magnitude() {
    const int reach = sizeof(Real) == 8 ? 300 : 37;
    Largest error;
    for (int exponent = -reach; exponent <= reach; ++exponent) {
        const Real value = std::pow(Real(10), static_cast<Real>(exponent));
        for (int what = 0; what < 10; ++what) {
            Node<Real> node;
            const std::array<Real*, 9> number{&node.law.fn_first, &node.law.ft_first, &node.law.depth,
                                              &node.at.distance,  &node.at.stiffness, &node.at.half_thickness,
                                              &node.at.mass,      &node.law.fn_last,  &node.law.ft_last};
            if (what < 9) *number[static_cast<std::size_t>(what)] = value;
            // Lengths whose squares leave the range, the product of length and limit just not.
            if (what == 9) {
                const Real length = value / 1000;
                node.in.half_chord = {0, length, 0};
                node.in.tributary = length;
            }
            const auto stuck = node.stick(Real(1e-3));
            const Real limit = stuck.ft_limit * node.in.tributary;
            error.add(is_finite(stuck) && is_finite(node.drag(1)) ? 0 : HUGE_VAL);
            error.add(std::abs(stuck.restraint) > limit ? 1 : 0);
            // The restraint keeps its direction.
            error.add(stuck.restraint != 0 && std::abs(norm(stuck.across) - 1) > 4 * eps<Real> ? 1 : 0);
        }
    }
    return within(error.value(), 0);
}

} // namespace

std::vector<HardCaseRow> manual_kernel_cases() {
    constexpr Law law = Law::manual;
    return {
        {"rest-viscous", law, must_hold, "Iform 1 over a blank at rest.", "No restraint, Fn as it is.", "",
         rest_viscous<double>, rest_viscous<float>},
        {"rest-incremental", law, must_hold, "Ten steps in which nothing moves, with a force stored.",
         "The stored force stays.", "", rest_incremental<double>, rest_incremental<float>},
        {"reversal-each-step", law, must_hold, "The blank goes to and fro, 1 mm in each step.",
         "|restraint| ≤ Ft·L.", "force/manual_law.h: clamp(trial)", reversal_each_step<double>,
         reversal_each_step<float>},
        {"cyclic-slip", law, must_hold, "A slider of stiffness 1 and limit 0.4 over cycles of amplitude 1.",
         "The first cycle costs 0.88, each later one 4F(X − F/k) = 0.96.", "", cyclic_slip<double>,
         cyclic_slip<float>},
        {"sub-stick-cycle", law, must_hold, "50 cycles that stay below the limit.",
         "No work is lost, and the force returns to 0.", "", sub_stick_cycle<double>, sub_stick_cycle<float>},
        {"ramp-start", law, must_hold, "A node a rounding error above and below d = DEPTH + t/2.",
         "Fn is continuous there.", "", ramp_start<double>, ramp_start<float>},
        {"first-touch-without-Fn", law, must_hold, "First contact of a bead with Ft alone, slipping.",
         "The restraint begins at 0.", "", first_touch_without_normal_force<double>,
         first_touch_without_normal_force<float>},
        {"plateau-edge", law, must_hold, "A node at δ = DEPTH and ever deeper.", "Fn·L exactly, never more.",
         "force/manual_law.h: min(δ/DEPTH, 1) with Fn", plateau_edge<double>, plateau_edge<float>},
        {"restraint-past-depth", law, must_hold, "Ft alone, a node 20 mm behind the surface.",
         "|restraint| ≤ Ft·L.", "force/manual_law.h: min(δ/DEPTH, 1) without Fn",
         restraint_past_depth<double>, restraint_past_depth<float>},
        {"soft-blank", law, must_hold, "A blank softer than the ramp, pressed up to Fn and beyond.",
         "Fn = min(k δ, Fn·L).", "force/manual_law.h: min(k δ, P)", soft_blank<double>, soft_blank<float>},
        {"vanishing-depth", law, must_hold, "DEPTH from 1e-10 through the smallest denormal to 0.",
         "Finite, and the force of DEPTH = 0 in the limit.", "", vanishing_depth<double>,
         vanishing_depth<float>},
        {"negative-depth", law, must_hold, "DEPTH = −3.", "As DEPTH = 0.",
         "force/manual_law.h: max(DEPTH, 0)", negative_depth<double>, negative_depth<float>},
        {"negative-Ft", law, must_hold, "Ft = −50, constant.", "No restraint: no energy is created.",
         "force/manual_law.h: max(Ft, 0)", negative_restraint<double>, negative_restraint<float>},
        {"negative-Fn", law, must_hold, "Fn = −100, constant.", "No normal force.",
         "force/manual_law.h: max(Fn, 0)", negative_normal_force<double>, negative_normal_force<float>},
        {"limit-crosses-zero", law, must_hold, "Ft from −50 to 50 along the bead.",
         "Interpolated first, then 0 where negative.", "force/manual_law.h: max(limit, 0)",
         limit_crosses_zero<double>, limit_crosses_zero<float>},
        {"last-value-zero", law, must_hold, "Ft_last = 0 at the last node.", "Constant, no taper to 0.",
         "force/manual_law.h: last == 0", zero_last_is_constant<double>, zero_last_is_constant<float>},
        {"Fn-last-alone", law, must_hold, "Fn_first = 0 with Fn_last = 100.", "No normal force.",
         "force/manual_law.h: fn_first != 0", no_first_normal_force<double>, no_first_normal_force<float>},
        {"lift-off", law, must_hold, "A slipping node lifts off and comes back.",
         "The stored force is forgotten.", "force/manual_law.h: q = 0", lift_off<double>, lift_off<float>},
        {"beside-the-edge", law, must_hold, "A node in reach, but beside the free edge.", "No force.",
         "force/manual_law.h: on_surface", beside_the_edge<double>, beside_the_edge<float>},
        {"no-stiffness", law, must_hold, "A blank without stiffness (k = 0).", "Finite, no restraint.",
         "force/manual_law.h: k > 0", no_stiffness<double>, no_stiffness<float>},
        {"coincident-nodes", law, must_hold, "A node whose neighbours are where it is.", "No force, no NaN.",
         "", coincident_nodes<double>, coincident_nodes<float>},
        {"perpendicular-bead", law, must_hold, "The bead stands perpendicular to the blank.",
         "Fn as by its length, no restraint, no NaN.", "force/manual_law.h: size > 0",
         perpendicular_bead<double>, perpendicular_bead<float>},
        {"huge-speed", law, must_hold, "Iform 1 at 1e6 mm/s and up to the largest number.",
         "|restraint| ≤ Ft·L.", "force/manual_law.h: clamp(√(k m) v)", huge_speed<double>, huge_speed<float>},
        {"huge-stiffness", law, must_hold, "k = 1e30, to and fro.",
         "Rigid and plastic: the limit in each direction, no overshoot.", "", huge_stiffness<double>,
         huge_stiffness<float>},
        {"any-direction", law, must_hold, "The blank moves under the bead in 72 directions.",
         "Only motion across the bead is resisted, and never helped.", "", any_direction<double>,
         any_direction<float>},
        {"step-in-two", law, must_hold, "One step, and the same way in two.", "The same force.", "",
         step_in_two<double>, step_in_two<float>},
        {"any-magnitude", law, must_hold,
         "Each number of the law from 1e-300 to 1e300 (float: 1e-37 to 1e37), the others ordinary.",
         "Finite, within the limit, in the right direction.", "force/manual_law.h: unit_of",
         any_magnitude<double>, any_magnitude<float>},
    };
}

} // namespace drawbead
