// The solver's law apart from any record: what a kernel leaves out changes no bit of the rest, single
// precision follows double, and the rules that recorded runs seldom meet.
#include "force/manual_law.h"
#include "force/solver_block.h"
#include "force/solver_kernels.h"
#include "force/solver_step.h"

#include <catch2/catch.hpp>
#include <random>

using namespace drawbead;

namespace {

template <class To, class From>
BasicVec3<To> vec(const BasicVec3<From>& v) {
    return {static_cast<To>(v.x), static_cast<To>(v.y), static_cast<To>(v.z)};
}

/// A node over a warped segment of 5 mm, with a velocity and a state of its own.
struct Case {
    SegmentState<double> segment;
    NodeInput<double> node;
    NodeState<double> state;

    explicit Case(unsigned seed) {
        std::mt19937 random(seed);
        const auto within = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        const std::array<Vec3, 4> square{{{20, 5, 0}, {25, 5, 0}, {25, 10, 0}, {20, 10, 0}}};
        for (std::size_t k = 0; k < 4; ++k) {
            segment.x[k] = square[k] + Vec3{within(-1, 1), within(-1, 1), within(-0.3, 0.3)};
            segment.v[k] = {within(-2000, 2000), within(-100, 100), within(-100, 100)};
            segment.mass[k] = within(1e-7, 3e-7);
        }
        segment.stiffness = 42000;
        segment.half_thickness = 0.5;
        node.x = {within(19, 26), within(4, 11), within(-1, 7)};
        node.half_chord = {within(-1, 1), within(2, 5), within(-0.2, 0.2)};
        node.s_fraction = within(0, 1);
        node.slope = 20;
        node.dt = seed % 7 == 0 ? 0 : 8.7e-7;
        state.stored = {within(-200, 200), within(-20, 20), 0};
    }
};

bool same(const NodeForce<double>& a, const NodeForce<double>& b) {
    return a.at.xi == b.at.xi && a.at.eta == b.at.eta && a.penetration == b.penetration &&
           a.across == b.across && a.restraint == b.restraint && a.normal_force == b.normal_force &&
           a.normal == b.normal && a.tangential == b.tangential && a.total == b.total && a.slip == b.slip;
}

constexpr std::array<Restraint, 3> restraints{Restraint::none, Restraint::viscous, Restraint::incremental};

} // namespace

TEST_CASE("a kernel without an effect gives the bits of the full one in which the effect is zero") {
    unsigned on = 0;
    for (unsigned seed = 0; seed < 300; ++seed)
        for (const Restraint restraint : {Restraint::viscous, Restraint::incremental}) {
            const Case c(seed);
            const auto force = [&](const BeadLaw<double>& law, Effects effects) {
                NodeState<double> state = c.state;
                return solver_kernel(effects)(law, c.segment, c.node, state);
            };
            const BeadLaw<double> constant{100, 0, 50, 0, 5};
            CHECK(same(force(constant, {restraint, true, false}), force(constant, {restraint, true, true})));
            // Without a normal force the full kernel would still scale the restraint on the ramp.
            const NodeForce<double> both = force({100, 300, 50, 10, 5}, {restraint, true, true});
            const NodeForce<double> alone = force({0, 0, 50, 10, 5}, {restraint, false, true});
            CHECK(alone.normal_force == 0);
            CHECK(alone.restraint == both.restraint);
            CHECK(alone.ramp_share == 1);
            CHECK(both.tangential == (-(both.restraint * both.across)) * both.ramp_share);
            const NodeForce<double> normal = force({100, 300, 50, 10, 5}, {Restraint::none, true, true});
            CHECK(normal.normal_force == both.normal_force);
            CHECK(normal.total == both.normal);
            on += both.penetration > 0;
        }
    CHECK(on > 100);
}

