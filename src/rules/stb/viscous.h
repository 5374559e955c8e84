#pragma once
// The viscous form (Iform 1): what of Ft it reaches at a speed.
#include "rules/rule.h"

#include <optional>
#include <string_view>
#include <vector>

namespace drawbead {

struct BeadAnalysis;

/// Bead nodes over the surface. The restraint of one is min(speed * damping, limit) * length.
struct ViscousBead {
    struct Node {
        double damping = 0; ///< sqrt(k m): mass / time
        double limit = 0;   ///< |Ft| there: force per length
        double length = 0;  ///< tributary
    };
    std::vector<Node> node;

    double speed_to_limit() const; ///< at which every node has its limit
    /// Restraint of the whole bead. The solver compares speed * damping, a force, with a force per length:
    /// the number of the speed in the deck's unit of length decides.
    double restraint(double speed) const;
    double limit() const;
};

/// Empty when it is not viscous, has no restraint, or masses or stiffness are not known. Masses are those of
/// the shells of the surface. Needs analysis_sides and analysis_contact, and the thickness of elements.
std::optional<ViscousBead> viscous_bead(const RuleContext&, const BeadAnalysis&);

} // namespace drawbead
