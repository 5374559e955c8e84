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

/// Calls use.operator()<E>() with the effects as a constant. Without a normal force there is no ramp either.
template <class Use>
auto with_effects(const Effects& effects, Use&& use) {
    const auto with_ramp = [&]<Restraint R, bool varies>() {
        if (!effects.normal) return use.template operator()<Effects{R, false, varies, false, false}>();
        if (!effects.ramp) return use.template operator()<Effects{R, true, varies, false, false}>();
        return effects.share ? use.template operator()<Effects{R, true, varies, true, true}>()
                             : use.template operator()<Effects{R, true, varies, true, false}>();
    };
    const auto with_limits = [&]<Restraint R>() {
        return effects.varies ? with_ramp.template operator()<R, true>()
                              : with_ramp.template operator()<R, false>();
    };
    if (effects.restraint == Restraint::viscous) return with_limits.template operator()<Restraint::viscous>();
    if (effects.restraint == Restraint::incremental)
        return with_limits.template operator()<Restraint::incremental>();
    return with_limits.template operator()<Restraint::none>();
}

inline SolverKernel solver_kernel(const Effects& effects) {
    return with_effects(effects, []<Effects E>() -> SolverKernel { return solver_node_force<double, E>; });
}

} // namespace drawbead
