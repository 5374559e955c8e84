#pragma once
// The force of one bead node on the blank, as a pure function of kinematics and state, for either law.
#include "force/lanes.h"
#include "geometry/vec3.h"

#include <array>
#include <cstdint>

namespace drawbead {

enum class Restraint : uint8_t {
    none,
    viscous,
    incremental
}; ///< Iform 1 and 2; none when Ft is 0 at both ends

/// What a kernel is compiled for. What is off leaves no operation behind.
struct Effects {
    Restraint restraint = Restraint::incremental;
    bool normal = true; ///< Fn_first ≠ 0
    bool varies = true; ///< a limit changes along the bead
    bool ramp = true;   ///< δ may be between 0 and DEPTH
    bool share = true;  ///< there, the restraint may be scaled by δ/DEPTH

    friend constexpr bool operator==(const Effects&, const Effects&) = default;
};

/// Parameters of one interface, in one consistent unit system.
template <class Real>
struct BeadLaw {
    Real fn_first = 0, fn_last = 0; ///< force per length; last = 0: constant
    Real ft_first = 0, ft_last = 0;
    Real depth = 0;
};

/// A main segment at one instant: a triangle repeats its third node.
template <class Real>
struct SegmentState {
    std::array<BasicVec3<Real>, 4> x, v;
    std::array<Real, 4> mass{};
    Real stiffness = 0;      ///< k, force per length: 0.2 E t of a shell
    Real half_thickness = 0; ///< g
};

/// Where a bead node is on a segment, as the solver projects it: ratios of triangle areas on opposite edges.
template <class Real>
struct Projection {
    BasicVec3<Real> normal;
    Real xi = 0, eta = 0;  ///< clamped to [−1, 1] when inside
    MaskOf<Real> inside{}; ///< |ξ|, |η| ≤ 1.05: `xface`
    std::array<Real, 4> weight{};
    Real distance = 0; ///< n·(x − Σ h X), positive on the normal's side
};

/// Observed on solver runs; reproduces the traced ξ, η to the last bit.
template <class Real>
Projection<Real> project(const std::array<BasicVec3<Real>, 4>& segment, const BasicVec3<Real>& bead);

/// What the node brings: its position, half chord ½(x_{i+1} − x_{i−1}), arc length fraction s_i/s_n.
template <class Real>
struct NodeInput {
    BasicVec3<Real> x;
    BasicVec3<Real> half_chord;
    Real s_fraction = 0;
    Real slope = 0; ///< of the normal-force ramp, the one that the Engine reads for this node
    Real dt = 0;    ///< last time step, 0 in the first cycle
};

/// History of a node under incremental restraint: the solver keeps a vector per length along T.
template <class Real>
struct NodeState {
    BasicVec3<Real> stored;
};

template <class Real>
struct NodeForce {
    Projection<Real> at;
    Real penetration = 0;    ///< δ
    BasicVec3<Real> across;  ///< T = ± n × l, along the blank's motion; n while δ ≤ 0
    Real length_squared = 0; ///< L²; 0 while δ ≤ 0
    Real speed = 0;          ///< v·T ≥ 0
    Real ft_limit = 0, fn_limit = 0;
    Real restraint = 0;                        ///< p, per length, before the ramp's share
    Real ramp_share = 1;                       ///< δ/DEPTH on an unreset ramp of the normal force, else 1
    Real normal_force = 0;                     ///< N
    BasicVec3<Real> normal, tangential, total; ///< on the blank
    Real slip = 0; ///< increment of plastic slip of this step (incremental restraint)
};

} // namespace drawbead
