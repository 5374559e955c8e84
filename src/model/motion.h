#pragma once
// What a deck prescribes of the motion of the nodes that drawbeads look at: their own, those of their main
// surfaces, and the main nodes of rigid bodies.
#include "base/buffer.h"
#include "geometry/vec3.h"
#include "model/entities.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace drawbead {

/// A /FUNCT as written.
struct MotionFunction {
    int64_t id = 0;
    std::vector<double> x, y;
    std::string unusable; ///< why it cannot be evaluated; empty when it can
};

/// One option that holds or moves nodes, in work units.
struct MotionCondition {
    enum class Kind : uint8_t {
        fixed,            ///< /BCS
        velocity,         ///< /IMPVEL: scale · f(t / time_scale)
        displacement,     ///< /IMPDISP, likewise
        initial_velocity, ///< /INIVEL/TRA
        initial_unread,   ///< another /INIVEL, which is not read: `why`
        rigid_body,       ///< /RBODY: nodes move with `main`
        load,             ///< /CLOAD: a force on each node, scale · f(t / time_scale)
        asked,            ///< a move that the caller asks for: `function` is the index of its target
        unknown,          ///< acts on the nodes in a way that is not read
    };
    Kind kind = Kind::unknown;
    int64_t id = 0;
    BlockIndex block = 0;
    std::array<bool, 3> translation{}, rotation{}; ///< the directions that it prescribes
    uint32_t function = 0;                         ///< index into DeckMotion::functions
    double scale = 1, time_scale = 1;
    double t_start = 0, t_stop = 1e30;
    Vec3 velocity;          ///< the initial one
    NodeRow main = no_node; ///< of a rigid body
    int64_t sensor = 0;     ///< ignored: the condition counts as always on
    std::string why;        ///< of `unknown` and `initial_unread`: what is not read
};

/// Nodes that somebody else than the deck moves.
struct MotionTarget {
    enum class Kind : uint8_t { surface, part, node_group, bead, main_surface };
    Kind kind = Kind::surface;
    int64_t id = 0; ///< of the interface for `bead` and `main_surface`
};

/// Nodes with the same conditions share a class.
struct DeckMotion {
    std::vector<MotionFunction> functions;
    std::vector<MotionCondition> conditions; ///< in deck order
    std::vector<std::vector<uint32_t>>
        classes;              ///< conditions that act on a node; [0] is of nodes without any
    Buffer<uint32_t> of_node; ///< class by node row; empty unless Needs::motion
    /// By target: how many nodes of drawbeads and main surfaces it has; empty: it does not exist.
    std::vector<std::optional<std::size_t>> target_nodes;
};

} // namespace drawbead
