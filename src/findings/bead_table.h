#pragma once
// One row per bead node and the totals of beads, tools and the deck: what `table` prints. Work units.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace drawbead {

/// A bead node as the solver meets it in the first cycle, beside the exact closest segment and the manual's
/// comparison.
struct BeadTableRow {
    int64_t node = 0;
    double s = 0;         ///< arc length
    double tributary = 0; ///< L of the solver: the half chord across the normal; where there is no segment,
                          ///< the half chord itself
    double fn_limit = 0, ft_limit = 0; ///< per length

    bool met = false;           ///< the node meets a segment; else what follows is not known
    std::array<int64_t, 4> n{}; ///< user ids in the solver's order; a triangle repeats its third
    double xi = 0, eta = 0;
    bool inside = false;
    double distance = 0, half_thickness = 0, penetration = 0;
    double stiffness = 0;
    double slope = 0;                 ///< of the segment
    std::optional<double> slope_read; ///< what the Engine takes; empty when it reads outside its array
    bool reset = false;               ///< warning 1040: every segment its own stiffness
    std::array<int64_t, 4> closest_n{};
    double closest_distance = 0;
    double manual_slope = 0; ///< Fn_first / DEPTH; the stiffness when DEPTH <= 0
    bool manual_reset = false;
    bool same_segment = false; ///< the solver takes the closest one
};

struct BeadForces {
    uint64_t nodes = 0;
    double fn = 0, ft = 0; ///< sum of limit times tributary length: force
};

struct BeadTotals {
    BeadForces force;
    double length = 0;
    uint64_t inside = 0;             ///< nodes over the blank
    uint64_t different_segments = 0; ///< nodes whose segment is not the closest one
    double largest_difference = 0;   ///< of the solver's distance against the closest one
    int64_t largest_difference_node = 0;
};

struct BeadTable {
    int64_t interface_id = 0;
    std::string title;
    std::string unknown;    ///< why nothing is said of segments; empty when something is
    std::string slope_unit; ///< of slope and slope_read: Fn / DEPTH or a stiffness
    std::string manual_slope_unit;
    std::vector<BeadTableRow> rows;
    BeadTotals totals;

    bool on_surface() const { return unknown.empty(); }
};

/// The bead nodes that one rigid body carries.
struct ToolTotals {
    std::optional<int64_t> rigid_body; ///< empty: nodes that none carries
    std::vector<int64_t> interfaces;
    BeadForces force;
};

struct DeckTable {
    std::string path;
    std::string length_unit, force_unit, force_per_length_unit; ///< "" where the deck does not name them
    std::vector<BeadTable> beads;
    std::vector<ToolTotals> tools; ///< by rigid body, those without one last
    BeadForces force;
    double length = 0;
    std::vector<std::string> warnings; ///< what could not be computed, and what is not certain
};

} // namespace drawbead
