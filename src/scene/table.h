#pragma once
#include "findings/bead_table.h"
#include "scene/deck_contact.h"

#include <optional>

namespace drawbead {

/// Rows and totals of all drawbeads, or of the one with this id.
DeckTable table_of(const Model&, const DeckContact&, std::optional<InterfaceId> only = {});

} // namespace drawbead
