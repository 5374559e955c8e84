#pragma once
// What an evaluation found, as values that reports print: resolved ids, units by name.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace drawbead {

/// One effect of one bead under one law.
struct PlannedEffect {
    std::string name, what, verdict, reason;
    bool forced = false;            ///< computed though not needed
    uint64_t estimated = 0;         ///< how often its stage does its work
    std::optional<uint64_t> actual; ///< and did; empty in a plan
};

/// A largest value and when.
struct Peak {
    double value = 0, time = 0;
};

struct EvaluatedLaw {
    std::string law;
    Peak force, normal, restraint;        ///< norms of the totals on the blank
    std::array<double, 3> force_vector{}; ///< at the time of `force`
    std::array<double, 3> couple{};       ///< Σ (x_p − x_i) × F then
    Peak couple_norm;
    Peak normal_sum, restraint_sum; ///< Σ of magnitudes
    std::array<double, 3> impulse{};
    double normal_work = 0, restraint_work = 0, tool_work = 0, stored = 0, dissipated = 0, created = 0;
    std::optional<double> first_contact, first_plateau, first_slip;
    uint64_t in_contact = 0, on_plateau = 0, ever_in_contact = 0; ///< nodes; the first two at most at a time
    double normal_capacity = 0, restraint_capacity = 0;           ///< Σ limit · L at the start
    int64_t worst_node = 0;
    Peak worst; ///< largest restraint of one node
    std::vector<PlannedEffect> effects;

    double normal_share() const { return normal_capacity > 0 ? normal_sum.value / normal_capacity : 0; }
    double restraint_share() const {
        return restraint_capacity > 0 ? restraint_sum.value / restraint_capacity : 0;
    }
};

/// How far the two laws are apart: norms of the difference of their totals.
struct LawDifference {
    Peak largest;
    double mean = 0;
    double scale = 0; ///< the manual's largest total, else the solver's

    double percent(double difference) const { return scale > 0 ? 100 * difference / scale : 0; }
};

struct EvaluatedBead {
    int64_t id = 0;
    std::string title;
    int iform = 2;
    uint64_t nodes = 0;
    std::optional<int64_t> tool; ///< rigid body that holds the bead
    std::vector<EvaluatedLaw> laws;
    std::optional<LawDifference> restraint_difference, normal_difference;
};

/// Beads that one rigid body holds: what its holding force must carry.
struct EvaluatedTool {
    std::optional<int64_t> id; ///< empty: beads that no rigid body holds
    std::vector<int64_t> interfaces;
    struct Sum {
        std::string law;
        Peak normal, restraint; ///< norms of the sums of totals
        std::array<double, 3> normal_vector{};
        /// What holds the tool down against it at that time; empty: no such force is in the deck.
        std::optional<double> holding;

        double share() const { return holding && *holding > 0 ? normal.value / *holding : 0; }
    };
    std::vector<Sum> sums;
};

struct EvaluationReport {
    std::string deck, scene; ///< scene: empty when the deck alone was evaluated
    std::string force_unit, length_unit, time_unit, energy_unit, impulse_unit;
    uint64_t steps = 0;
    double begin = 0, end = 0;
    std::vector<EvaluatedBead> beads;
    std::vector<EvaluatedTool> tools;
    std::vector<std::pair<int64_t, std::string>> left_out;
    std::vector<std::string> notes;
};

/// One bead at one output step, for CSV and VTU.
struct SampledNode {
    int64_t id = 0;
    uint64_t place = 0; ///< in the list, from 1
    std::array<int64_t, 4> segment{};
    bool found = false, inside = false;
    double xi = 0, eta = 0, distance = 0, penetration = 0;
    std::array<double, 3> x{}, normal{}, restraint{};
};
struct SampledBead {
    std::string law;
    uint64_t step = 0;
    double time = 0;
    uint64_t rank = 0; ///< of the interface in the deck, from 1
    int64_t interface_id = 0;
    std::vector<SampledNode> nodes;
};

} // namespace drawbead
