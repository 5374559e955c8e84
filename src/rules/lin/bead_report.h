#pragma once
// How the rules about bead lines and surfaces name places, nodes and costs.
#include "rules/analysis.h"
#include "rules/rule.h"

#include <cstdint>
#include <string>
#include <vector>

namespace drawbead {

/// Where position i of the bead's list stands in the deck: its entry in the list, else the group's header.
std::vector<Span> list_places(const RuleContext&, const BeadAnalysis&);

/// User id of the node at position i of the list.
int64_t node_id(const RuleContext&, const BeadAnalysis&, std::size_t i);

/// "+750 N of Fn, 33 % of its total, and +375 N of Ft, 33 % of its total": forces that the finding adds to
/// (or takes from) the totals. A limit that is 0 along the bead is not named.
std::string cost_text(const RuleContext&, const BeadAnalysis&, double fn, double ft);
/// The same without a plus: "750 N of Fn, 33 % of its total, …", for forces that are not added to anything.
std::string force_text(const RuleContext&, const BeadAnalysis&, double fn, double ft);
/// One limit alone, with a plus: "+750 N of Fn, 33 % of its total".
std::string fn_cost_text(const RuleContext&, const BeadAnalysis&, double fn);
std::string ft_cost_text(const RuleContext&, const BeadAnalysis&, double ft);
/// … and without.
std::string fn_force_text(const RuleContext&, const BeadAnalysis&, double fn);
std::string ft_force_text(const RuleContext&, const BeadAnalysis&, double ft);
/// The same as measures, in work units.
void measure_cost(const RuleContext&, const BeadAnalysis&, double fn, double ft, Draft&);

/// The positions of the list, cut at its gaps.
std::vector<std::vector<uint32_t>> list_pieces(const BeadAnalysis&);

/// Totals of the bead, each piece of list positions taken as a line of its own, with the limits that the
/// nodes have.
struct Forces {
    double fn = 0, ft = 0;
};
Forces forces_of_pieces(const BeadAnalysis&, const std::vector<std::vector<uint32_t>>& pieces);

/// A draft about the bead at position `i` of its list.
Draft draft_at_position(const RuleContext&, const BeadAnalysis&, const std::vector<Span>& places,
                        std::size_t i);

/// Beads whose cards are usable, with a group that is defined and not empty.
std::vector<const BeadAnalysis*> beads_with_nodes(const RuleContext&);
/// Those among them whose list order is the authors' own: only there rules about order have something to say.
std::vector<const BeadAnalysis*> beads_with_order(const RuleContext&);

/// Whether both act at some time.
bool windows_overlap(const Drawbead&, const Drawbead&);

/// Where a segment of a surface stands: its line in a list of segments, else its element's line.
Span segment_place(const RuleContext&, const Surface&, uint32_t segment);
/// "shell 5512", "solid 12", or "segment 3" for the third line of a list without elements.
std::string segment_name(const RuleContext&, const Surface&, uint32_t segment);
void add_segment(const RuleContext&, const Surface&, uint32_t segment, Entities&);

} // namespace drawbead
