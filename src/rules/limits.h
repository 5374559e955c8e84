#pragma once
// The numbers by which rules tell a finding from none. One line each: members of Limits, keys of
// configuration files, their JSON Schema, their page and their messages come from this table.
// `rules/limits_test` wants an example deck of the rule on which the limit changes something.
#include <span>
#include <string>
#include <string_view>

// LIMIT(rule, key, default, least, most, unit, text): `limits.RULE_key` in a rule, `RULE: {key: …}` in a
// file, with the underscores of the key as hyphens. A limit with a physical dimension names its unit in the
// key.
// clang-format off
#define DRAWBEAD_LIMITS(LIMIT)                                                                                 \
    LIMIT(CTX004, least_share, 0.01, 0, 1, "of DEPTH", "Distances that single precision rounds by no more than this are good enough.") \
    LIMIT(CTX005, least_share, 0.5, 0, 1000, "of the holding force", "Beads that push a tool with no more than this part of what holds it say nothing.") \
    LIMIT(CTX007, on_plane_steps, 0.05, 0, 0.5, "steps", "A bead that ends no farther than this from a plane of symmetry ends on it.") \
    LIMIT(ENG003, warning_share, 0.25, 0, 1, "of the total", "From this sum of jumps on it is a warning, below it a note.") \
    LIMIT(ENG010, least_share, 0.01, 0, 1, "of the total", "Less force than this at stake says nothing.")     \
    LIMIT(ENG010, warning_share, 0.05, 0, 1, "of the total", "Over this it is a warning, up to it a note.")    \
    LIMIT(KIN003, way_depths, 0.5, 0, 1e6, "DEPTH", "A bead that travels over the sheet by more than this, and by more than `way-elements`, moves sideways; ENG006 asks for as much.") \
    LIMIT(KIN003, way_elements, 0.1, 0, 1e6, "elements", "A bead that travels over the sheet by more than this, and by more than `way-depths`, moves sideways; ENG006 asks for as much.") \
    LIMIT(KIN006, lift_depths, 1e-3, 0, 100, "DEPTH", "A node that comes up by no more than this has not lifted off.") \
    LIMIT(LIN001, ratio, 3, 1, 1000, "usual steps", "A gap is longer than this times the usual step around it, and longer than `elements`.") \
    LIMIT(LIN001, elements, 2, 0, 1000, "elements", "A gap is longer than this many elements under it, where their size is known.") \
    LIMIT(LIN003, coincident_steps, 1e-6, 0, 0.5, "steps", "Nodes closer than this part of the median step stand at one place.") \
    LIMIT(LIN004, turn_degrees, 135, 90, 180, "degrees", "A bead that turns by more than this folds back.")    \
    LIMIT(LIN005, turn_degrees, 20, 0, 180, "degrees", "A bead that turns by more than this has a corner, up to the turn of LIN004.") \
    LIMIT(LIN006, end_steps, 1.5, 0, 100, "steps", "A line whose ends are no farther apart than this many steps is a loop; LIN007 takes it from here.") \
    LIMIT(LIN008, error_branches, 3, 0, 1000, "branches", "More branches than this are a warning: nodes strewn over an area were not meant as a line.") \
    LIMIT(LIN009, elements, 1.001, 0.001, 1000, "elements", "A step may be this many elements long.")          \
    LIMIT(LIN010, elements, 0.2, 0, 1000, "elements", "A step shorter than this part of the element is too fine.") \
    LIMIT(LIN011, ratio, 3, 1, 1000, "", "Neighbouring steps may differ by this factor.")                     \
    LIMIT(LIN014, half_width_depths, 1, 0, 100, "DEPTH", "Half the width of a bead; two beads overlap when they are closer than their half widths together.") \
    LIMIT(LIN014, touch_steps, 1e-3, 0, 1, "steps", "Beads closer than this part of the shorter median step cross or touch.") \
    LIMIT(PAR007, least_n_per_mm, 0.1, 0, 1e9, "N/mm", "Forces per length below this are implausible.")        \
    LIMIT(PAR007, most_n_per_mm, 5000, 0, 1e9, "N/mm", "Forces per length above this are implausible.")        \
    LIMIT(PAR007, slip_decades, 0.5, 0, 1, "powers of ten", "How close to a factor of 1000 or 1e6 against the other beads is taken for a wrong unit; 0: never.") \
    LIMIT(PAR007, zero_ratio, 1e-5, 0, 1, "of the other end", "A limit this much smaller than the one at the other end stands for zero.") \
    LIMIT(PAR008, least_thicknesses, 0.1, 0, 1e6, "thicknesses", "DEPTH below this many thicknesses of the sheet is implausible.") \
    LIMIT(PAR008, most_thicknesses, 30, 0, 1e6, "thicknesses", "DEPTH above this many thicknesses of the sheet is implausible.") \
    LIMIT(SRF001, reach_elements, 3, 0, 20, "elements", "How far from the line of the bead segments are judged; SRF002, SRF006 and SRF008 look as far.") \
    LIMIT(SRF001, minority_share, 0.1, 0, 0.5, "of the distances", "A patch of segments is judged when no more than this part of its bead stands on the other side.") \
    LIMIT(SRF004, in_surface_elements, 1e-3, 0, 1, "elements", "A bead node closer than this to the surface lies in it.") \
    LIMIT(SRF006, flat_area, 1e-9, 0, 0.1, "squares of the longest side", "A segment with no more area than this is degenerate.") \
    LIMIT(SRF007, misplaced_elements, 0.05, 0, 10, "elements", "The solver may place a bead node this far from its closest point.") \
    LIMIT(SRF009, uncovered_share, 0, 0, 1, "of the length", "Up to this part of a bead may stand over no segment.") \
    LIMIT(SRF010, ratio, 1.5, 1, 100, "", "A second layer counts when it is no farther than this times the distance of the closest one, and within `elements`.") \
    LIMIT(SRF010, elements, 2, 0, 100, "elements", "A second layer counts when it is no more than this many elements behind the closest one.") \
    LIMIT(SRF011, least_share, 1e-6, 0, 1, "of the thickness", "Thicknesses whose halves differ by no more than this are the same.") \
    LIMIT(SRF011, warning_share, 0.01, 0, 100, "of DEPTH", "From this shift of the ramp on it is a warning, below it a note.") \
    LIMIT(STB004, step_share, 0.9, 0.01, 1, "of the elements' step", "The scale factor that the run has in /DT: steps that stay stable at this part of the elements' step are good enough.") \
    LIMIT(STB005, speed_m_per_s, 0.1, 1e-6, 100, "m/s", "Speed of the sheet at which the viscous form is judged, here and by ENG007.") \
    LIMIT(STB005, info_share, 0.5, 0, 1, "of the restraint", "Over this part reached it is a note, up to it a warning.")
// clang-format on

namespace drawbead {

/// All limits, as rules read them. A new one is one line in the table above.
struct Limits {
#define DRAWBEAD_MEMBER(rule, key, value, least, most, unit, text) double rule##_##key = value;
    DRAWBEAD_LIMITS(DRAWBEAD_MEMBER)
#undef DRAWBEAD_MEMBER

    friend bool operator==(const Limits&, const Limits&) = default;
};

/// What is known of one limit. The range holds its ends.
struct LimitInfo {
    std::string_view rule, identifier; ///< "PAR007", "least_n_per_mm"
    double Limits::*value;
    double usual, least, most;
    std::string_view unit, text;

    std::string key() const; ///< "least-n-per-mm"
};
/// By rule, then in the order of the table.
std::span<const LimitInfo> limit_table();

} // namespace drawbead
