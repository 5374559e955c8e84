// Hard cases of the solver's law: one bead node, or some side by side, as the kernel sees them.
#include "force/solver_law.h"
#include "force/solver_step.h"
#include "study/hard_case_table.h"

namespace drawbead {

namespace {

/// A node over a square of 4 mm (normal z), the line along y: T = ∓4 x. On the plateau.
template <class Real>
struct Node {
    BeadLaw<Real> law{100, 0, 50, 0, 5};
    SegmentState<Real> segment;
    NodeInput<Real> in;
    NodeState<Real> state;

    Node() {
        segment.x = {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}};
        segment.mass.fill(Real(2e-7));
        segment.stiffness = 42000;
        segment.half_thickness = Real(0.5);
        in.x = {2, 2, Real(0.25)};
        in.half_chord = {0, 4, 0};
        in.slope = 20;
        in.dt = Real(1e-6);
    }

    /// The blank's velocity is `speed` along x.
    template <Effects E>
    NodeForce<Real> run(Real speed) {
        segment.v.fill({speed, 0, 0});
        return solver_node_force<Real, E>(law, segment, in, state);
    }
    NodeForce<Real> stick(Real speed) { return run<Effects{Restraint::incremental, true, true}>(speed); }
    NodeForce<Real> drag(Real speed) { return run<Effects{Restraint::viscous, true, true}>(speed); }
};

template <class Real>
bool is_finite(const BasicVec3<Real>& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
template <class Real>
bool is_finite(const NodeForce<Real>& f, const NodeState<Real>& state) {
    return std::isfinite(f.restraint) && std::isfinite(f.normal_force) && std::isfinite(f.slip) &&
           is_finite(f.total) && is_finite(state.stored);
}
/// How far the weights are from a sum of 1; infinite when the projection is not finite.
template <class Real>
double weight_error(const Projection<Real>& at) {
    Real sum = 0;
    for (const Real h : at.weight)
        sum += h;
    const bool finite =
        std::isfinite(at.xi) && std::isfinite(at.eta) && std::isfinite(at.distance) && is_finite(at.normal);
    return finite ? std::abs(static_cast<double>(sum) - 1) : HUGE_VAL;
}

template <class Real>
HardCaseResult rest_viscous() {
    Node<Real> node;
    const auto f = node.drag(0);
    return within(std::abs(f.restraint) + std::abs(f.normal_force - 400), 0);
}

template <class Real>
HardCaseResult reversal_each_step() {
    Node<Real> node;
    Largest over;
    for (int i = 0; i < 200; ++i) {
        const auto f = node.stick(i % 2 == 0 ? Real(1e5) : Real(-1e5));
        over.add(std::abs(f.restraint) / 50 - 1);
        over.add(is_finite(f, node.state) ? 0 : HUGE_VAL);
    }
    return within(over.value(), 0);
}

template <class Real>
HardCaseResult huge_speed() {
    Largest over;
    for (const Real speed : {Real(1e6), Real(1e12), Real(-1e12), Real(1e18)}) {
        Node<Real> node;
        over.add(std::abs(node.drag(speed).restraint) / 50 - 1);
    }
    return within(over.value(), 0);
}

template <class Real>
HardCaseResult sub_stick_cycle() {
    Node<Real> node;
    node.segment.mass.fill(0); // no damper
    node.segment.stiffness = 32768;
    node.in.dt = Real(1) / 1048576;
    double work = 0, before = 0;
    for (int i = 0; i < 200; ++i) {
        const Real speed = i % 4 == 0 || i % 4 == 3 ? Real(256) : Real(-256);
        const double now = node.stick(speed).tangential.x;
        work += 0.5 * (before + now) * speed * node.in.dt;
        before = now;
    }
    return within(std::abs(work) + norm(node.state.stored), 0); // powers of two: nothing is rounded
}

template <class Real>
HardCaseResult ramp_start() {
    Node<Real> node;
    const Real step = 8 * eps<Real>;
    node.in.x.z = Real(5.5) - step;
    const double inside = node.stick(0).normal_force;
    node.in.x.z = Real(5.5) + step;
    return within(std::abs(inside - static_cast<double>(node.stick(0).normal_force)), 80 * 2 * step);
}

template <class Real>
HardCaseResult first_touch_without_normal_force() {
    Node<Real> node;
    node.law.fn_first = 0;
    node.in.x.z = Real(5.5) - 8 * eps<Real>;
    const auto f = node.template run<Effects{Restraint::incremental, false, true}>(Real(1e6));
    return broken_by(norm(f.tangential), 200, 8 * eps<Real>);
}

template <class Real>
HardCaseResult pressed_past_depth() {
    Node<Real> node;
    Largest error;
    for (const Real z : {Real(0.5), Real(0.25), Real(-10)}) {
        node.in.x.z = z;
        error.add(std::abs(node.stick(0).normal_force - 400));
    }
    return within(error.value(), 0);
}

template <class Real>
HardCaseResult restraint_past_depth() {
    Node<Real> node;
    Largest error;
    for (const Real z : {Real(0.5), Real(0.25), Real(-10)}) {
        node.in.x.z = z;
        error.add(norm(node.stick(Real(1e6)).tangential) - 200);
    }
    return within(error.value(), 200 * 4 * eps<Real>);
}

/// Just short of δ = DEPTH, less the value at it.
template <class Real>
double jump_at_depth(Node<Real> node) {
    node.in.x.z = Real(0.5) + 4 * eps<Real>;
    const double ramp = node.stick(0).normal_force;
    node.in.x.z = Real(0.5);
    return ramp - static_cast<double>(node.stick(0).normal_force);
}

template <class Real>
HardCaseResult linear_normal_force() {
    Node<Real> node;
    node.law.fn_last = 40;
    node.in.s_fraction = 1;
    return broken_by(jump_at_depth(node), 20 * 5 * 4 - 40 * 4, 64 * eps<Real>);
}

template <class Real>
HardCaseResult reset_slope() {
    Node<Real> node;
    node.law.fn_first = Real(1e6);
    node.in.slope = 42000;
    return broken_by(jump_at_depth(node), 42000.0 * 5 * 4 - 4e6, 64 * eps<Real>);
}

template <class Real>
HardCaseResult restraint_after_reset() {
    Node<Real> node;
    node.in.slope = 42000; // as k: the share of the ramp is not taken
    node.in.x.z = Real(5.5) - 8 * eps<Real>;
    return broken_by(norm(node.stick(Real(1e6)).tangential), 200, 8 * eps<Real>);
}

template <class Real>
HardCaseResult absent_depth() {
    Node<Real> node;
    node.law.depth = 0;
    node.in.x.z = 1000;
    return broken_by(node.stick(0).normal_force, 400, 0);
}

template <class Real>
HardCaseResult depth_gate() {
    Node<Real> node;
    Largest error;
    for (const Real z : {Real(5.5), Real(6), Real(1000)}) {
        node.in.x.z = z;
        error.add(norm(node.stick(1000).total));
    }
    return within(error.value(), 0);
}

template <class Real>
HardCaseResult denormal_depth() {
    Largest error;
    for (const Real depth : {Real(1e-30), std::numeric_limits<Real>::min(),
                             std::numeric_limits<Real>::denorm_min(), Real(0), Real(-5)})
        for (const Real z : {Real(6), Real(0.5), Real(0)}) {
            Node<Real> node;
            node.law.depth = depth;
            node.in.x.z = z;
            const auto f = node.stick(1000);
            error.add(is_finite(f, node.state) ? 0 : HUGE_VAL);
        }
    return within(error.value(), 0);
}

template <class Real>
HardCaseResult negative_limit_viscous() {
    Node<Real> node;
    node.law.ft_first = -50;
    return broken_by(node.drag(1000).tangential.x * 1000, 50 * 4 * 1000, 4 * eps<Real>);
}

template <class Real>
HardCaseResult negative_limit_incremental() {
    Node<Real> node;
    node.law.ft_first = -50;
    return broken_by(std::abs(node.stick(Real(1e6)).restraint), 50, 0);
}

template <class Real>
HardCaseResult zero_last_is_constant() {
    Node<Real> node;
    node.in.s_fraction = 1;
    const auto f = node.stick(Real(1e6));
    return within(std::abs(f.restraint - 50) + std::abs(f.normal_force - 400), 0);
}

template <class Real>
HardCaseResult no_stiffness() {
    Node<Real> node;
    node.segment.stiffness = 0;
    node.segment.mass.fill(0);
    const auto f = node.stick(1000);
    return within(is_finite(f, node.state) ? std::abs(f.restraint) : HUGE_VAL, 0);
}

template <class Real>
HardCaseResult no_step() {
    Node<Real> node;
    node.in.dt = 0;
    node.state.stored = {400, 0, 0}; // twice the limit
    node.stick(0);
    return within(std::abs(node.state.stored.x - 200), 200 * 4 * eps<Real>);
}

template <class Real>
HardCaseResult no_tributary() {
    Node<Real> node;
    node.in.half_chord = {};
    const auto f = node.stick(1000);
    return within(is_finite(f, node.state) ? norm(f.tangential) : HUGE_VAL, 0);
}

template <class Real>
HardCaseResult least_length() {
    Node<Real> node;
    node.in.half_chord = {};
    return broken_by(node.stick(0).normal_force, 100 * 1e-10, 4 * eps<Real>);
}

template <class Real>
HardCaseResult huge_length() {
    int first = 0;
    for (int exponent = 1; first == 0 && exponent < 310; ++exponent) {
        Node<Real> node;
        node.in.half_chord = {0, std::pow(Real(10), static_cast<Real>(exponent)), 0};
        if (!std::isfinite(node.stick(0).normal_force)) first = exponent;
    }
    return broken_by(first, sizeof(Real) == 8 ? 155 : 20, 0); // half of the range's exponent
}

template <class Real>
HardCaseResult any_direction() {
    Largest error;
    for (int degrees = 0; degrees < 360; degrees += 5) {
        const double angle = degrees * 3.14159265358979323846 / 180;
        const Vec3 v{1e5 * std::cos(angle), 1e5 * std::sin(angle), 0};
        for (const bool viscous : {true, false}) {
            Node<Real> node;
            node.segment.v.fill({static_cast<Real>(v.x), static_cast<Real>(v.y), 0});
            const auto f = viscous ? solver_node_force<Real, Effects{Restraint::viscous, false, true}>(
                                         node.law, node.segment, node.in, node.state)
                                   : solver_node_force<Real, Effects{Restraint::incremental, false, true}>(
                                         node.law, node.segment, node.in, node.state);
            error.add(std::abs(f.tangential.y));
            error.add(std::abs(f.tangential.z));
            error.add(std::max(static_cast<double>(f.tangential.x) * v.x, 0.0));
            error.add(std::abs(f.restraint) - 50);
            error.add(std::max(-static_cast<double>(f.speed), 0.0));
        }
    }
    return within(error.value(), 0);
}

template <class Real>
HardCaseResult point_segment() {
    const BasicVec3<Real> corner{1, 2, 3};
    return within(weight_error(project<Real>({corner, corner, corner, corner}, {2, 2, 3})), 4 * eps<Real>);
}

template <class Real>
HardCaseResult line_segment() {
    return within(weight_error(project<Real>({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}}, {1, 1, 1})),
                  4 * eps<Real>);
}

template <class Real>
HardCaseResult triangle_place() {
    // The weights of a linear field give the foot itself.
    const std::array<BasicVec3<Real>, 4> corner{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 4, 0}}};
    Largest error;
    for (const auto& [x, y] : {std::pair{1.0, 1.0}, std::pair{0.5, 2.0}, std::pair{3.0, 0.5}}) {
        const auto at = project<Real>(corner, {static_cast<Real>(x), static_cast<Real>(y), 2});
        BasicVec3<Real> foot;
        for (std::size_t k = 0; k < 4; ++k)
            foot += at.weight[k] * corner[k];
        error.add(std::hypot(static_cast<double>(foot.x) - x, static_cast<double>(foot.y) - y));
        error.add(weight_error(at));
    }
    return within(error.value(), 32 * eps<Real>);
}

