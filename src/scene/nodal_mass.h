#pragma once
// Masses and thicknesses of the blank as its elements give them.
#include "model/model.h"

#include <vector>

namespace drawbead {

/// Masses of all nodes as the solver gives shells and bricks theirs (observed on solver runs); NaN where the
/// tool does not know an element's share. Other things may add mass, so these are a pattern and no law.
std::vector<double> nodal_masses(const Model&);

/// Thickness behind a segment: on the element's card, else the property's; 0 for a solid.
double segment_thickness(const Model&, const Segment&);

} // namespace drawbead
