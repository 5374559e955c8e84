#pragma once
// The stiffness of the sheet as rules see it: the ramp of a bead's normal force over its segments.
#include "contact/blank_stiffness.h"
#include "contact/segment_mesh.h"
#include "rules/rule.h"
#include "scene/deck_contact.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace drawbead {

struct BeadAnalysis;

/// The first cycle of the bead; nullptr when it has no nodes or no segments. Needs analysis_contact.
const InterfaceContact* first_cycle(const RuleContext&, const BeadAnalysis&);

/// Stiffness of the segments of the bead's surface; nullptr when it has none, or when a modulus or thickness
/// behind it is not known for sure. Needs analysis_contact.
const SurfaceStiffness* known_stiffness(const RuleContext&, const BeadAnalysis&);

/// Masses of the nodes of a part of a surface, from the shells of the surface around them. What a segment
/// gives to its nodes is worked out once. Needs the thickness of elements.
class NodeMasses {
public:
    NodeMasses(const Model& model, const Surface& surface, const NearMesh& near)
        : model_(model), surface_(surface), near_(near), share_(near.segment.size(), not_yet) {}

    /// Of a local node; empty where something around it is no shell or not known.
    std::optional<double> of(uint32_t local);

private:
    static constexpr double not_yet = -1, not_known = -2;

    const Model& model_;
    const Surface& surface_;
    const NearMesh& near_;
    std::vector<double> share_; ///< by local segment

    double share_of(uint32_t segment) const;
};

/// How the normal force of a bead grows, from the segments that the solver starts with.
struct BeadRamp {
    struct Node {
        double k = 0;               ///< of the segment
        double slope = 0;           ///< of the segment
        std::optional<double> read; ///< what the node reads instead; empty past the end of the table
    };
    SlopeChoice slope;
    double smallest_k = 0;  ///< over the surface: what the Starter compares Fn/DEPTH with
    std::vector<Node> node; ///< by place in the bead's list

    /// Normal force of the whole bead at the end of the ramp, with the slopes of the segments.
    double end_force(const BeadAnalysis&) const;
};

/// Empty when the bead has no nodes over a surface of known stiffness. Needs analysis_contact.
std::optional<BeadRamp> ramp_of(const RuleContext&, const BeadAnalysis&);

/// Bead nodes that read a slope which is not their segment's, when that can happen: after a reset over more
/// than one stiffness, or with more nodes than segments.
struct MisreadSlopes {
    bool mixed = false;            ///< a reset over more than one stiffness
    std::vector<std::size_t> node; ///< places in the list
    std::size_t beyond_count = 0;  ///< of them, that read past the end of the table
    double beyond = 0;             ///< their normal force
    double difference = 0;         ///< of the others at the end of the ramp, taken absolutely
};
/// Empty when it cannot happen. Needs analysis_contact.
std::optional<MisreadSlopes> misread_slopes(const RuleContext&, const BeadAnalysis&);

} // namespace drawbead