/// Just beside the segment, within the margin: on its edge.
template <class Real>
HardCaseResult beside(BasicVec3<Real> bead) {
    const auto at = project<Real>({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}}, bead);
    Largest error;
    error.add(at.inside ? 0 : 1);
    for (const Real h : at.weight)
        error.add(-h);
    error.add(std::max(std::abs(at.xi), std::abs(at.eta)) - 1);
    return within(error.value(), 0);
}
template <class Real>
HardCaseResult beside_across() {
    return beside<Real>({Real(4.08), 2, 1});
}
template <class Real>
HardCaseResult beside_along() {
    return beside<Real>({2, Real(4.08), 1});
}

template <class Real>
HardCaseResult margin_jump() {
    Node<Real> node;
    node.in.x.x = Real(4.0999);
    const double before = node.stick(0).normal_force;
    node.in.x.x = Real(4.1001);
    return broken_by(before - static_cast<double>(node.stick(0).normal_force), 400, 0);
}

template <class Real>
HardCaseResult any_quad() {
    const auto quad = [](double x2, double y2, double x3, double y3, double z3, double x4, double y4) {
        const auto at = [](double x, double y, double z) {
            return BasicVec3<Real>{static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)};
        };
        return std::array<BasicVec3<Real>, 4>{at(0, 0, 0), at(x2, y2, 0), at(x3, y3, z3), at(x4, y4, 0)};
    };
    Largest error;
    for (const auto& corner :
         {quad(4, 0, 4, 4, 0, 0, 4), quad(4, 0, 4, 4, 3, 0, 4), quad(1e6, 0, 1e6, 1, 0, 0, 1),
          quad(4, 0, 1, 1, 0, 0, 4), quad(4, 0, 0, 4, 0, 4, 4), quad(4, 0, 4, 1e-6, 0, 0, 4)})
        for (const Real x : {Real(-0.1), Real(0), Real(0.5), Real(1), Real(4)})
            for (const Real y : {Real(-0.1), Real(0), Real(0.5), Real(1), Real(4)}) {
                const auto at = project<Real>(corner, {x, y, 1});
                if (at.inside) error.add(weight_error(at));
            }
    return within(error.value(), 8 * eps<Real>);
}

