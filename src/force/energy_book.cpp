#include "force/energy_book.h"

#include <cmath>

namespace drawbead {

void EnergyBook::step(std::size_t node, const NodeEnergy& now, const Vec3& displacement) {
    NodeEnergy& before = before_[node];
    sums_.normal_work += 0.5 * dot(before.normal + now.normal, displacement);
    const double restraint = 0.5 * dot(before.restraint + now.restraint, displacement);
    sums_.restraint_work += restraint;
    const double lost = -restraint - (now.stored - before.stored);
    (lost >= 0 ? sums_.dissipated : sums_.created) += std::abs(lost);
    before = now;
}

BeadEnergy EnergyBook::energy() const {
    BeadEnergy out = sums_;
    for (const NodeEnergy& node : before_)
        out.stored += node.stored;
    return out;
}

} // namespace drawbead
