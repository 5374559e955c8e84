#pragma once
// How the rules about motion see a bead's way over its blank, and what they say of it.
#include "rules/rule.h"
#include "scene/bead_path.h"

#include <functional>
#include <string>
#include <vector>

namespace drawbead {

struct BeadAnalysis;

/// nullptr when nothing prescribes the bead's motion. Needs analysis_motion.
const BeadPath* path_of(const RuleContext&, const BeadAnalysis&);

/// Nodes of a bead that a finding is about, with their forces.
struct Affected {
    std::vector<std::size_t> place; ///< in the list
    double fn = 0, ft = 0;
    double length = 0; ///< of the line
};
/// All nodes that those samples stand for whose `share` of the force is not 0.
Affected affected(const BeadAnalysis&, const BeadPath&, const std::function<double(const NodePath&)>& share);

/// A draft that names the nodes, at the first of them.
Draft draft_at_affected(const RuleContext&, const BeadAnalysis&, const Affected&);

/// A note when the blank's motion is not known, and how it was taken.
void note_blank(const BeadPath&, Draft&);

/// Whether the node goes across the bead, in reach of the sheet, by more than an inclined sheet takes of the
/// way along the ramp.
bool moves_sideways(const RuleContext&, const BeadAnalysis&, const NodePath&);

/// Where the end of the run comes from; empty when it is not known.
std::string end_text(const RuleContext&);

std::string time_text(const RuleContext&, double time);
std::string length_text(const RuleContext&, double length);
std::string speed_text(const RuleContext&, double speed);

} // namespace drawbead
