#pragma once
// The kernel of solver_block.h, for the files that compile it for their processor. Whatever it calls is
// either inlined or a template over N, so that nothing compiled for AVX2 is taken for something else.
#include "force/solver_block.h"
#include "force/solver_kernels.h"

#include <cstring>

namespace drawbead {

template <std::size_t N>
[[gnu::always_inline]] inline Lanes<double, 8 * N> load(const Row<N>& row) {
    Lanes<double, 8 * N> out;
    std::memcpy(&out.v, &row.of, sizeof row.of);
    return out;
}
template <std::size_t N>
[[gnu::always_inline]] inline BasicVec3<Lanes<double, 8 * N>> load(const RowVec3<N>& row) {
    return {load(row.x), load(row.y), load(row.z)};
}
template <std::size_t N>
[[gnu::always_inline]] inline void store(Row<N>& row, const Lanes<double, 8 * N>& value) {
    std::memcpy(&row.of, &value.v, sizeof row.of);
}
template <std::size_t N>
[[gnu::always_inline]] inline void store(RowVec3<N>& row, const BasicVec3<Lanes<double, 8 * N>>& value) {
    store(row.x, value.x), store(row.y, value.y), store(row.z, value.z);
}

/// Work by the trapezium rule: velocities stand halfway between two forces.
template <std::size_t N, Effects E>
void solver_block(const BeadLaw<double>& law, SolverLanes<N>& lanes, SolverBlock<N>& block) {
    using Real = Lanes<double, 8 * N>;
    using V = BasicVec3<Real>;
    SegmentState<Real> segment;
    for (std::size_t k = 0; k < 4; ++k) {
        segment.x[k] = load(block.segment_x[k]);
        segment.v[k] = load(block.segment_v[k]);
        segment.mass[k] = load(lanes.mass[k]);
    }
    segment.stiffness = load(lanes.stiffness);
    segment.half_thickness = load(lanes.half_thickness);
    NodeInput<Real> node;
    node.x = load(block.x);
    node.half_chord = load(block.half_chord);
    node.s_fraction = load(block.s_fraction);
    node.slope = load(lanes.slope);
    node.dt = Real(block.dt);
    NodeState<Real> state;
    state.stored = load(lanes.stick);
    const Real none(0), one(1);
    const NodeForce<Real> f = [&] {
        if constexpr (E.restraint != Restraint::none || E.normal) {
            return solver_node_force<Real, E>(law, segment, node, state);
        } else {
            // Nothing can act, but where the node is may be asked for.
            NodeForce<Real> idle;
            idle.at = project(segment.x, node.x);
            const Real face = select(idle.at.inside, one, none);
            idle.penetration =
                law.depth > 0 ? (Real(law.depth) - idle.at.distance + segment.half_thickness) * face : one;
            return idle;
        }
    }();
    if constexpr (E.restraint == Restraint::incremental) store(lanes.stick, state.stored);
    store(block.inside, select(f.at.inside, one, none));
    store(block.xi, f.at.xi);
    store(block.eta, f.at.eta);
    store(block.distance, f.at.distance);
    store(block.penetration, f.penetration);
    store(block.ft_limit, f.ft_limit);
    store(block.limited, f.restraint);
    store(block.ramp_share, f.ramp_share);
    store(block.normal_size, f.normal_force);
    store(block.slip, f.slip);
    store(block.restraint_size, norm(f.tangential));
    const V foot = f.at.weight[0] * segment.x[0] + f.at.weight[1] * segment.x[1] +
                   f.at.weight[2] * segment.x[2] + f.at.weight[3] * segment.x[3];
    store(block.couple, cross(foot - node.x, f.total));
    if (block.books) {
        V v;
        for (std::size_t k = 0; k < 4; ++k)
            v += f.at.weight[k] * segment.v[k];
        const V normal_before = load(lanes.normal), restraint_before = load(lanes.restraint);
        const Real half(0.5 * block.dt);
        store(block.normal_work, half * dot(normal_before + f.normal, v));
        store(block.restraint_work, half * dot(restraint_before + f.tangential, v));
        store(block.tool_work,
              half * dot(normal_before + restraint_before + f.total, load(block.tool_velocity)));
        Real stored = none;
        if (block.stores) {
            const auto holds = both(segment.stiffness > none, abs(f.ft_limit) > none);
            stored = select(holds, squared_norm(state.stored) / (Real(2) * segment.stiffness), none);
        }
        store(block.stored_change, stored - load(lanes.stored_energy));
        store(lanes.stored_energy, stored);
    }
    store(lanes.normal, f.normal);
    store(lanes.restraint, f.tangential);
}

template <std::size_t N>
SolverBlockKernel<N> kernel_for(const Effects& effects) {
    return with_effects(effects, []<Effects E>() -> SolverBlockKernel<N> { return solver_block<N, E>; });
}

} // namespace drawbead
