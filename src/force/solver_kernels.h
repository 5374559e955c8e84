#pragma once
// The solver's law compiled for each combination of effects, and which of them an interface needs.
#include "force/solver_law.h"

#include <cstddef>

namespace drawbead {

using SolverKernel = NodeForce<double> (*)(const BeadLaw<double>&, const SegmentState<double>&,
                                           const NodeInput<double>&, NodeState<double>&);

/// What the solver computes for an interface. Iform 2 keeps its stored force even where Ft is 0.
constexpr Effects effects_of(const BeadLaw<double>& law, int iform) {
    return {iform == 1   ? Restraint::viscous
            : iform == 2 ? Restraint::incremental
                         : Restraint::none,
            law.fn_first != 0, law.fn_last != 0 || law.ft_last != 0};
}

/// Without a normal force there is no ramp either.
template <Restraint R, bool varies>
SolverKernel solver_kernel_of(const Effects& e) {
    if (!e.normal) return solver_node_force<double, Effects{R, false, varies, false, false}>;
    if (!e.ramp) return solver_node_force<double, Effects{R, true, varies, false, false}>;
    return e.share ? solver_node_force<double, Effects{R, true, varies, true, true}>
                   : solver_node_force<double, Effects{R, true, varies, true, false}>;
}

template <Restraint R>
SolverKernel solver_kernel_of(const Effects& e) {
    return e.varies ? solver_kernel_of<R, true>(e) : solver_kernel_of<R, false>(e);
}

inline SolverKernel solver_kernel(const Effects& effects) {
    switch (effects.restraint) {
    case Restraint::viscous:
        return solver_kernel_of<Restraint::viscous>(effects);
    case Restraint::incremental:
        return solver_kernel_of<Restraint::incremental>(effects);
    case Restraint::none:
        break;
    }
    return solver_kernel_of<Restraint::none>(effects);
}

} // namespace drawbead
