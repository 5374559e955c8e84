#pragma once
#include "model/model.h"

#include <vector>

namespace drawbead {

/// By Model::drawbeads(): the place of each among the interfaces of all types in input order, from 1. The
/// solver's `nin`.
std::vector<int64_t> interface_ranks(const Model&);

} // namespace drawbead
