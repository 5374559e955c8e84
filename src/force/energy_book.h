#pragma once
// Energy between one bead and the blank, summed over the steps of a motion.
#include "geometry/vec3.h"

#include <cstddef>
#include <vector>

namespace drawbead {

/// In units of force times length. restraint_work + stored + dissipated − created = 0 up to rounding.
struct BeadEnergy {
    double normal_work = 0;    ///< of the normal force on the blank
    double restraint_work = 0; ///< of the restraint on the blank; negative: it brakes
    double stored = 0;         ///< in the springs of incremental restraint, now
    double dissipated = 0;     ///< over the steps in which absorbed work exceeds what is stored
    double created = 0;        ///< over the others: energy from nowhere
};

/// Forces of one bead node on the blank at one time.
struct NodeEnergy {
    Vec3 normal, restraint;
    double stored = 0; ///< |stored force|² / 2k
};

/// Work is by the trapezium rule: exact for forces that are linear over each step, and velocities stand
/// halfway between two forces. All nodes begin without force.
class EnergyBook {
public:
    explicit EnergyBook(std::size_t nodes) : before_(nodes) {}

    /// `displacement`: of the blank under the node since this node's step before.
    void step(std::size_t node, const NodeEnergy& now, const Vec3& displacement);

    BeadEnergy energy() const;

private:
    std::vector<NodeEnergy> before_;
    BeadEnergy sums_; ///< all but what is stored
};

} // namespace drawbead
