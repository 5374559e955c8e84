#pragma once
// Parts, properties and materials: what a blank's stiffness and thickness come from.
#include "model/entities.h"
#include "model/issue_log.h"
#include "model/option_index.h"

#include <vector>

namespace drawbead {

/// All in deck order; values in work units.
std::vector<Part> read_parts(const Deck&, const OptionIndex&, IssueLog&);
std::vector<Property> read_properties(const Deck&, const OptionIndex&, IssueLog&);
std::vector<Material> read_materials(const Deck&, const OptionIndex&, IssueLog&);

/// Whether the content of a block was replaced by unreadable text.
bool is_encrypted(const Deck&, const Block&);

} // namespace drawbead