/// Nodes side by side get the bits that each gets alone, degenerate ones and lifted ones among them.
template <class Real>
double side_by_side(bool lifted_alone) {
    std::vector<Node<Real>> nodes(7);
    if (!lifted_alone) {
        const BasicVec3<Real> corner{1, 1, 0};
        nodes[1].segment.x = {corner, corner, corner, corner};
        nodes[2].in.half_chord = {};
        nodes[3].segment.x[3] = nodes[3].segment.x[2];
        nodes[4].segment.stiffness = 0;
        nodes[4].segment.mass.fill(0);
        nodes[6].in.dt = 0;
    }
    for (std::size_t i = 0; i < 7; i += 2)
        nodes[i].in.x.z = 30;
    std::vector<SegmentState<Real>> segment;
    std::vector<NodeInput<Real>> input;
    std::vector<NodeState<Real>> state;
    for (Node<Real>& node : nodes) {
        node.segment.v.fill({1000, 0, 0});
        node.state.stored = {10, 0, 0};
        segment.push_back(node.segment);
        input.push_back(node.in);
        state.push_back(node.state);
    }
    Largest error;
    constexpr Effects effects{Restraint::incremental, true, true};
    const auto differ = [](Real a, Real b) { return a == b || (std::isnan(a) && std::isnan(b)) ? 0.0 : 1.0; };
    solver_step<Real, effects>(
        nodes[0].law, std::span<const SegmentState<Real>>(segment), std::span<const NodeInput<Real>>(input),
        std::span(state), [&](std::size_t first, std::size_t count, const NodeForce<Lanes<Real>>& wide) {
            for (std::size_t lane = 0; lane < count; ++lane) {
                Node<Real>& node = nodes[first + lane];
                const auto f = solver_node_force<Real, effects>(node.law, node.segment, node.in, node.state);
                error.add(differ(wide.total.x[lane], f.total.x));
                error.add(differ(wide.total.z[lane], f.total.z));
                error.add(differ(wide.restraint[lane], f.restraint));
                error.add(differ(state[first + lane].stored.x, node.state.stored.x));
            }
        });
    return error.value();
}
template <class Real>
HardCaseResult degenerate_lanes() {
    return within(side_by_side<Real>(false), 0);
}
template <class Real>
HardCaseResult lifted_lanes() {
    return within(side_by_side<Real>(true), 0);
}

