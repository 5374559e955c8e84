#pragma once
// One cycle of a bead under the solver's law, as many nodes side by side as a processor computes at once.
#include "force/solver_law.h"

#include <algorithm>
#include <span>

namespace drawbead {

/// Lanes of get(0), get(1), …
template <class Real, class Get>
[[gnu::always_inline]] inline Lanes<Real> gathered(const Get& get) {
    Lanes<Real> out;
    for (std::size_t i = 0; i < Lanes<Real>::count; ++i)
        out.v[i] = get(i);
    return out;
}
template <class Real, class Get>
[[gnu::always_inline]] inline BasicVec3<Lanes<Real>> gathered_vectors(const Get& get) {
    return {gathered<Real>([&](std::size_t i) { return get(i).x; }),
            gathered<Real>([&](std::size_t i) { return get(i).y; }),
            gathered<Real>([&](std::size_t i) { return get(i).z; })};
}

/// solver_node_force of every node, to the same bits. The spans are parallel. Calls visit(first, count,
/// force) for each group of `count` nodes from number `first` on; lanes from `count` on are to be left alone.
template <class Real, Effects E, class Visit>
void solver_step(const BeadLaw<Real>& bead, std::span<const SegmentState<Real>> segment,
                 std::span<const NodeInput<Real>> input, std::span<NodeState<Real>> state, Visit&& visit) {
    using Wide = Lanes<Real>;
    if constexpr (E.restraint == Restraint::none && !E.normal) return; // nothing acts
    for (std::size_t first = 0; first < segment.size(); first += Wide::count) {
        const std::size_t count = std::min(Wide::count, segment.size() - first);
        const auto at = [&](std::size_t i) { return first + std::min(i, count - 1); };
        SegmentState<Wide> s;
        for (std::size_t k = 0; k < 4; ++k) {
            s.x[k] = gathered_vectors<Real>([&](std::size_t i) { return segment[at(i)].x[k]; });
            s.v[k] = gathered_vectors<Real>([&](std::size_t i) { return segment[at(i)].v[k]; });
            s.mass[k] = gathered<Real>([&](std::size_t i) { return segment[at(i)].mass[k]; });
        }
        s.stiffness = gathered<Real>([&](std::size_t i) { return segment[at(i)].stiffness; });
        s.half_thickness = gathered<Real>([&](std::size_t i) { return segment[at(i)].half_thickness; });
        NodeInput<Wide> node;
        node.x = gathered_vectors<Real>([&](std::size_t i) { return input[at(i)].x; });
        node.half_chord = gathered_vectors<Real>([&](std::size_t i) { return input[at(i)].half_chord; });
        node.s_fraction = gathered<Real>([&](std::size_t i) { return input[at(i)].s_fraction; });
        node.slope = gathered<Real>([&](std::size_t i) { return input[at(i)].slope; });
        node.dt = gathered<Real>([&](std::size_t i) { return input[at(i)].dt; });
        NodeState<Wide> stored;
        if constexpr (E.restraint == Restraint::incremental)
            stored.stored = gathered_vectors<Real>([&](std::size_t i) { return state[at(i)].stored; });
        const NodeForce<Wide> force = solver_node_force<Wide, E>(bead, s, node, stored);
        if constexpr (E.restraint == Restraint::incremental)
            for (std::size_t i = 0; i < count; ++i)
                state[first + i].stored = {stored.stored.x[i], stored.stored.y[i], stored.stored.z[i]};
        visit(first, count, force);
    }
}

} // namespace drawbead
