#pragma once
// The points of a bead's line that carry force.
#include "force/evaluation.h"
#include "study/settings.h"

#include <functional>
#include <span>
#include <vector>

namespace drawbead {

/// A point of the line between two neighbours of the list, and the part of the line that it stands for. The
/// law of node `node` acts there, as if at all of its length, and a share of it counts: part over length.
struct LinePoint {
    uint32_t a = 0, b = 0; ///< places in the list; equal for a node itself
    double at = 0;         ///< from a to b, 0 to 1
    uint32_t node = 0;     ///< whose half of the hop it lies on
    double part = 0;       ///< of the hop, as a fraction of it; 0 for a node itself, which counts whole
    bool counts = true;    ///< false: only asked whether it slips; the ends of the line, where that begins
};

/// Whether the contact changes along a part of a hop so much that it is to be halved: given its ends as
/// fractions.
using PartChanges = std::function<bool(uint32_t a, double from, double to)>;

/// `count`: nodes of the bead. `changes` is asked by the adaptive rule only.
std::vector<LinePoint> line_points(std::size_t count, const LineRule&, const PartChanges& changes = {});

} // namespace drawbead
