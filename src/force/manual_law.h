#pragma once
// The law that the manual describes: independent of units, continuous, and with the physical reading where
// the manual is silent. Restraint acts against the blank's velocity relative to the bead.
#include "force/node_force.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

/// Where a bead node is on the blank, by the closest point of the whole surface.
template <class Real>
struct ManualContact {
    BasicVec3<Real> normal;  ///< of the winning segment at the foot
    Real distance = 0;       ///< signed along the normal
    bool on_surface = true;  ///< false: beyond the free edge by over 5 % of the segment's size
    Real stiffness = 0;      ///< k_b = 0.2 E t, force per length
    Real half_thickness = 0; ///< t/2
    Real mass = 0;           ///< mean of the segment's nodal masses
};

template <class Real>
struct ManualInput {
    BasicVec3<Real> half_chord;   ///< ½(x_{i+1} − x_{i−1}), index clamped at the ends
    Real tributary = 0;           ///< L: |half_chord|, or half the adjacent hops
    Real s_fraction = 0;          ///< arc length fraction along the deck's coordinates
    BasicVec3<Real> velocity;     ///< of the blank relative to the bead node
    BasicVec3<Real> displacement; ///< of the blank relative to the bead node in this step
};

template <class Real>
struct ManualForce {
    BasicVec3<Real> normal, across;  ///< n and u = unit(n × l)
    Real penetration = 0;            ///< δ = DEPTH − d + t/2
    Real ramp = 0;                   ///< r in [0, 1]: share of the limits that acts
    bool reset = false;              ///< the ramp is the blank's stiffness
    Real ft_limit = 0, fn_limit = 0; ///< per length, negative ones taken as 0
    Real restraint = 0;              ///< q, a force, along −u on the blank
    Real normal_force = 0;           ///< N along −n on the blank
    Real slip = 0;                   ///< displacement that the slider took up in this step
    BasicVec3<Real> total;           ///< on the blank
};

/// Limit at a node: linear to `last` when that is not 0; negative limits count as 0, after the interpolation.
template <class Real>
constexpr Real manual_limit(Real first, Real last, Real s_fraction) {
    return std::max(last == 0 ? first : first + s_fraction * (last - first), Real(0));
}

/// v / |v| whatever its magnitude; zero for a zero vector.
template <class Real>
BasicVec3<Real> unit_of(BasicVec3<Real> v) {
    constexpr Real far = sizeof(Real) == 8 ? Real(1e140) : Real(1e15); // the square is still a number
    Real size = norm(v);
    if (!(size > 1 / far && size < far)) {
        const Real largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        v = largest > 0 ? v / largest : BasicVec3<Real>{};
        size = largest > 0 ? norm(v) : Real(1);
    }
    return v / size;
}

/// Force of one node. `q` is the slider's force: read and written under incremental restraint, 0 on each new
/// contact. The return map is exact at the end of a step in which the velocity keeps its sign.
template <class Real, Effects E>
ManualForce<Real> manual_node_force(const BeadLaw<Real>& bead, const ManualContact<Real>& at,
                                    const ManualInput<Real>& node, Real& q) {
    ManualForce<Real> out;
    if constexpr (E.restraint == Restraint::none && !E.normal) return out;
    out.normal = at.normal;
    out.across = unit_of(cross(at.normal, node.half_chord));
    out.ft_limit = E.varies ? manual_limit(bead.ft_first, bead.ft_last, node.s_fraction)
                            : std::max(bead.ft_first, Real(0));
    const bool normal_on = E.normal && bead.fn_first != 0;
    if (normal_on)
        out.fn_limit = E.varies ? manual_limit(bead.fn_first, bead.fn_last, node.s_fraction)
                                : std::max(bead.fn_first, Real(0));
    const Real depth = std::max(bead.depth, Real(0));
    out.penetration = depth - at.distance + at.half_thickness;
    if (!at.on_surface || !(out.penetration > 0)) {
        q = 0;
        return out;
    }
    const Real P = out.fn_limit * node.tributary;
    if (!E.ramp) {
        out.ramp = 1;
        out.normal_force = P;
    } else if (P == 0) {
        out.ramp = depth > 0 ? std::min(out.penetration / depth, Real(1)) : Real(1);
    } else if (depth > 0 && P / depth <= at.stiffness) {
        out.ramp = std::min(out.penetration / depth, Real(1));
        out.normal_force = P * out.ramp;
    } else {
        out.reset = true;
        out.normal_force = std::min(at.stiffness * out.penetration, P);
        out.ramp = out.normal_force / P;
    }
    if constexpr (E.restraint != Restraint::none) {
        const Real limit = out.ft_limit * node.tributary * (E.share ? out.ramp : Real(1));
        if constexpr (E.restraint == Restraint::viscous) {
            const Real speed = dot(node.velocity, out.across);
            out.restraint = std::clamp(std::sqrt(at.stiffness * at.mass) * speed, -limit, limit);
        } else {
            const Real trial = q + at.stiffness * dot(node.displacement, out.across);
            out.restraint = std::clamp(trial, -limit, limit);
            out.slip = at.stiffness > 0 ? (trial - out.restraint) / at.stiffness : Real(0);
            q = out.restraint;
        }
    }
    out.total = -out.normal_force * out.normal - out.restraint * out.across;
    return out;
}

} // namespace drawbead
