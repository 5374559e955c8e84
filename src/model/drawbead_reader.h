#pragma once
#include "model/entities.h"
#include "model/issue_log.h"
#include "model/option_index.h"

#include <vector>

namespace drawbead {

/// All /INTER/TYPE8 in deck order. Groups and surfaces are not yet looked up beyond their ids.
std::vector<Drawbead> read_drawbeads(const Deck&, const OptionIndex&, IssueLog&);

/// The block that gives nodes or segments under an id: a /GRNOD or /SURF, else a /SET.
std::optional<BlockIndex> find_node_group(const OptionIndex&, int64_t id);
std::optional<BlockIndex> find_surface(const OptionIndex&, int64_t id);

} // namespace drawbead
