#pragma once
// Which segments of a surface have to be turned so that they face its beads.
#include "model/entities.h"

#include <cstdint>
#include <span>
#include <vector>

namespace drawbead {

/// How a bead judged one segment of its surface.
struct SegmentVote {
    uint32_t segment = 0; ///< index in the surface
    bool away = false;
    bool start = false; ///< it lies under a bead node: such votes decide alone where there are any
};

/// What one bead says of its surface. No votes: its side is not known.
struct BeadVotes {
    InterfaceId bead = 0;
    BlockIndex block = 0; ///< of the interface
    std::vector<SegmentVote> votes;
};

/// Beads that want the same segments turned.
struct TurnGroup {
    std::vector<uint32_t> beads;    ///< indices into the votes
    std::vector<uint32_t> segments; ///< to be turned, ascending
};

struct SegmentTurns {
    std::vector<TurnGroup> groups;   ///< one with nothing to turn first, if there is one
    std::vector<uint32_t> undecided; ///< beads that say nothing, or that contradict themselves
};

/// Segments that hang together across edges look to one side of the sheet, whatever the order of their nodes:
/// each such island takes the side that its beads are on, as a whole. Islands that no bead judges stay as
/// they are, and so do those of which no two sides can be told (a Moebius strip). An edge of three and more
/// segments joins nothing; segments that the Starter turns (solid-backed) take no part.
SegmentTurns find_turns(const SegmentList&, uint32_t nodes, std::span<const BeadVotes>);

} // namespace drawbead
