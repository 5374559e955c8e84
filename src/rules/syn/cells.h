#pragma once
// Cells that cannot be used, from the interface cards and from what the model's readers met.
#include "rules/rule.h"

#include <functional>

namespace drawbead {

/// A cell of one kind of trouble, once per block: the first of them, and how many there are.
struct CellTrouble {
    ReadIssue::Kind kind;
    std::vector<Span> places;
    uint64_t count = 0;
    std::string text;            ///< of the first cell
    std::string where;           ///< "card 2 of bead 1", "/NODE"
    bool concerns_beads = false; ///< an interface, group or surface
    std::optional<InterfaceId> interface_id;
};

/// In the order of their first places. Cards whose lines are shifted are left out: their values mean nothing.
std::vector<CellTrouble> cell_troubles(const RuleContext&, std::span<const ReadIssue::Kind> kinds);

} // namespace drawbead
