#pragma once
// What a study measures against: the manual's law once more, by another way. Nothing here is shared with the
// stepped path but the scene: motions, feet, law, slider and sums are formulas of their own in extended
// precision. Reversals, the begin and end of contact, of the ramp and of slip, and changes of segment are
// located in time; along the line the quadrature adapts.
#include "force/evaluation.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace drawbead {

/// What counts as true.
enum class Truth : uint8_t {
    line,  ///< the integral of force per length along the straight hops between the nodes
    nodes, ///< the sum over the nodes, each with its chord ½(x_{i+1} − x_{i−1})
    arc,   ///< the sum over the nodes, each with half its hops
};
std::string_view name(Truth);

struct ReferenceOptions {
    Truth truth = Truth::line;
    double line_tolerance = 5e-6; ///< of one part of a hop, as a share of the bead's limits
    unsigned threads = 1;
};

/// One bead. Forces on the blank.
struct ReferenceBead {
    std::vector<double> time;                         ///< as asked for, with the corners of the motion
    std::vector<Vec3> normal, restraint;              ///< totals then
    double normal_largest = 0, restraint_largest = 0; ///< norms
    double absorbed = 0, stored = 0; ///< work of the restraint, what of it is left in the springs
    double gross = 0;                ///< Σ∫ |q v_u| dt: a scale for work
    std::optional<double> first_contact, first_slip;
    double worst = 0; ///< largest restraint of a node, or of its part of the line
    uint32_t worst_node = 0;
    uint64_t evaluations = 0; ///< of the law at a point
    bool at_a_blow = false;   ///< contact came or went with a part of the limit, not from nothing

    double dissipated() const { return absorbed - stored; }
};

/// `times` ascending, from the begin to the end of the run, both among them. Events inside an interval are
/// located, everything else is smooth in it: the error falls with the fourth power of the interval, and with
/// the square where a limit changes while the slider gives way.
ReferenceBead reference_of(const EvaluationScene&, std::size_t bead, std::span<const double> times,
                           const ReferenceOptions&);

} // namespace drawbead
