#pragma once
// What presses a tool: the /CLOAD of a deck on the main node of a rigid body.
#include "force/time_table.h"
#include "geometry/vec3.h"
#include "model/model.h"

#include <optional>
#include <string>
#include <vector>

namespace drawbead {

struct HoldingForce {
    struct Term {
        std::size_t axis = 0;
        double scale = 1, time_scale = 1;
        TimeTable table;
    };
    std::vector<Term> terms;
    std::vector<BlockIndex> blocks; ///< of the options, in deck order
    std::string unknown;            ///< why a part of it is not known; empty when all is

    Vec3 at(double t) const;
    /// Times at which one of its functions bends, ascending.
    std::vector<double> times() const;
};

/// Empty when no load acts on the body's main node. Needs Needs::motion.
std::optional<HoldingForce> holding_force(const Model&, int64_t rigid_body);

} // namespace drawbead
