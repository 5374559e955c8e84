#pragma once
// One cycle of some bead nodes side by side under the solver's law: force, moments and energies of each, in
// rows of one number per node, so that nothing is moved from one order to another on the way.
#include "force/solver_law.h"

#include <array>
#include <cstddef>

namespace drawbead {

/// One number of each node.
template <std::size_t N>
struct alignas(8 * N) Row {
    std::array<double, N> of{};
    double& operator[](std::size_t lane) { return of[lane]; }
    double operator[](std::size_t lane) const { return of[lane]; }
};
template <std::size_t N>
struct RowVec3 {
    Row<N> x, y, z;
    void set(std::size_t lane, Vec3 v) { x[lane] = v.x, y[lane] = v.y, z[lane] = v.z; }
    Vec3 operator[](std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
};

/// What stays of N nodes from cycle to cycle.
template <std::size_t N>
struct SolverLanes {
    // Of the segment under each node, and of the node: to be set when it changes.
    std::array<Row<N>, 4> mass;
    Row<N> stiffness, half_thickness, slope;
    // History.
    RowVec3<N> stick;             ///< NodeState::stored
    RowVec3<N> normal, restraint; ///< forces of the last cycle
    Row<N> stored_energy;
};

/// What is new in a cycle.
template <std::size_t N>
struct SolverBlock {
    std::array<RowVec3<N>, 4> segment_x, segment_v;
    RowVec3<N> x, half_chord, tool_velocity;
    Row<N> s_fraction;
    double dt = 0;
    bool stores = false; ///< the stick force holds energy: not under Iform 1
    bool books = false;  ///< energies are asked for

    // Results, as NodeForce names them.
    Row<N> inside; ///< 1 or 0
    Row<N> xi, eta, distance, penetration, ft_limit, limited, ramp_share, normal_size, slip;
    Row<N> restraint_size;                                        ///< |tangential|
    RowVec3<N> couple;                                            ///< about the bead node
    Row<N> normal_work, restraint_work, tool_work, stored_change; ///< of this cycle
};

/// N nodes under one combination of effects. Forces and history are left in the lanes.
template <std::size_t N>
using SolverBlockKernel = void (*)(const BeadLaw<double>&, SolverLanes<N>&, SolverBlock<N>&);

/// For N = 2 on every processor, N = 4 where runs_four_lanes(): the same bits.
template <std::size_t N>
SolverBlockKernel<N> solver_block_kernel(const Effects&);
template <>
SolverBlockKernel<2> solver_block_kernel<2>(const Effects&);
template <>
SolverBlockKernel<4> solver_block_kernel<4>(const Effects&);

bool runs_four_lanes();

} // namespace drawbead