template <class Real>
HardCaseResult stale_stick() {
    Node<Real> node;
    node.segment.mass.fill(0); // no damper
    node.stick(Real(1e6));
    node.in.x.z = 30;
    node.stick(0);
    node.in.x.z = Real(0.25);
    return broken_by(std::abs(node.stick(0).restraint), 50, 8 * eps<Real>);
}

template <class Real>
HardCaseResult far_away(double offset) {
    Node<Real> here, there;
    const BasicVec3<Real> far{static_cast<Real>(offset), static_cast<Real>(offset), 0};
    for (auto& corner : there.segment.x)
        corner += far;
    there.in.x += far;
    here.in.x.z = there.in.x.z = Real(2.5);
    const double expected = here.stick(0).normal_force;
    // Weights are ratios of areas, products of differences from the origin's rounding: eps · offset / size.
    return within(std::abs(static_cast<double>(there.stick(0).normal_force) - expected) / expected,
                  16 * eps<Real> * offset / 4);
}
template <class Real>
HardCaseResult translated() {
    return far_away<Real>(sizeof(Real) == 8 ? 1e9 : 1e4);
}

template <class Real>
HardCaseResult split_step() {
    Node<Real> one, two;
    one.segment.mass.fill(0);
    two.segment.mass.fill(0);
    one.in.dt = Real(2e-6);
    one.stick(1000);
    two.stick(1000);
    two.stick(1000);
    return within(norm(one.state.stored - two.state.stored), 200 * 4 * eps<Real>);
}

