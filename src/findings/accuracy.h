#pragma once
// What a study of accuracy against cost found, as values that reports print.
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace drawbead {

/// Relative errors by quantity, in the order of AccuracyReport::quantities.
using AccuracyErrors = std::vector<double>;

/// What one bead did. Forces and energies in the units of the report.
struct AccuracyValues {
    double largest_restraint = 0, normal = 0, work = 0, dissipated = 0, worst = 0;
    int64_t worst_node = 0; ///< user id
    std::optional<double> first_slip;
};

/// One setting.
struct AccuracyRow {
    std::vector<std::pair<std::string, std::string>> settings; ///< key and word, as in a scene
    std::string brief, yaml;
    std::vector<AccuracyValues> values; ///< by bead
    std::vector<AccuracyErrors> errors; ///< by bead
    AccuracyErrors worst;               ///< of all beads
    double error = 0;                   ///< the largest of them
    uint64_t evaluations = 0, searches = 0, follows = 0, projections = 0, instants = 0;
    bool at_floor = false, on_front = false;
    std::optional<double> median, least; ///< seconds
};

struct AccuracyPick {
    double tolerance = 0;
    bool asked = false;             ///< by --within
    std::optional<std::size_t> row; ///< empty: nothing is within it
    std::size_t best = 0;
};

struct AccuracyOrder {
    std::string knob, quantity;
    std::optional<double> expected; ///< empty: exact
    std::optional<double> observed;
    std::string verdict;
    bool below = false;
    std::size_t first = 0, count = 0; ///< levels fitted
    std::vector<double> size, error;
};

struct AccuracyBead {
    int64_t id = 0;
    std::string title;
    uint64_t nodes = 0;
    AccuracyValues reference;
    std::optional<double> first_contact;
    AccuracyErrors solver, evaluate; ///< how far these are from the reference
};

struct AccuracyReport {
    std::string deck, scene;
    std::string force_unit, length_unit, time_unit, energy_unit;
    double begin = 0, end = 0;
    uint64_t scene_steps = 0;
    std::string reading;                 ///< of what is true
    std::vector<std::string> quantities; ///< names
    std::vector<std::string> keys;       ///< the same for JSON and CSV
    std::vector<AccuracyBead> beads;
    double reference_error = 0;
    uint64_t reference_evaluations = 0;
    std::vector<std::pair<std::string, AccuracyErrors>> readings; ///< how far the others are from `reading`
    std::vector<AccuracyRow> rows;
    std::vector<AccuracyPick> picks; ///< from coarse to fine
    std::vector<AccuracyOrder> orders;
    AccuracyErrors solver, evaluate;
    double largest_restraint = 0; ///< of one bead: a scale for the tolerances
    double known_to = 0.1;        ///< share to which Ft itself is known
    bool kinked = false;
    unsigned repeats = 0;
    std::vector<std::pair<int64_t, std::string>> left_out;
    std::vector<std::string> notes;

    bool orders_hold() const {
        for (const AccuracyOrder& order : orders)
            if (order.below) return false;
        return true;
    }
};

} // namespace drawbead
