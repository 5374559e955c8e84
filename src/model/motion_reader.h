#pragma once
// Reads what prescribes the motion of nodes.
#include "model/motion.h"
#include "model/node_set.h"
#include "model/resolver.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace drawbead {

/// A condition and what it acts on.
struct GroupCondition {
    MotionCondition condition;
    std::optional<BlockIndex> group;
    std::optional<Member> member;               ///< of a target
    std::optional<uint32_t> bead, main_surface; ///< index into Model::groups(), Model::surfaces()
    std::vector<int64_t> nodes;                 ///< named on the card itself
};

struct MotionOptions {
    std::vector<MotionFunction> functions;
    std::vector<GroupCondition> conditions;
    std::size_t targets = 0; ///< then the conditions are one per target that exists
};

/// In deck order. Only functions in use are read.
MotionOptions read_motion_options(const Deck&, const OptionIndex&, IssueLog&);

/// The same for targets instead of the deck's own conditions.
MotionOptions target_options(const OptionIndex&, std::span<const MotionTarget>, std::span<const Drawbead>);
/// Adds what presses the tools: rigid bodies and loads.
void add_loads(const Deck&, const OptionIndex&, IssueLog&, MotionOptions&);

/// Finds out which conditions act on each of `nodes`, on those that `add_surfaces` adds to a set, and on the
/// main nodes of rigid bodies that hold some. Where lists of nodes name none but `nodes`, as for beads that a
/// deck only holds in place, `add_surfaces` is not called.
DeckMotion find_motion(MotionOptions, Resolver&, const NodeSet& nodes,
                       const std::function<void(NodeSet&)>& add_surfaces, std::size_t node_count,
                       std::span<const NodeGroup>, std::span<const Surface>);

} // namespace drawbead