template <class Real>
HardCaseResult huge_stiffness() {
    Node<Real> node;
    node.segment.stiffness = Real(1e20);
    Largest error;
    for (const Real speed : {Real(1e3), Real(1e3), Real(-1e3), Real(1e3)}) {
        const auto f = node.stick(speed);
        error.add(std::abs(std::abs(f.restraint) - 50));
        error.add(std::max(f.tangential.x * speed, Real(0)));
        error.add(is_finite(f, node.state) ? 0 : HUGE_VAL);
    }
    return within(error.value(), 0);
}

} // namespace

std::vector<HardCaseRow> solver_kernel_cases() {
    constexpr Law law = Law::solver;
    return {
        {"rest-viscous", law, must_hold, "Iform 1 over a blank at rest.", "No restraint, Fn as it is.", "",
         rest_viscous<double>, rest_viscous<float>},
        {"reversal-each-step", law, must_hold, "The blank goes to and fro at 1e5 mm/s.",
         "|restraint| ≤ Ft·L, the stored force stays finite.", "", reversal_each_step<double>,
         reversal_each_step<float>},
        {"huge-speed", law, must_hold, "Iform 1 at 1e6 to 1e18 mm/s.", "|restraint| ≤ Ft·L.",
         "force/solver_law.h: min(…, Ft)", huge_speed<double>, huge_speed<float>},
        {"sub-stick-cycle", law, must_hold, "50 cycles below the limit, massless: no damper.",
         "No work is lost, and the stored force returns to 0.", "", sub_stick_cycle<double>,
         sub_stick_cycle<float>},
        {"ramp-start", law, must_hold, "A node a rounding error above and below d = DEPTH + t/2.",
         "Fn is continuous there.", "", ramp_start<double>, ramp_start<float>},
        {"first-touch-without-Fn", law, is_broken, "First contact of a bead with Ft alone, slipping.",
         "The restraint begins at 0.", "", first_touch_without_normal_force<double>,
         first_touch_without_normal_force<float>},
        {"pressed-past-depth", law, must_hold, "A node at δ = DEPTH and deeper.", "Fn·L, never more.",
         "force/solver_law.h: plateau of Fn", pressed_past_depth<double>, pressed_past_depth<float>},
        {"restraint-past-depth", law, must_hold, "The same, slipping.", "|restraint| ≤ Ft·L.",
         "force/solver_law.h: plateau of the share", restraint_past_depth<double>,
         restraint_past_depth<float>},
        {"linear-Fn", law, is_broken, "Fn from 100 to 40 along the bead, at its last node.",
         "Fn is continuous at δ = DEPTH.", "", linear_normal_force<double>, linear_normal_force<float>},
        {"reset-slope", law, is_broken, "Fn/DEPTH above k: the slope is reset to k.",
         "Fn is continuous at δ = DEPTH.", "", reset_slope<double>, reset_slope<float>},
        {"restraint-after-reset", law, is_broken, "First contact after a reset, slipping.",
         "The restraint grows with Fn.", "", restraint_after_reset<double>, restraint_after_reset<float>},
        {"absent-depth", law, is_broken, "DEPTH = 0, a node 1 m above the blank.", "No force out of reach.",
         "", absent_depth<double>, absent_depth<float>},
        {"out-of-reach", law, must_hold, "Nodes at d = DEPTH + t/2 and above.", "No force.",
         "force/solver_law.h: δ > 0", depth_gate<double>, depth_gate<float>},
        {"vanishing-depth", law, must_hold, "DEPTH from 1e-30 through denormals to 0 and −5.", "Finite.", "",
         denormal_depth<double>, denormal_depth<float>},
        {"negative-Ft-viscous", law, is_broken, "Ft = −50, Iform 1, the blank at 1 m/s.",
         "No power goes into the blank.", "", negative_limit_viscous<double>, negative_limit_viscous<float>},
        {"negative-Ft-incremental", law, is_broken, "Ft = −50, Iform 2, slipping.", "No restraint.", "",
         negative_limit_incremental<double>, negative_limit_incremental<float>},
        {"last-value-zero", law, must_hold, "Fn_last = Ft_last = 0 at the last node.",
         "Constant, no taper to 0.", "force/solver_law.h: last == 0", zero_last_is_constant<double>,
         zero_last_is_constant<float>},
        {"no-stiffness", law, must_hold, "A blank without stiffness and mass.", "Finite, no restraint.",
         "force/solver_law.h: max(1e-20, k + C/Δt)", no_stiffness<double>, no_stiffness<float>},
        {"no-step", law, must_hold, "Δt = 0 with a stored force of twice the limit.",
         "No division by Δt: it is cut to the limit.", "force/solver_law.h: Δt == 0", no_step<double>,
         no_step<float>},
        {"coincident-nodes", law, must_hold, "A node whose neighbours are where it is.",
         "No restraint, no NaN.", "force/solver_law.h: max(T·T, 1e-20)", no_tributary<double>,
         no_tributary<float>},
        {"least-length", law, is_broken, "The same: L² ≥ 1e-20 in the deck's unit.",
         "No normal force without length.", "", least_length<double>, least_length<float>},
        {"huge-length", law, is_broken, "Tributary lengths of 10^1, 10^2 …",
         "Finite as long as Fn·L is; the exponent of the first that is not.", "", huge_length<double>,
         huge_length<float>},
        {"any-direction", law, must_hold, "The blank moves under the bead in 72 directions, both Iform.",
         "Only motion across the bead is resisted, and never helped.", "force/solver_law.h: T turned",
         any_direction<double>, any_direction<float>},
        {"point-segment", law, must_hold, "A segment whose corners are one point.",
         "Weights are finite and sum to 1.", "force/solver_law.h: max(1e-30, |n|)", point_segment<double>,
         point_segment<float>},
        {"line-segment", law, must_hold, "A segment whose corners are on one line.",
         "Weights are finite and sum to 1.", "force/solver_law.h: zero denominator", line_segment<double>,
         line_segment<float>},
        {"triangle", law, must_hold, "A triangle, as a quad that repeats its third node.",
         "A linear field is reproduced.", "force/solver_law.h: a₃ = 0", triangle_place<double>,
         triangle_place<float>},
        {"beside-across", law, must_hold, "A node 2 % of a segment beside its second edge.",
         "In contact, on the edge: no weight is negative.", "force/solver_law.h: ξ in [−1, 1]",
         beside_across<double>, beside_across<float>},
        {"beside-along", law, must_hold, "A node 2 % of a segment beside its third edge.",
         "In contact, on the edge: no weight is negative.", "force/solver_law.h: η in [−1, 1]",
         beside_along<double>, beside_along<float>},
        {"margin", law, is_broken, "A node leaves the segment at 5 % beside it.", "Fn is continuous.", "",
         margin_jump<double>, margin_jump<float>},
        {"any-quad", law, must_hold, "Square, warped, needle, concave, crossed and collapsed quads.",
         "Weights of nodes in contact are finite and sum to 1.", "", any_quad<double>, any_quad<float>},
        {"side-by-side", law, must_hold, "Sound nodes computed together with degenerate ones.",
         "The bits of each alone.", "", degenerate_lanes<double>, degenerate_lanes<float>},
        {"lifted-beside-contact", law, must_hold, "Lifted nodes computed together with nodes in contact.",
         "Their stored force stays.", "force/solver_law.h: stored only where δ > 0", lifted_lanes<double>,
         lifted_lanes<float>},
        {"stale-stick", law, is_broken, "A slipping node lifts off and comes back.",
         "The stored force is forgotten.", "", stale_stick<double>, stale_stick<float>},
        {"translated", law, must_hold, "The node 1e9 (float: 1e4) away from the origin.",
         "The same Fn to 4 ulp of that place over the segment's size.", "", translated<double>,
         translated<float>},
        {"step-in-two", law, must_hold, "One step, and the same way in two, massless.", "The same force.", "",
         split_step<double>, split_step<float>},
        {"huge-stiffness", law, must_hold, "k = 1e20, to and fro.",
         "Rigid and plastic: the limit against each direction.", "", huge_stiffness<double>,
         huge_stiffness<float>},
    };
}

} // namespace drawbead
