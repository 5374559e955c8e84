#pragma once
// /TRANSFORM: what moves node coordinates before anything looks at them.
#include "geometry/vec3.h"
#include "model/demand.h"
#include "model/resolver.h"

#include <vector>

namespace drawbead {

/// x ↦ matrix·x + shift on the nodes of a group or of a submodel.
struct Transform {
    BlockIndex block = 0;
    Vec3 rows[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Vec3 shift;
    int64_t group = 0, submodel = 0; ///< one of them; both 0: acts on nothing
    int64_t node1 = 0, node2 = 0;    ///< nodes that give the vector, axis, normal or centre, when not 0
    enum class Type : uint8_t { translation, rotation, symmetry, scaling, matrix } type = Type::matrix;
    Vec3 first, second; ///< vector or points as written
    double angle = 0;   ///< degrees

    Vec3 apply(Vec3 p) const { return Vec3{dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)} + shift; }
};

/// In deck order. Types that cannot be worked out are reported and left out.
std::vector<Transform> read_transforms(const Deck&, IssueLog&);

/// Completes matrix and shift from the positions that the transformation's nodes have now.
void complete(Transform&, const NodeTable&);

/// Moves coordinates by all transformations in order. Their node groups are expanded first, as the solver
/// builds groups before it moves nodes.
void apply_transforms(std::vector<Transform>, const Deck&, const OptionIndex&, const PartPicker&, Resolver&,
                      unsigned threads, NodeTable&);

} // namespace drawbead
