#pragma once
// The solver's search over a surface that keeps its shape, nearly without the positions of its nodes at each
// step.
#include "contact/solver_search.h"

#include <array>
#include <cstdint>
#include <vector>

namespace drawbead {

/// Positions of a surface's nodes at the step at hand, to the last bit, each made when it is asked for.
class SurfaceNow {
public:
    virtual const Vec3& at(uint32_t node) = 0;

protected:
    ~SurfaceNow() = default;
};

/// Gives what solver_follow gives. Comparisons whose outcome is beyond doubt by the surface as it was at the
/// start are decided by that, the others by the exact positions. What it needs of a node's ring and of a
/// segment's corner is made when it is first asked for, and kept.
class RigidTracks {
public:
    /// `error`: how far, in units of length, the distance of two points may be off at any step.
    RigidTracks(const NearMesh&, double error);

    struct Step {
        bool complete = true;  ///< as solver_follow returns it
        bool searched = false; ///< the node had left the region in which its track cannot change
        /// How far the bead node may go on against the surface, in any direction, before the track can
        /// change.
        double margin = 0;
    };
    /// One cycle of a bead node at `bead`, where the surface as it was at the start would see it at y.
    Step follow(Track&, Vec3 y, Vec3 bead, SurfaceNow&);

private:
    /// Halfway between a node and another one of its ring.
    struct Bisector {
        Vec3 inward; ///< unit vector to the side of the node
        double offset = 0;
        double twice = 0; ///< the distance of the two nodes, twice
        uint32_t other = 0;
    };
    struct Ring {
        uint32_t begin = 0, end = 0; ///< in bisector_
        double longest = 0;          ///< `twice` of the farthest node
        double per_length = 0;       ///< one over the distance of the closest node
    };
    /// Barycentric coordinates of a corner's triangle: b_k = gradient_k · (y − at), and 1 more for b_0.
    struct Corner {
        Vec3 at;
        Vec3 gradient_1, gradient_2;
        std::array<double, 3> size{}; ///< of the gradients
        double largest = 0;
        double turn = 0; ///< relative change of a gradient per length that a node is off
    };
    /// The smallest coordinate of a corner, and how far it may be off.
    struct Inside {
        double least = 0, error = 0;
        double margin = 0; ///< to the closest side

        bool in_doubt() const { return !(least > error) && !(least < -error); }
    };

    const Ring& ring(uint32_t node);
    const Corner& corner(uint32_t segment, std::size_t place);
    double least(const Ring&, Vec3 y) const;
    uint32_t closest_of_ring(const Ring&, uint32_t node, double unsure, Vec3 y, Vec3 bead, SurfaceNow&) const;
    Inside inside(uint32_t segment, uint32_t nearest, Vec3 y);
    Inside exactly(uint32_t segment, uint32_t nearest, Vec3 bead, SurfaceNow&) const;

    const NearMesh& mesh_;
    double error_;
    std::vector<uint32_t> ring_of_, corner_of_; ///< by node, and by segment and place: an index + 1, or 0
    std::vector<Ring> rings_;
    std::vector<Bisector> bisector_;
    std::vector<Corner> corners_;
};

} // namespace drawbead
