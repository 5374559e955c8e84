#pragma once
// The one repair of a surface that SRF001, SRF002 and SRF003 share.
#include "rules/rule.h"

#include <optional>

namespace drawbead {

/// What it looks at beyond the checks' needs.
inline constexpr Needs surface_fix_needs = Needs::surface_users;

/// Repairs the surface that the draft is about, for all of its beads at once.
std::optional<Fix> fix_surface(const RuleContext&, const Draft&, FixPlanner&);

/// Whether a repair in the surface can be expected; else nothing is offered.
bool offers_surface_fix(const Surface&);

} // namespace drawbead
