#pragma once
// What holds or moves the bead nodes: rigid bodies, boundary conditions, imposed motion, links.
#include "model/demand.h"
#include "model/resolver.h"

#include <map>
#include <vector>

namespace drawbead {

/// An option that holds nodes.
struct Holder {
    Attachment attachment;
    std::optional<BlockIndex> group;
    std::vector<int64_t> nodes; ///< named on the card itself
};

/// In deck order. A group that does not exist is left out: its option is the solver's concern, not a
/// drawbead's.
std::vector<Holder> read_holders(const Deck&, const OptionIndex&, IssueLog&);

/// The attachments of each of `nodes` (by row), in deck order. Only these nodes are kept of any group.
std::map<uint32_t, std::vector<Attachment>> find_attachments(const std::vector<Holder>&, Resolver&,
                                                             const NodeSet& nodes);

} // namespace drawbead
