#pragma once
// Positions of a surface's nodes at the steps of an evaluation, each brought up to date when it is asked for.
#include "force/evaluation.h"

#include <span>
#include <vector>

namespace drawbead {

/// Nodes add up the same increments in the same order, however often they are asked for.
class MovingSurface {
public:
    MovingSurface(const EvaluationSurface& surface, const std::vector<MotionSteps>& steps)
        : surface_(surface), steps_(steps), x_(surface.mesh.x), stamp_(surface.mesh.x.size(), 0),
          rings_(surface.mesh.x.size()) {}

    /// Position of a local node at step n, which never goes back.
    const Vec3& at(uint32_t node, std::size_t n) {
        if (stamp_[node] != n) bring(node, static_cast<uint32_t>(n));
        return x_[node];
    }
    /// Velocity v_{n−1/2} of a node.
    Vec3 velocity(uint32_t node, std::size_t n) const {
        const MotionSteps& m = steps_[surface_.motion[node]];
        if (!m.turns || n == 0) return m.velocity_of(n);
        const Vec3 x = surface_.mesh.x[node];
        // The increments of the translation are in the placements.
        return m.rate[n] * (m.placements[n](x) - m.placements[n - 1](x));
    }
    /// What solver_follow may look at from `node` on: two rings.
    void bring_rings(uint32_t node, std::size_t n) {
        if (rings_[node].empty()) find_rings(node);
        for (const uint32_t one : rings_[node])
            at(one, n);
    }
    void bring_segment(uint32_t segment, std::size_t n);
    void bring_all(std::size_t n) {
        for (uint32_t i = 0; i < x_.size(); ++i)
            at(i, n);
    }
    std::span<const Vec3> x() const { return x_; }

private:
    void bring(uint32_t node, uint32_t n);
    void find_rings(uint32_t node);

    const EvaluationSurface& surface_;
    const std::vector<MotionSteps>& steps_;
    std::vector<Vec3> x_;
    std::vector<uint32_t> stamp_;              ///< step that x_ is of
    std::vector<std::vector<uint32_t>> rings_; ///< by node, found when first asked for
};

} // namespace drawbead
