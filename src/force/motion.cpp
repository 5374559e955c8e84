#include "force/motion.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

constexpr std::array<double Vec3::*, 3> axes{&Vec3::x, &Vec3::y, &Vec3::z};

/// Rotation by Rodrigues' formula.
std::array<Vec3, 3> rotation(Vec3 k, double angle) {
    const double c = std::cos(angle), s = std::sin(angle), u = 1 - c;
    return {Vec3{c + u * k.x * k.x, u * k.x * k.y - s * k.z, u * k.x * k.z + s * k.y},
            Vec3{u * k.y * k.x + s * k.z, c + u * k.y * k.y, u * k.y * k.z - s * k.x},
            Vec3{u * k.z * k.x - s * k.y, u * k.z * k.y + s * k.x, c + u * k.z * k.z}};
}

/// The rotation, then a translation.
Placement place(const Motion::Turn& turn, double t, Vec3 translation) {
    Placement out;
    out.row = rotation(turn.axis, turn.angle.value(t));
    out.turned = true;
    out.shift = turn.about - out.turn(turn.about) + translation;
    return out;
}

} // namespace

Vec3 Placement::turn_back(Vec3 v) const {
    return turned ? v.x * row[0] + v.y * row[1] + v.z * row[2] : v;
}

Vec3 Placement::back(Vec3 y) const {
    return turn_back(y - shift);
}

bool Motion::at_rest() const {
    const auto is_zero = [](double y) { return y == 0; };
    for (const Term& term : terms) {
        const std::vector<double>& y = term.table.values();
        if (term.scale != 0 && !std::all_of(y.begin(), y.end(), is_zero)) return false;
    }
    return !turn || std::all_of(turn->angle.values().begin(), turn->angle.values().end(), is_zero);
}

Vec3 Motion::displacement(double t) const {
    Vec3 sum;
    for (const Term& term : terms)
        sum.*axes[term.axis] +=
            term.velocity ? term.scale * term.time_scale * term.table.integral(0, t / term.time_scale)
                          : term.value(t);
    return sum;
}

Vec3 Motion::velocity(double t) const {
    Vec3 sum;
    for (const Term& term : terms)
        sum.*axes[term.axis] += term.velocity
                                    ? term.value(t)
                                    : term.scale / term.time_scale * term.table.slope(t / term.time_scale);
    return sum;
}

Placement Motion::placement(double t) const {
    if (turn) return place(*turn, t, displacement(t));
    Placement out;
    out.shift = displacement(t);
    return out;
}

Vec3 Motion::velocity_at(double t, Vec3 x) const {
    Vec3 v = velocity(t);
    if (turn) v += turn->angle.slope(t) * cross(turn->axis, x - displacement(t) - turn->about);
    return v;
}

namespace {

std::vector<double> ascending(std::vector<double> t) {
    std::sort(t.begin(), t.end());
    t.erase(std::unique(t.begin(), t.end()), t.end());
    return t;
}

} // namespace

std::vector<double> Motion::bends(double a, double b) const {
    std::vector<double> out;
    for (const Term& term : terms)
        for (const double at : term.table.times())
            if (const double t = at * term.time_scale; t > a && t < b) out.push_back(t);
    if (turn)
        for (const double t : turn->angle.corners(a, b))
            out.push_back(t);
    return ascending(std::move(out));
}

std::vector<double> Motion::corners(double a, double b) const {
    std::vector<double> out = bends(a, b);
    // Between bends every term is linear, and so is their sum: that is what turns, not its terms.
    std::vector<double> knots{a};
    knots.insert(knots.end(), out.begin(), out.end());
    knots.push_back(b);
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
        const double from = knots[k], to = knots[k + 1], middle = from + 0.5 * (to - from);
        const Vec3 first = velocity(from), half = velocity(middle);
        for (const auto axis : axes) {
            const double v0 = first.*axis, change = 2 * (half.*axis - v0);
            if (!(v0 * (v0 + change) < 0)) continue;
            const double t = from - v0 / change * (to - from);
            if (t > from && t < to) out.push_back(t);
        }
    }
    return ascending(std::move(out));
}

bool Motion::accelerates() const {
    if (turn) return true;
    return std::any_of(terms.begin(), terms.end(), [](const Term& term) {
        const std::vector<double>& y = term.table.values();
        return term.velocity &&
               std::any_of(y.begin(), y.end(), [&](double value) { return value != y.front(); });
    });
}

MotionSteps integrate(const Motion& motion, std::span<const double> t, std::span<const double> dt) {
    MotionSteps out;
    out.initial = motion.initial_velocity;
    if (motion.at_rest() || t.empty()) return out;
    out.moves = true;
    out.turns = motion.turn.has_value();
    out.velocity.assign(t.size(), {});
    out.increment.assign(t.size(), {});
    out.velocity[0] = motion.initial_velocity;
    Vec3 imposed, travelled; // by displacement terms alone; in all
    if (out.turns)
        for (const double step : dt)
            out.rate.push_back(step > 0 ? 1 / step : 0);
    if (out.turns) out.placements.push_back(place(*motion.turn, t[0], {}));
    for (std::size_t n = 1; n < t.size(); ++n) {
        const Vec3 before = out.velocity[n - 1];
        const double middle = t[n - 1] + 0.5 * dt[n], spread = 0.5 * (dt[n - 1] + dt[n]);
        Vec3 wanted, target;
        bool displaced = false;
        for (const Motion::Term& term : motion.terms) {
            if (term.velocity) {
                wanted.*axes[term.axis] += term.value(middle);
            } else {
                target.*axes[term.axis] += term.value(t[n]);
                displaced = true;
            }
        }
        if (displaced && dt[n] > 0) {
            const Vec3 step = target - imposed;
            wanted += step / dt[n];
            imposed += step;
        }
        // The Engine makes an acceleration of it and adds that up: to the last bit not quite the same.
        out.velocity[n] = spread > 0 ? before + spread * ((wanted - before) / spread) : wanted;
        out.increment[n] = dt[n] * out.velocity[n];
        travelled += out.increment[n];
        if (out.turns) out.placements.push_back(place(*motion.turn, t[n], travelled));
    }
    return out;
}

} // namespace drawbead
