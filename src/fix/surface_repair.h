#pragma once
// Turns the segments of one main surface toward its beads, by the smallest edit that keeps the solver's order
// of the segments: a sign, SEG lines written the other way round, or signed groups in a surface of the beads'
// own. As observed on solver runs each of these gives the segments and forces of the deck that was never
// wrong; lines of SEG made from elements would not, and are never written.
#include "fix/planner.h"
#include "fix/segment_turns.h"
#include "model/model.h"

#include <optional>
#include <vector>

namespace drawbead {

/// The one repair of a surface for all beads that use it. `votes`: of every drawbead on the surface, also
/// those that say nothing. Needs::surface_users.
std::optional<Fix> repair_surface(const Model&, uint32_t surface, const std::vector<BeadVotes>& votes,
                                  FixPlanner&);

/// Whether it is made of faces of solids, not counting those that SEG lines list.
bool has_solid_faces(const Surface&);

} // namespace drawbead
