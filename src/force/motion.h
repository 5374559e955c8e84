#pragma once
// Prescribed motion of nodes that move alike: translations given as velocities or displacements, and a
// rotation about a fixed line.
#include "force/time_table.h"
#include "geometry/vec3.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace drawbead {

/// x ↦ R x + shift
struct Placement {
    std::array<Vec3, 3> row{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    Vec3 shift;
    bool turned = false; ///< false: R is the identity, and is not multiplied with

    Vec3 operator()(Vec3 x) const {
        return turned ? Vec3{dot(row[0], x), dot(row[1], x), dot(row[2], x)} + shift : x + shift;
    }
    /// The point that comes to y.
    Vec3 back(Vec3 y) const;
    Vec3 turn(Vec3 v) const { return turned ? Vec3{dot(row[0], v), dot(row[1], v), dot(row[2], v)} : v; }
    Vec3 turn_back(Vec3 v) const;
};

struct Motion {
    /// scale · table(t / time_scale), added to what other terms of the same direction say.
    struct Term {
        bool velocity = true; ///< else a displacement
        std::size_t axis = 0;
        double scale = 1, time_scale = 1;
        TimeTable table;

        double value(double t) const { return scale * table.value(t / time_scale); }
    };
    struct Turn {
        Vec3 about, axis; ///< axis of length 1
        TimeTable angle;  ///< radians
    };
    std::vector<Term> terms;
    std::optional<Turn> turn;
    Vec3 initial_velocity; ///< what the solver's law sees in the first cycle

    bool at_rest() const;     ///< at all times, by its tables alone
    bool accelerates() const; ///< whether a velocity is anything but constant between jumps

    // Exact, as the manual's law moves.
    Vec3 displacement(double t) const; ///< of the translation since t = 0
    Vec3 velocity(double t) const;     ///< of the translation; the right-hand value where it jumps
    Placement placement(double t) const;
    /// Velocity of the point that is at x.
    Vec3 velocity_at(double t, Vec3 x) const;
    /// Times strictly between a and b where a velocity bends or jumps.
    std::vector<double> bends(double a, double b) const;
    /// The same and where the translation turns along an axis: its extremes are among them.
    std::vector<double> corners(double a, double b) const;
};

/// A motion as the Engine integrates it: v_{n+1/2} = f(t_n + Δt/2), x_{n+1} = x_n + Δt v_{n+1/2}, observed on
/// solver runs to the last bit. A displacement or a rotation gives the velocity that leads to its position at
/// t_{n+1}.
struct MotionSteps {
    bool moves = false;          ///< any increment is not zero
    bool turns = false;          ///< then positions are `placement`s, else sums of increments
    Vec3 initial;                ///< velocity at the first time
    std::vector<Vec3> velocity;  ///< [n]: v_{n−1/2} of the translation; empty when it is zero throughout
    std::vector<Vec3> increment; ///< [n]: added on the way to t_n
    std::vector<Placement> placements; ///< [n], of the start position; only with `turns`
    std::vector<double> rate;          ///< [n]: 1/dt[n], 0 for no step; only with `turns`

    Vec3 velocity_of(std::size_t n) const {
        return velocity.empty() ? (n == 0 ? initial : Vec3{}) : velocity[n];
    }
};
/// `dt[n]`: from t[n−1] to t[n]; dt[0] = 0.
MotionSteps integrate(const Motion&, std::span<const double> t, std::span<const double> dt);

} // namespace drawbead
