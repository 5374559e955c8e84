#pragma once
// What a bead does to the stable time step: its stiffness against the masses of the sheet under it.
#include "rules/rule.h"

#include <cstdint>
#include <optional>

namespace drawbead {

struct BeadAnalysis;

/// The node of the sheet whose step shrinks most, in work units.
struct TimeStepRisk {
    int64_t node = 0;
    double normal = 0; ///< sum over bead nodes of slope · L · h: stiffness of the ramp
    double stick = 0;  ///< sum of k · h: of the sticking restraint, in the plane of the sheet
    double mass = 0;
    double element_step = 0; ///< smallest size over speed of sound of the shells around

    /// They act in different directions.
    double contact() const { return normal > stick ? normal : stick; }
    /// Step with the bead over that without: both frequencies squared add, and a step is stable up to
    /// 2 / omega.
    double ratio() const;
};

/// Empty when masses or stiffness are not known. Needs what viscous_bead needs.
std::optional<TimeStepRisk> time_step_risk(const RuleContext&, const BeadAnalysis&);

} // namespace drawbead
