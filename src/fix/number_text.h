#pragma once
#include "deck/deck.h"
#include "model/entities.h"

#include <optional>
#include <string>

namespace drawbead {

/// The shortest text that reads back as the same number, with a point or an exponent; empty when it does not
/// fit.
std::string real_text(double value, uint32_t width = 20);

/// A value in work units as a cell of `block` holds it, in the cell's own unit: read back and converted it
/// gives the value again where any text of this width does, else the nearest one. Empty when the unit is
/// unknown or it does not fit.
std::string cell_text(const Deck&, const Block&, Dimension, double value, uint32_t width = 20);

} // namespace drawbead
