// Cost of the bare laws per node and step, on one core: a straight bead of 64 nodes over a blank that
// slides under it. Items are nodes times steps.
#include "force/manual_law.h"
#include "force/solver_step.h"

#include <benchmark/benchmark.h>
#include <vector>

using namespace drawbead;

namespace {

constexpr std::size_t node_count = 64;

template <class Real>
struct Bead {
    BeadLaw<Real> law;
    std::vector<SegmentState<Real>> segment;
    std::vector<NodeInput<Real>> input;
    std::vector<NodeState<Real>> state;

    Bead() : segment(node_count), input(node_count), state(node_count) {
        law = {100, 300, 50, 10, 5};
        for (std::size_t i = 0; i < node_count; ++i) {
            const Real y = Real(4.75) * static_cast<Real>(i), low = Real(5) * static_cast<Real>(i * 19 / 20);
            SegmentState<Real>& s = segment[i];
            s.x = {{{20, low, 0}, {25, low, Real(0.1)}, {25, low + 5, Real(0.15)}, {20, low + 5, 0}}};
            s.v.fill({i % 3 == 0 ? Real(-2000) : Real(2000), 30, 10});
            s.mass.fill(Real(2e-7));
            s.stiffness = 42000;
            s.half_thickness = Real(0.5);
            NodeInput<Real>& n = input[i];
            // On the plateau, on the ramp, and some off the segment.
            n.x = {Real(22.3) + (i % 17 == 0 ? 5 : 0), y, i % 2 == 0 ? Real(0.3) : Real(3)};
            n.half_chord = {0, Real(4.75), 0};
            n.s_fraction = static_cast<Real>(i) / static_cast<Real>(node_count);
            n.slope = 20;
            n.dt = Real(8.7e-7);
        }
    }
};

/// A whole bead, nodes side by side.
template <class Real, Effects E>
void solver_bead(benchmark::State& state) {
    Bead<Real> bead;
    for (auto _ : state) {
        BasicVec3<Lanes<Real>> total;
        solver_step<Real, E>(
            bead.law, std::span<const SegmentState<Real>>(bead.segment),
            std::span<const NodeInput<Real>>(bead.input), std::span(bead.state),
            [&](std::size_t, std::size_t, const NodeForce<Lanes<Real>>& f) { total += f.total; });
        benchmark::DoNotOptimize(total);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * node_count));
}

/// Node by node.
template <class Real, Effects E>
void solver_node(benchmark::State& state) {
    Bead<Real> bead;
    for (auto _ : state) {
        BasicVec3<Real> total;
        for (std::size_t i = 0; i < node_count; ++i) {
            const NodeForce<Real> f =
                solver_node_force<Real, E>(bead.law, bead.segment[i], bead.input[i], bead.state[i]);
            total += f.total;
        }
        benchmark::DoNotOptimize(total);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * node_count));
}

template <class Real, Effects E>
void manual_node(benchmark::State& state) {
    const Bead<Real> bead;
    std::vector<ManualContact<Real>> at(node_count);
    std::vector<ManualInput<Real>> input(node_count);
    std::vector<Real> q(node_count, Real(0));
    for (std::size_t i = 0; i < node_count; ++i) {
        at[i] = {{0, 0, 1}, i % 2 == 0 ? Real(0.3) : Real(3), i % 17 != 0, 42000, Real(0.5), Real(2e-7)};
        input[i] = {{0, Real(4.75), 0}, Real(4.75), bead.input[i].s_fraction, {2000, 30, 10}, {}};
        input[i].displacement = bead.input[i].dt * input[i].velocity;
    }
    for (auto _ : state) {
        BasicVec3<Real> total;
        for (std::size_t i = 0; i < node_count; ++i)
            total += manual_node_force<Real, E>(bead.law, at[i], input[i], q[i]).total;
        benchmark::DoNotOptimize(total);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * node_count));
}

constexpr Effects all{Restraint::incremental, true, true}, viscous{Restraint::viscous, true, true},
    restraint_only{Restraint::incremental, false, false}, normal_only{Restraint::none, true, false},
    nothing{Restraint::none, false, false};

BENCHMARK(solver_bead<double, all>);
BENCHMARK(solver_bead<double, viscous>);
BENCHMARK(solver_bead<double, restraint_only>);
BENCHMARK(solver_bead<double, normal_only>);
BENCHMARK(solver_bead<double, nothing>);
BENCHMARK(solver_bead<float, all>);
BENCHMARK(solver_node<double, all>);
BENCHMARK(solver_node<double, nothing>);
BENCHMARK(manual_node<double, all>);
BENCHMARK(manual_node<double, nothing>);
BENCHMARK(manual_node<float, all>);

} // namespace
