#pragma once
// What an evaluation works on: beads, main surfaces and their prescribed motion, without a deck.
#include "contact/blank_stiffness.h"
#include "contact/segment_mesh.h"
#include "contact/solver_search.h"
#include "force/motion.h"
#include "force/node_force.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace drawbead {

enum class Law : uint8_t { solver, manual };
std::string_view name(Law);

/// A main surface near its beads. All lengths, forces and times in one consistent unit system.
struct EvaluationSurface {
    int64_t id = 0;
    NearMesh mesh;
    std::vector<uint32_t> motion;            ///< by local node: index into EvaluationScene::motions
    std::vector<double> mass;                ///< by local node
    std::vector<SegmentStiffness> stiffness; ///< by local segment
    std::vector<double> thickness; ///< by local segment: the element's, else the property's; 0: solid
};

struct EvaluationBead {
    int64_t id = 0;
    std::string title;
    int iform = 2;
    BeadLaw<double> law;
    double t_start = 0, t_stop = 1e30;
    std::vector<int64_t> nodes;   ///< user ids in list order
    std::vector<Vec3> x;          ///< start positions
    std::vector<uint32_t> motion; ///< by node
    std::size_t surface = 0;      ///< index into EvaluationScene::surfaces
    std::vector<Track> track;     ///< by node, before the first cycle
    SlopeChoice slope;
    /// By node: what the solver reads instead of the segment's slope; empty: past the end of its table, then
    /// the segment's own is taken.
    std::vector<std::optional<double>> slope_read;
};

struct EvaluationScene {
    std::vector<Motion> motions;
    std::vector<EvaluationSurface> surfaces;
    std::vector<EvaluationBead> beads;
    std::vector<double> time, dt; ///< dt[n] from time[n−1] to time[n]; dt[0] = 0
};

/// One bead at one sampled time.
struct StepTotals {
    Vec3 normal, restraint; ///< sums over nodes, on the blank
    Vec3 couple; ///< Σ (x_p − x_i) × F: of the forces at the feet and their reactions at the nodes
    double normal_sum = 0;    ///< Σ |N|
    double restraint_sum = 0; ///< Σ of magnitudes
    uint32_t in_contact = 0, on_plateau = 0;

    Vec3 total() const { return normal + restraint; }
};

/// One node at one sampled time; only of nodes whose contact was looked for.
struct NodeSample {
    uint32_t node = 0;    ///< place in the list
    uint32_t segment = 0; ///< local number in the surface's mesh
    bool found = false;   ///< a segment belongs to it
    bool inside = false;  ///< solver: `xface`; manual: not beyond a free edge
    double xi = 0, eta = 0, distance = 0, penetration = 0;
    Vec3 x{}, normal{}, restraint{}; ///< position of the node; forces on the blank
};

/// Work over the run, in force times length.
struct BeadEnergy {
    double normal_work = 0;    ///< of the normal force on the blank
    double restraint_work = 0; ///< of the restraint on the blank; negative: it brakes
    double tool_work = 0;      ///< of all forces on the bead
    double stored = 0;         ///< in the sticking springs at the end
    double dissipated = 0;     ///< over the steps that take up more than is stored
    double created = 0;        ///< over the others: energy from nowhere (the solver's law only)
};

/// What one bead did under one law.
struct BeadHistory {
    std::vector<StepTotals> steps; ///< as EvaluationScene::time
    BeadEnergy energy;
    Vec3 impulse; ///< of the total on the blank, by the trapezium rule
    std::optional<double> first_contact, first_plateau, first_slip; ///< times
    uint32_t ever_in_contact = 0;                                   ///< nodes
    double normal_capacity = 0, restraint_capacity = 0;             ///< Σ limit · L at the start
    double worst_restraint = 0;                                     ///< largest of any node
    uint32_t worst_node = 0; ///< its place in the list, the lowest on ties
    double worst_time = 0;
};

} // namespace drawbead
