#pragma once
// The stiffness of the sheet as rules see it: k of the segments, and the ramp of a bead's normal force over
// them.
#include "contact/blank_stiffness.h"
#include "model/model.h"
#include "rules/rule.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace drawbead {

struct BeadAnalysis;

/// One main surface.
struct SurfaceBlank {
    bool known = false; ///< every element's modulus and thickness could be read
    double smallest_k = std::numeric_limits<double>::infinity();  ///< what the Starter compares Fn/DEPTH with
    double least_own_k = std::numeric_limits<double>::infinity(); ///< of the segments; a solid under a shell
                                                                  ///< enters smallest_k alone
    double largest_k = 0;
    /// k of the first segments in the solver's storage order, one per node of the longest bead; empty when
    /// all segments have one k.
    std::vector<double> in_storage_order;

    bool mixed() const { return largest_k > least_own_k * (1 + 1e-9); }
};

/// `most_nodes`: of the beads over the surface.
SurfaceBlank blank_of(const Model&, const Surface&, std::size_t most_nodes);

/// Stiffness and half thickness of one segment; empty where they are not known.
std::optional<SegmentStiffness> stiffness_of(const Model&, const Surface&, uint32_t segment);

/// How the normal force of a bead grows, from the segments that are closest to its nodes.
struct BeadRamp {
    struct Node {
        double k = 0;               ///< of the segment
        double slope = 0;           ///< of the segment
        std::optional<double> read; ///< what the node reads instead; empty past the end of the table
    };
    SlopeChoice slope;
    std::vector<Node> node; ///< by place in the bead's list

    /// Normal force of the whole bead at the end of the ramp, with the slopes of the segments.
    double end_force(const BeadAnalysis&) const;
};

/// Bead nodes that read a slope which is not their segment's, when that can happen: after a reset over more
/// than one stiffness, or with more nodes than segments.
struct MisreadSlopes {
    bool mixed = false;            ///< a reset over more than one stiffness
    std::vector<std::size_t> node; ///< places in the list
    std::size_t beyond_count = 0;  ///< of them, that read past the end of the table
    double beyond = 0;             ///< their normal force
    double difference = 0;         ///< of the others at the end of the ramp, taken absolutely
};
/// Empty when it cannot happen.
std::optional<MisreadSlopes> misread_slopes(const RuleContext&, const BeadAnalysis&);

/// Empty when the bead has no nodes over a surface of known stiffness. Needs analysis_blank.
std::optional<BeadRamp> ramp_of(const RuleContext&, const BeadAnalysis&);

} // namespace drawbead