namespace {

/// A bead's step, nodes side by side, against node by node: number of nodes in contact.
template <class Real, Effects E>
unsigned compare_step(std::size_t nodes, const BeadLaw<Real>& law) {
    std::vector<SegmentState<Real>> segment(nodes);
    std::vector<NodeInput<Real>> input(nodes);
    std::vector<NodeState<Real>> state(nodes);
    for (unsigned i = 0; i < nodes; ++i) {
        const Case c(i);
        for (std::size_t k = 0; k < 4; ++k) {
            segment[i].x[k] =
                vec<Real>(c.segment.x[i % 5 == 0 ? std::min<std::size_t>(k, 2) : k]); // some triangles
            segment[i].v[k] = vec<Real>(c.segment.v[k]);
            segment[i].mass[k] = static_cast<Real>(c.segment.mass[k]);
        }
        segment[i].stiffness = 42000;
        segment[i].half_thickness = Real(0.5);
        input[i] = {vec<Real>(c.node.x), vec<Real>(c.node.half_chord), static_cast<Real>(c.node.s_fraction),
                    20, static_cast<Real>(c.node.dt)};
        state[i].stored = vec<Real>(c.state.stored);
    }
    std::vector<NodeState<Real>> alone = state;
    unsigned in_contact = 0;
    std::size_t visited = 0;
    solver_step<Real, E>(
        law, std::span<const SegmentState<Real>>(segment), std::span<const NodeInput<Real>>(input),
        std::span(state), [&](std::size_t first, std::size_t count, const NodeForce<Lanes<Real>>& wide) {
            CHECK(first == visited);
            visited += count;
            for (std::size_t lane = 0; lane < count; ++lane) {
                const std::size_t i = first + lane;
                const NodeForce<Real> f = solver_node_force<Real, E>(law, segment[i], input[i], alone[i]);
                const auto equal = [&](const BasicVec3<Lanes<Real>>& a, const BasicVec3<Real>& b) {
                    return a.x[lane] == b.x && a.y[lane] == b.y && a.z[lane] == b.z;
                };
                CHECK((wide.at.inside[lane] != 0) == f.at.inside);
                for (std::size_t k = 0; k < 4; ++k)
                    CHECK(wide.at.weight[k][lane] == f.at.weight[k]);
                CHECK(wide.penetration[lane] == f.penetration);
                CHECK(equal(wide.across, f.across));
                CHECK(wide.length_squared[lane] == f.length_squared);
                CHECK(wide.speed[lane] == f.speed);
                CHECK(wide.restraint[lane] == f.restraint);
                CHECK(wide.ramp_share[lane] == f.ramp_share);
                CHECK(wide.normal_force[lane] == f.normal_force);
                CHECK(wide.slip[lane] == f.slip);
                CHECK(equal(wide.total, f.total));
                CHECK(state[i].stored == alone[i].stored);
                in_contact += f.penetration > 0;
            }
        });
    CHECK(visited == nodes);
    return in_contact;
}

/// N nodes at a time against the same nodes alone, over two cycles; how many were in contact.
template <std::size_t N, Effects E>
unsigned compare_block(const BeadLaw<double>& law) {
    unsigned in_contact = 0;
    for (unsigned group = 0; group < 60; ++group) {
        SolverLanes<N> lanes;
        SolverBlock<N> block;
        block.books = block.stores = true;
        std::vector<Case> cases;
        std::vector<Vec3> normal(N), restraint(N), tool(N);
        std::vector<double> stored(N);
        for (unsigned lane = 0; lane < N; ++lane) {
            Case& c = cases.emplace_back(group * N + lane);
            c.segment.stiffness = 42000;
            c.segment.half_thickness = 0.5;
            if (lane % 3 == 0) c.segment.x[3] = c.segment.x[2];
            c.node.slope = 20;
            tool[lane] = {0.1 * lane, -1.0 * group, 3};
            for (std::size_t k = 0; k < 4; ++k) {
                block.segment_x[k].set(lane, c.segment.x[k]);
                block.segment_v[k].set(lane, c.segment.v[k]);
                lanes.mass[k][lane] = c.segment.mass[k];
            }
            lanes.stiffness[lane] = c.segment.stiffness;
            lanes.half_thickness[lane] = c.segment.half_thickness;
            lanes.slope[lane] = c.node.slope;
            lanes.stick.set(lane, c.state.stored);
            block.x.set(lane, c.node.x);
            block.half_chord.set(lane, c.node.half_chord);
            block.s_fraction[lane] = c.node.s_fraction;
            block.tool_velocity.set(lane, tool[lane]);
        }
        for (int cycle = 0; cycle < 2; ++cycle) {
            block.dt = cycle == 0 ? 0 : 1e-6;
            solver_block_kernel<N>(E)(law, lanes, block);
            for (unsigned lane = 0; lane < N; ++lane) {
                Case& c = cases[lane];
                c.node.dt = block.dt;
                const NodeForce<double> f = solver_node_force<double, E>(law, c.segment, c.node, c.state);
                CHECK((block.inside[lane] != 0) == f.at.inside);
                CHECK(block.xi[lane] == f.at.xi);
                CHECK(block.eta[lane] == f.at.eta);
                CHECK(block.distance[lane] == f.at.distance);
                CHECK(block.penetration[lane] == f.penetration);
                CHECK(block.slip[lane] == f.slip);
                CHECK(block.normal_size[lane] == f.normal_force);
                CHECK(block.restraint_size[lane] == norm(f.tangential));
                CHECK(lanes.normal[lane] == f.normal);
                CHECK(lanes.restraint[lane] == f.tangential);
                CHECK(lanes.stick[lane] == c.state.stored);
                Vec3 foot, v;
                for (std::size_t k = 0; k < 4; ++k) {
                    foot = k == 0 ? f.at.weight[0] * c.segment.x[0] : foot + f.at.weight[k] * c.segment.x[k];
                    v += f.at.weight[k] * c.segment.v[k];
                }
                CHECK(block.couple[lane] == cross(foot - c.node.x, f.total));
                const double half = 0.5 * block.dt;
                CHECK(block.normal_work[lane] == half * dot(normal[lane] + f.normal, v));
                CHECK(block.restraint_work[lane] == half * dot(restraint[lane] + f.tangential, v));
                CHECK(block.tool_work[lane] ==
                      half * dot(normal[lane] + restraint[lane] + f.total, tool[lane]));
                const double holds =
                    f.ft_limit != 0 ? squared_norm(c.state.stored) / (2 * c.segment.stiffness) : 0;
                CHECK(block.stored_change[lane] == holds - stored[lane]);
                normal[lane] = f.normal, restraint[lane] = f.tangential, stored[lane] = holds;
                in_contact += f.penetration > 0;
            }
        }
    }
    return in_contact;
}

template <std::size_t N>
void compare_blocks() {
    CHECK(compare_block<N, Effects{Restraint::incremental, true, true}>({100, 300, 50, 10, 5}) > 40);
    CHECK(compare_block<N, Effects{Restraint::viscous, true, true}>({100, 300, 50, 10, 5}) > 40);
    CHECK(compare_block<N, Effects{Restraint::incremental, false, false, false, false}>({0, 0, 50, 0, 5}) >
          40);
    CHECK(compare_block<N, Effects{Restraint::none, true, false, true, false}>({100, 0, 0, 0, 5}) > 40);
}

} // namespace

