#pragma once
// The force law as the solver's Engine runs it. Observed on runs of OpenRadioss and reproduced from recorded
// kinematics to the last bit; where it departs from the manual see docs/solver-differences.md.
#include "force/lanes.h"
#include "force/node_force.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

/// Areas that a point spans with the edges of a segment, along the segment's unit normal: for the segment's
/// centre (a) and for the bead node (b). Always inlined: its result is too large to pass through memory.
template <class Real>
[[gnu::always_inline]] inline Projection<Real> project(const std::array<BasicVec3<Real>, 4>& X,
                                                       const BasicVec3<Real>& bead) {
    using std::abs, std::max, std::min;
    using V = BasicVec3<Real>;
    Projection<Real> at;
    const V centre = Real(0.25) * (X[0] + X[1] + X[2] + X[3]);
    const auto area = [&](const V& from, std::size_t k) { return cross(X[k] - from, X[(k + 1) % 4] - from); };
    const std::array<V, 4> around{area(centre, 0), area(centre, 1), area(centre, 2), area(centre, 3)};
    const V whole = around[0] + around[1] + around[2] + around[3];
    at.normal = whole / max(Real(1e-30), norm(whole));
    std::array<Real, 4> a, b;
    for (std::size_t k = 0; k < 4; ++k) {
        a[k] = dot(at.normal, around[k]);
        b[k] = dot(at.normal, area(bead, k));
    }
    const Real none(0), one(1);
    const auto ratio = [&](Real over, Real under) { return select(is_zero(under), none, over / under); };
    const MaskOf<Real> triangle = is_zero(a[2]);
    at.xi = ratio(a[1] * b[3] - b[1] * a[3], a[1] * b[3] + b[1] * a[3]);
    at.eta = ratio(select(triangle, b[0] - a[0], b[0] * a[2] - b[2] * a[0]),
                   select(triangle, a[0], b[0] * a[2] + b[2] * a[0]));
    const Real reach = Real(1.05);
    at.inside = both(abs(at.xi) <= reach, abs(at.eta) <= reach);
    at.xi = select(at.inside, max(-one, min(at.xi, one)), at.xi);
    at.eta = select(at.inside, max(-one, min(at.eta, one)), at.eta);
    const Real quarter(0.25);
    const Real xi_low = one - at.xi, xi_high = one + at.xi, eta_low = quarter * (one - at.eta),
               eta_high = quarter * (one + at.eta);
    at.weight = {eta_low * xi_low, eta_low * xi_high, eta_high * xi_high, eta_high * xi_low};
    V foot = at.weight[0] * X[0];
    for (std::size_t k = 1; k < 4; ++k)
        foot += at.weight[k] * X[k];
    at.distance = dot(at.normal, bead - foot);
    return at;
}

/// Limit at a node: the first value, or linear to `last` when that is not 0.
template <class Real>
constexpr Real solver_limit(Scalar<Real> first, Scalar<Real> last, Real s_fraction) {
    return last == 0 ? Real(first) : first + s_fraction * Real(last - first);
}

/// Force of one node in one cycle, or of some of them side by side (Real = Lanes). `state` is read and
/// written under incremental restraint only. Inlined, so that a loop pays only for the results that it uses.
template <class Real, Effects E>
[[gnu::always_inline]] inline NodeForce<Real>
solver_node_force(const BeadLaw<Scalar<Real>>& bead, const SegmentState<Real>& segment,
                  const NodeInput<Real>& node, NodeState<Real>& state) {
    using std::abs, std::max, std::min, std::sqrt, std::copysign;
    using V = BasicVec3<Real>;
    const Real none(0), one(1);
    NodeForce<Real> out;
    // Without a force nothing is to be known of the node, not even where it is.
    if constexpr (E.restraint == Restraint::none && !E.normal) return out;
    out.at = project(segment.x, node.x);
    const Real face = select(out.at.inside, one, none), depth(bead.depth);
    out.penetration = bead.depth > 0 ? (depth - out.at.distance + segment.half_thickness) * face : one;
    out.ft_limit =
        E.varies ? solver_limit(bead.ft_first, bead.ft_last, node.s_fraction) : Real(bead.ft_first);
    out.fn_limit =
        E.varies ? solver_limit(bead.fn_first, bead.fn_last, node.s_fraction) : Real(bead.fn_first);
    const MaskOf<Real> acts = out.penetration > none;
    if constexpr (std::is_same_v<MaskOf<Real>, bool>)
        if (!acts) {
            out.across = out.at.normal;
            return out;
        }
    const auto only = [&](const V& yes, const V& no) {
        return V{select(acts, yes.x, no.x), select(acts, yes.y, no.y), select(acts, yes.z, no.z)};
    };

    V velocity = out.at.weight[0] * segment.v[0];
    for (std::size_t k = 1; k < 4; ++k)
        velocity += out.at.weight[k] * segment.v[k];
    V T = cross(out.at.normal, node.half_chord);
    const Real L2 = max(dot(T, T), Real(1e-20));
    const Real along = dot(velocity, T);
    const MaskOf<Real> backwards = along < none;
    T = {select(backwards, -T.x, T.x), select(backwards, -T.y, T.y), select(backwards, -T.z, T.z)};
    const Real vv = select(backwards, -along, along);
    out.across = only(T, out.at.normal);
    out.length_squared = select(acts, L2, none);
    out.speed = select(acts, vv, none);
    const Real L = sqrt(L2);
    const Real per_L2 = one / L2; // products with reciprocals, as the Engine has them, to the last bit
    const Real k = segment.stiffness;

    if constexpr (E.restraint != Restraint::none) {
        const Real mass =
            Real(0.25) * (segment.mass[0] + segment.mass[1] + segment.mass[2] + segment.mass[3]);
        if constexpr (E.restraint == Restraint::viscous) {
            out.restraint = min(vv * sqrt(k * mass * per_L2), out.ft_limit) * face;
        } else {
            const Real damping = Real(0.1); // the solver's fixed viscosity of Iform 2
            const Real damper = sqrt(damping * damping * k * mass);
            const V trial = (state.stored + node.dt * (k * velocity)) * face;
            Real e = dot(trial, T) * per_L2;
            const Real force = e + vv * face * sqrt(damping * damping * k * mass * per_L2);
            const Real p = copysign(abs(min(abs(force), out.ft_limit)), force);
            const Real under = k + select(is_zero(node.dt), none, damper * (one / node.dt));
            const Real slip = (force - p) / max(Real(1e-20), under);
            e -= k * slip;
            state.stored = only(e * T, state.stored);
            out.slip = select(acts, slip, none);
            out.restraint = p;
        }
        out.restraint = select(acts, out.restraint, none);
    }
    if constexpr (E.normal) {
        out.normal_force = out.fn_limit * L;
        if constexpr (E.ramp) {
            const MaskOf<Real> plateau = out.penetration >= depth;
            out.normal_force = select(plateau, out.normal_force, node.slope * out.penetration * L);
            if (E.share && bead.fn_first != 0) {
                const Real share = select(node.slope < k, out.penetration / depth, one);
                out.ramp_share = select(acts, select(plateau, one, share), one);
            }
        }
        out.normal_force = select(acts, out.normal_force, none);
        out.normal = only(-out.normal_force * out.at.normal, {});
    }
    if constexpr (E.restraint != Restraint::none)
        out.tangential = only(-(out.restraint * T) * out.ramp_share, {});
    out.total = out.normal + out.tangential;
    return out;
}

} // namespace drawbead
