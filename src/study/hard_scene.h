#pragma once
// A sheet under a straight bead, to be evaluated under either law without a deck: what the hard cases of
// whole runs vary.
#include "force/evaluator.h"

#include <functional>
#include <vector>

namespace drawbead {

/// 20 × 20 shells of 5 mm at z = 0 under nine nodes along y, 4 mm apart; force in N, time in s.
struct SheetSpec {
    BeadLaw<double> law{100, 0, 50, 0, 5};
    int iform = 2;
    std::vector<Vec3> bead; ///< positions in list order
    uint32_t cells = 20;
    double size = 5, young = 210000, thickness = 1, node_mass = 2e-7;
    bool triangles = false; ///< each quad as two
    bool solid = false;     ///< faces of solids of the same stiffness: no half thickness
    bool flipped = false;   ///< normals away from the bead
    /// Of the mesh and the bead before anything moves.
    std::function<Vec3(Vec3)> place = [](Vec3 x) { return x; };
    std::function<double(Vec3)> mass; ///< of a node; empty: node_mass
    Motion tool, blank;
    double t_start = 0, t_stop = 1e30;
    std::vector<double> time; ///< of the steps; empty: `steps` to `end`
    double end = 1;
    std::size_t steps = 100;
    unsigned shuffle = 0;    ///< seed of an order of segments and node ids; 0: as they come
    unsigned all_stages = 0; ///< 1: also what the plan leaves out

    SheetSpec();
    /// Nine nodes at this x and height, `spacing` apart, from y on.
    void straight(double x, double height, double y = 31.7, double spacing = 4, std::size_t nodes = 9);
};

struct SheetOutcome {
    BeadHistory history;
    EffectCounts counts{};
    std::vector<NodeSample> last; ///< of the last step

    const StepTotals& end() const { return history.steps.back(); }
    bool is_finite() const { return !first_not_finite(history); }
};

SheetOutcome evaluate(const SheetSpec&, Law);

Motion::Term speed(std::size_t axis, TimeTable table);
Motion::Term way(std::size_t axis, TimeTable table);

} // namespace drawbead
