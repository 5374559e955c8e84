#pragma once
// A function of time given by points: linear between them, and beyond the ends along the first and last line.
#include <cstddef>
#include <utility>
#include <vector>

namespace drawbead {

class TimeTable {
public:
    /// At least one point, abscissae increasing; one point is a constant.
    TimeTable(std::vector<double> t, std::vector<double> y);
    static TimeTable constant(double y) { return TimeTable({0}, {y}); }

    /// As the Engine interpolates: y1 + (y2 − y1)/(t2 − t1) · (t − t1).
    double value(double t) const;
    /// To the right of a point.
    double slope(double t) const;
    /// From a to b, exact.
    double integral(double a, double b) const;
    const std::vector<double>& times() const { return t_; }
    const std::vector<double>& values() const { return y_; }
    /// Times strictly between a and b where the line bends or the value is zero, ascending.
    std::vector<double> corners(double a, double b) const;

private:
    std::vector<double> t_, y_;

    std::size_t piece(double t) const; ///< the line from this point to the next one holds at t
    double antiderivative(double t) const;
    std::vector<double> area_; ///< from the first point to each one
};

} // namespace drawbead
