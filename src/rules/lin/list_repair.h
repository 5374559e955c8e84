#pragma once
// Repairs of bead lists: in the list where it stands, or in a node group of the interface's own where others
// use the old one; and beads cut into several.
#include "rules/analysis.h"
#include "rules/rule.h"

#include <cstdint>
#include <string>
#include <vector>

namespace drawbead {

/// What the fixes of this file look at, beside the needs of their checks.
inline constexpr Needs needs_list_users = Needs::surface_users;

/// The analysis of a draft's interface; nullptr when there is none.
const BeadAnalysis* analysed_bead(const RuleContext&, const Draft&);

/// Whether the limits are the same at all nodes.
bool limits_are_constant(const Drawbead&);

/// The walk along a bead as a permutation of its list: nodes listed twice, and nodes at one place, stay
/// behind the first of them. `check`: of that list.
std::vector<uint32_t> whole_walk(const LineCheck& check);
/// Whether listing the nodes in the order of `check.walk` is no guess: one walk only, and either end may be
/// the first one, or the first node of the list is an end of a line in one piece.
bool walk_is_safe(const LineCheck& check, const Drawbead&);

/// Whether every id in the bead's list is a node: the hop over one that is not is no gap, and no step of the
/// line that was meant.
bool list_is_whole(const BeadAnalysis&);
inline constexpr const char* missing_nodes_first =
    "the list names nodes that do not exist: what is meant in their place comes first";

/// Rules that keep quiet, or look at something else, while a list is not the line that was meant.
std::vector<std::string_view> hidden_by_list();

/// A list for a group that the solver sorts: positions in NodeGroup::nodes.
struct SortedOrder {
    std::vector<uint32_t> order; ///< empty where no order can be found
    bool safe = false;           ///< the order in the file is a walk, or either end may be the first one
};
SortedOrder order_of_sorted(const BeadAnalysis&);

/// Gives the bead the list of these positions of its list (a permutation, or a part of it): in its group when
/// that hurts no other user, else in a new group. Adds to `fix.changes`. False when it failed.
bool set_list(const RuleContext&, const BeadAnalysis&, const std::vector<uint32_t>& order, FixPlanner&,
              Fix& fix);

/// Puts a new /GRNOD/NODENS beside the bead's group, or beside the interface where the ids there allow no
/// other place, and gives its global id; 0 when it failed.
int64_t add_ordered_group(const RuleContext&, const BeadAnalysis&, const std::vector<NodeRow>& nodes,
                          const std::string& title, FixPlanner&);
/// Makes the interface use a node group. False when it failed.
bool use_group(const RuleContext&, const BeadAnalysis&, int64_t group, CellEditor&);

/// A node group that the solver sorts becomes an ordered one, in place when nobody else uses the list, else
/// as a new one.
bool make_ordered(const RuleContext&, const BeadAnalysis&, const SortedOrder&, FixPlanner&, Fix& fix);

/// Cuts the bead into several; `pieces`: positions of the list, each along the bead. The first one keeps the
/// interface, the others get one each, with the limits that their ends have now. `limits`: of each piece, in
/// the place of these. /TH/INTER and /INTER/SUB follow.
struct EndLimits {
    double fn_first = 0, fn_last = 0, ft_first = 0, ft_last = 0;
};
bool split_bead(const RuleContext&, const BeadAnalysis&, const std::vector<std::vector<uint32_t>>& pieces,
                const std::vector<EndLimits>& limits, FixPlanner&, Fix& fix);
/// The limits that the ends of each piece have now.
std::vector<EndLimits> present_limits(const BeadAnalysis&, const std::vector<std::vector<uint32_t>>& pieces);
/// Whether every piece has two different nodes at least.
bool pieces_are_lines(const BeadAnalysis&, const std::vector<std::vector<uint32_t>>& pieces);
/// The list cut at nodes that end one piece and begin the next.
std::vector<std::vector<uint32_t>> cut_at_nodes(const BeadAnalysis&, const std::vector<LineTurn>&);

/// A number that is never 0: 1e-6 of `other` in the place of 0, which would mean something else there.
double never_zero(double value, double other);

/// Takes entries out of a list; lines that have nothing else go, too. `all`: the entries of the list.
void drop_entries(const Deck&, BlockIndex, const std::vector<ListedNode>& all,
                  const std::vector<const ListedNode*>& dropped, FixPlanner&);
/// The same for the list of a node group; `dropped` points into its entries.
void drop_listed(const Deck&, const NodeGroup&, const std::vector<const ListedNode*>& dropped, FixPlanner&);
/// Puts an id behind the last of a list of ids in columns; `first_cell`: 1 in a clause of a set.
void append_entry(const Deck&, BlockIndex, const Span& last_entry, uint32_t first_cell, int64_t written,
                  FixPlanner&);

/// Blocks of time histories of interfaces.
bool is_interface_history(const Block&);
/// The ids in them, as written, with their cells.
std::vector<ListedNode> listed_interfaces(const Deck&, BlockIndex);

} // namespace drawbead
