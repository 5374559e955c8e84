#pragma once
// How the files of hard cases write their tables, and small helpers that they share.
#include "study/hard_cases.h"

#include <cmath>
#include <limits>
#include <vector>

namespace drawbead {

/// One line of a table: a case for double, and for float where there is a function for it.
struct HardCaseRow {
    std::string_view name;
    Law law;
    bool violated;
    std::string_view scene, invariant, guard;
    HardCaseResult (*in_double)() = nullptr;
    HardCaseResult (*in_float)() = nullptr;
};
inline constexpr bool must_hold = false, is_broken = true;

std::vector<HardCaseRow> manual_kernel_cases();
std::vector<HardCaseRow> solver_kernel_cases();
std::vector<HardCaseRow> closest_point_cases();
std::vector<HardCaseRow> solver_search_cases();
std::vector<HardCaseRow> bead_line_cases();
std::vector<HardCaseRow> run_cases();

template <class Real>
constexpr Real eps = std::numeric_limits<Real>::epsilon();

/// The largest of some errors; a NaN among them stays.
class Largest {
public:
    void add(double error) {
        if (!std::isnan(value_) && !(error <= value_)) value_ = error;
    }
    double value() const { return value_; }

private:
    double value_ = 0;
};

/// The invariant holds within the bound.
inline HardCaseResult within(double measured, double bound) {
    return {measured, 0, bound};
}
/// The law breaks it by so much, to a relative tolerance.
inline HardCaseResult broken_by(double measured, double expected, double relative) {
    return {measured, expected, relative * std::abs(expected)};
}

} // namespace drawbead