TEST_CASE("the rows of a run get the bits that nodes get alone, two at a time and four") {
    compare_blocks<2>();
    if (runs_four_lanes()) compare_blocks<4>();
}

TEST_CASE("nodes side by side get the bits that they get alone") {
    for (const std::size_t nodes : {1U, 2U, 3U, 301U}) {
        const unsigned least = nodes > 100 ? 100 : 0;
        CHECK(compare_step<double, Effects{Restraint::incremental, true, true}>(
                  nodes, {100, 300, 50, 10, 5}) >= least);
        CHECK(compare_step<double, Effects{Restraint::viscous, true, true}>(nodes, {100, 300, 50, 10, 5}) >=
              least);
        CHECK(compare_step<double, Effects{Restraint::incremental, false, false}>(nodes, {0, 0, 50, 0, 0}) >=
              least);
        CHECK(compare_step<double, Effects{Restraint::none, true, false}>(nodes, {100, 0, 0, 0, 5}) >= least);
        CHECK(compare_step<float, Effects{Restraint::incremental, true, true}>(
                  nodes, {100, 300, 50, 10, 5}) >= least);
        CHECK(compare_step<float, Effects{Restraint::viscous, true, false}>(nodes, {100, 0, -50, 0, 5}) >=
              least);
    }
}

TEST_CASE("the kernel of an interface is the one that its card asks for") {
    for (const int iform : {1, 2, 3})
        for (const double fn : {0.0, 100.0})
            for (const double last : {0.0, 10.0}) {
                const Effects effects = effects_of(BeadLaw<double>{fn, last, 50, 0, 5}, iform);
                CHECK(effects == Effects{iform == 1   ? Restraint::viscous
                                         : iform == 2 ? Restraint::incremental
                                                      : Restraint::none,
                                         fn != 0, last != 0});
            }
    std::vector<SolverKernel> kernels;
    for (const Restraint restraint : restraints)
        for (const bool normal : {false, true})
            for (const bool varies : {false, true})
                kernels.push_back(solver_kernel({restraint, normal, varies}));
    for (const SolverKernel kernel : kernels)
        CHECK(kernel != nullptr);
}

TEST_CASE("without any force nothing is computed and nothing is remembered") {
    const Case c(1);
    NodeState<double> state = c.state;
    const NodeForce<double> f =
        solver_kernel({Restraint::none, false, false})({0, 0, 0, 0, 5}, c.segment, c.node, state);
    CHECK(f.total == Vec3{});
    CHECK(f.at.weight == std::array<double, 4>{});
    CHECK(state.stored == c.state.stored);
}

