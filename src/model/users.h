#pragma once
#include "model/entities.h"
#include "model/option_index.h"

#include <vector>

namespace drawbead {

/// Fills `users` of groups and surfaces: the options other than /INTER/TYPE8 that name them. An option whose
/// cards are not known counts when one of its cells equals the id, so that nothing in use is ever taken for
/// free.
void find_users(const Deck&, const OptionIndex&, std::vector<NodeGroup>&, std::vector<Surface>&);

} // namespace drawbead
