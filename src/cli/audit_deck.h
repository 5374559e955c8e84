#pragma once
// What an audit needs of a deck, from the model.
#include "base/result.h"
#include "force/audit.h"
#include "model/model.h"

namespace drawbead {

inline constexpr Needs audit_needs =
    Needs::counts | Needs::coordinates | Needs::blank_elements | Needs::element_thickness;

/// All interfaces in input order. An error when one lacks its group or surface, or has a type of these that
/// cannot be expanded.
Result<AuditDeck> audit_deck(const Model&, unsigned threads);

} // namespace drawbead
