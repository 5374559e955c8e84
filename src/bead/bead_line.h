#pragma once
// The bead as a line: arc length, hops, tributary vectors, and limits along it. Only positions come in, in
// list order.
#include "geometry/vec3.h"

#include <cstddef>
#include <span>
#include <vector>

namespace drawbead {

/// What the solver makes of an ordered list of n positions (observed on solver runs). All lengths in the unit
/// of x.
struct BeadLine {
    std::vector<double> s;         ///< n: arc length, s[0] = 0, summed left to right as the solver does
    std::vector<double> hop;       ///< n - 1: |x[i+1] - x[i]|
    std::vector<Vec3> half_chord;  ///< n: l = (x[i+1] - x[i-1]) / 2, index clamped at the ends
    std::vector<double> tributary; ///< n: |l|
    double length = 0;             ///< s of the last node

    std::size_t size() const { return s.size(); }
};

BeadLine bead_line(std::span<const Vec3> x);

/// Half chord of one node, index clamped at the ends.
Vec3 half_chord(std::span<const Vec3> x, std::size_t i);

/// Half the sum of the hops beside a node: the tributary length along the arc.
double arc_tributary(const BeadLine&, std::size_t i);

/// Limit per length at arc length s of s_total, as the solver takes it: constant when `last` is 0, else
/// linear. The solver divides 0 by 0 on a line without length; here that gives `first`.
double limit_along(double first, double last, double s, double s_total);

/// The solver's limit of the normal force: none along the whole line when Fn_first is 0.
double normal_limit_along(double first, double last, double s, double s_total);

} // namespace drawbead