TEST_CASE("single precision follows double precision") {
    const BeadLaw<double> law{100, 300, 50, 10, 5};
    const BeadLaw<float> small_law{100, 300, 50, 10, 5};
    unsigned compared = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
        const Case c(seed);
        SegmentState<float> segment;
        for (std::size_t k = 0; k < 4; ++k) {
            segment.x[k] = vec<float>(c.segment.x[k]);
            segment.v[k] = vec<float>(c.segment.v[k]);
            segment.mass[k] = static_cast<float>(c.segment.mass[k]);
        }
        segment.stiffness = 42000;
        segment.half_thickness = 0.5F;
        const NodeInput<float> node{vec<float>(c.node.x), vec<float>(c.node.half_chord),
                                    static_cast<float>(c.node.s_fraction), 20, static_cast<float>(c.node.dt)};
        NodeState<float> small_state{vec<float>(c.state.stored)};
        NodeState<double> state = c.state;
        constexpr Effects all{Restraint::incremental, true, true};
        const NodeForce<double> f = solver_node_force<double, all>(law, c.segment, c.node, state);
        const NodeForce<float> g = solver_node_force<float, all>(small_law, segment, node, small_state);
        if (f.at.inside != g.at.inside || (f.penetration >= 5) != (g.penetration >= 5) ||
            (f.speed < 1) != (g.speed < 1))
            continue; // rounding decides
        const double scale = 1 + norm(f.total);
        CHECK(norm(f.total - vec<double>(g.total)) <= 1e-4 * scale);
        CHECK(norm(state.stored - vec<double>(small_state.stored)) <= 1e-4 * (1 + norm(state.stored)));
        ++compared;
    }
    CHECK(compared > 250);
    ManualInput<float> in;
    in.half_chord = {0, 2, 0};
    in.tributary = 2;
    in.displacement = {-1, 0, 0};
    ManualContact<float> at;
    at.normal = {0, 0, 1};
    at.stiffness = 1000;
    float q = 0;
    const ManualForce<float> f = manual_node_force<float, Effects{}>({0, 0, 50, 0, 5}, at, in, q);
    CHECK(q == 100.0F);
    CHECK(f.total.x == 100.0F);
}

TEST_CASE(
    "DEPTH 0: beside the segment the normal force acts with extrapolated weights, the restraint does not") {
    for (const double depth : {0.0, -5.0}) {
        Case c(3);
        c.segment.x = {{{20, 5, 0}, {25, 5, 0}, {25, 10, 0}, {20, 10, 0}}};
        c.node.x = {27, 7.5, 400};
        c.node.half_chord = {0, 4, 0};
        NodeState<double> state = c.state;
        const NodeForce<double> f = solver_node_force<double, Effects{Restraint::incremental, true, false}>(
            {100, 0, 50, 0, depth}, c.segment, c.node, state);
        CHECK_FALSE(f.at.inside);
        CHECK(f.at.weight[0] < 0);
        CHECK(f.penetration == 1);
        CHECK(f.normal_force == 400);
        CHECK(norm(f.tangential) == 0);
        CHECK(norm(state.stored) == 0);
    }
}

TEST_CASE("the stored force survives lift-off, and a node beside the segment") {
    const BeadLaw<double> law{100, 0, 50, 0, 5};
    constexpr Effects effects{Restraint::incremental, true, false};
    Case c(3);
    c.segment.x = {{{20, 5, 0}, {25, 5, 0}, {25, 10, 0}, {20, 10, 0}}};
    for (const Vec3& x : {Vec3{22, 7, 6}, Vec3{28, 7, 0.3}}) {
        c.node.x = x;
        NodeState<double> state = c.state;
        const NodeForce<double> f = solver_node_force<double, effects>(law, c.segment, c.node, state);
        CHECK_FALSE(f.penetration > 0);
        CHECK(f.total == Vec3{});
        CHECK(f.across == f.at.normal);
        CHECK(f.length_squared == 0);
        CHECK(state.stored == c.state.stored);
    }
}

TEST_CASE("a triangle counts its third node's mass twice, and has a projection of its own") {
    Case c(5);
    c.segment.x = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 4, 0}}};
    c.segment.v.fill({-30, 0, 0});
    c.segment.mass = {1, 2, 4, 4};
    c.node.x = {1, 1, 0.3};
    c.node.half_chord = {0, 2, 0};
    NodeState<double> none;
    const NodeForce<double> f = solver_node_force<double, Effects{Restraint::viscous, false, false}>(
        {0, 0, 1e9, 0, 5}, c.segment, c.node, none);
    CHECK(f.at.inside);
    // A quarter of the triangle lies between the node and the edge from 1 to 2, a half at each of the others.
    const Vec3 foot = f.at.weight[0] * c.segment.x[0] + f.at.weight[1] * c.segment.x[1] +
                      (f.at.weight[2] + f.at.weight[3]) * c.segment.x[2];
    CHECK(norm(foot - Vec3{1, 1, 0}) < 1e-14);
    CHECK(f.at.distance == Approx(0.3));
    const double mean = (1 + 2 + 4 + 4) / 4.0;
    CHECK(f.restraint == Approx(60 * std::sqrt(42000 * mean) / 2));
}
