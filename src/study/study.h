#pragma once
// What accuracy costs on one scene: the manual's law under many settings, each against the reference.
#include "study/order.h"
#include "study/reference.h"
#include "study/stepped_run.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace drawbead {

/// What an engineer uses, each as one relative error.
enum class Quantity : uint8_t {
    restraint, ///< total over time: largest norm of the difference at ends of steps, over the largest norm
    largest_restraint, ///< of the norm of the total
    normal,            ///< largest norm of the total normal force
    work,              ///< absorbed by the restraint
    dissipated,
    first_slip, ///< its time
    worst_node, ///< largest restraint of one node
};
inline constexpr std::size_t quantity_count = 7;
std::string_view name(Quantity);

using Errors = std::array<double, quantity_count>;

struct BeadValues {
    double largest_restraint = 0, normal = 0, work = 0, dissipated = 0, worst = 0;
    uint32_t worst_node = 0;
    std::optional<double> first_slip;
};

/// One run of all beads.
struct StudyRow {
    ManualSettings settings;
    std::vector<BeadValues> values; ///< by bead
    std::vector<Errors> errors;     ///< by bead
    Errors worst{};                 ///< of all beads
    double mean_restraint =
        0; ///< mean over time of the difference of restraints, over the largest; of all beads
    StudyCounts cost;
    bool at_floor = false;               ///< more of the same no longer helps: rounding
    bool on_front = false;               ///< no other is cheaper and no less accurate
    std::optional<double> median, least; ///< seconds of one run, of `repeats`

    double error() const;
};

/// How fast the error of a knob falls.
struct StudyOrder {
    std::string knob; ///< "steps", "line", "chord angle", "linear limits"
    std::string quantity;
    std::optional<double> expected; ///< empty: exact
    ObservedOrder observed;
    std::vector<double> size, error; ///< levels: of a step as a share of the run, of a part of a hop, radians
};

struct StudyOptions {
    Truth truth = Truth::line;
    std::vector<double> tolerances{1e-2, 1e-3, 1e-4};
    std::optional<ManualSettings> own;   ///< settings of the scene, studied too
    uint64_t most_evaluations = 100'000; ///< of one run
    unsigned repeats = 7;                ///< 0: no times
    unsigned threads = 1;
    std::function<void(std::size_t done, std::size_t all, const std::string& what)> progress;
};

struct StudyPick {
    double tolerance = 0;
    std::optional<std::size_t> row; ///< the cheapest within it
    std::size_t best = 0;           ///< the most accurate
};

struct Study {
    std::vector<ReferenceBead> reference; ///< by bead
    double reference_error = 0; ///< largest relative difference of two resolutions of it, of all quantities
    /// How far the other readings of what is true are from the chosen one, of all beads.
    std::vector<std::pair<Truth, Errors>> readings;
    std::vector<StudyRow> rows;
    std::vector<StudyPick> picks; ///< as StudyOptions::tolerances
    std::vector<StudyOrder> orders;
    Errors solver{};   ///< the solver's law at the scene's steps against the reference
    Errors evaluate{}; ///< the manual's as `evaluate` runs it, at the scene's steps
    std::vector<Errors> solver_of_bead, evaluate_of_bead;
    bool kinked = false; ///< a velocity jumps, a window opens or closes, or contact comes or goes at a blow
    bool rim = false;    ///< the surfaces of the scene are too small
    uint64_t points = 0; ///< nodes of all beads
    std::size_t stride = 1; ///< steps of the scene from one comparison of the laws' restraint to the next
};

/// `scene.time` are the scene's own steps; `steps` as integrate() gives them.
Study accuracy_study(const EvaluationScene&, const std::vector<MotionSteps>& steps, const StudyOptions&);

} // namespace drawbead
