#pragma once
// What a trace says twice must agree: nodes that several rows see, constants over the cycles, positions and
// velocities, time and its steps.
#include "force/comparison.h"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace drawbead {

class RecordCheck {
public:
    explicit RecordCheck(const AuditDeck& deck) : deck_(deck), beads_(deck.interfaces.size()) {}

    /// Rows of one cycle of interface number `which` (from 0), cycles ascending. An error when the record
    /// does not begin where the time window opens.
    Result<void> bead_cycle(std::size_t which, std::span<const TraceRow> rows, const Trace&);

    std::vector<const Comparison*> all() const {
        return {&position_, &velocity_, &mass_,   &mass_over_run_, &deck_mass_, &segment_,
                &slope_,    &time_,     &motion_, &translation_,   &bead_};
    }

private:
    struct Node {
        int64_t cycle = -1;
        Vec3 x, v;
        double mass = 0;
    };
    struct Bead {
        std::optional<int64_t> cycle;
        double time = 0;
        std::vector<Vec3> x;
        std::vector<double> slope;
    };
    struct Constants {
        double stiffness = 0, half_thickness = 0, slope = 0;
    };
    const AuditDeck& deck_;
    std::map<std::pair<std::size_t, int64_t>, Node> nodes_; ///< by surface and user id
    std::vector<Bead> beads_;
    std::map<std::pair<std::size_t, std::array<uint32_t, 4>>, Constants>
        constants_; ///< by interface, segment
    Comparison position_{"blank positions, seen by several rows", Agreement::same},
        velocity_{"blank velocities, seen by several rows", Agreement::same},
        mass_{"nodal masses, seen by several rows", Agreement::same},
        mass_over_run_{"nodal masses, over the run", Agreement::pattern},
        deck_mass_{"nodal masses by the deck", Agreement::pattern},
        segment_{"constants of a segment, over the run", Agreement::same},
        slope_{"slope read, over the run", Agreement::pattern},
        time_{"time steps, between recorded times", Agreement::same},
        motion_{"blank positions as the sum of v dt", Agreement::pattern},
        translation_{"blank moving as one", Agreement::pattern},
        bead_{"bead moving as one", Agreement::pattern};

    void see_nodes(std::size_t which, const TraceRow& row);
    void see_constants(std::size_t which, std::size_t i, const TraceRow& row);
};

} // namespace drawbead
