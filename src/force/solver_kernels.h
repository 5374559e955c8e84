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

template <Restraint R>
SolverKernel solver_kernel_of(bool normal, bool varies) {
    if (normal)
        return varies ? solver_node_force<double, Effects{R, true, true}>
                      : solver_node_force<double, Effects{R, true, false}>;
    return varies ? solver_node_force<double, Effects{R, false, true}>
                  : solver_node_force<double, Effects{R, false, false}>;
}

inline SolverKernel solver_kernel(Effects effects) {
    switch (effects.restraint) {
    case Restraint::viscous:
        return solver_kernel_of<Restraint::viscous>(effects.normal, effects.varies);
    case Restraint::incremental:
        return solver_kernel_of<Restraint::incremental>(effects.normal, effects.varies);
    case Restraint::none:
        break;
    }
    return solver_kernel_of<Restraint::none>(effects.normal, effects.varies);
}

} // namespace drawbead
