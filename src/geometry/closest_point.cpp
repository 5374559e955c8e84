#include "geometry/closest_point.h"

#include "geometry/closest_foot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drawbead {
namespace {

constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();

double largest(Vec3 a) {
    return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

double magnitude(const Corners& c, Vec3 x) {
    return std::max({largest(c[0]), largest(c[1]), largest(c[2]), largest(c[3]), largest(x)});
}

/// Place on edge k, t of the way to its end.
void set_on_edge(Foot& foot, int k, double t, bool triangle) {
    const double along = 2 * t - 1;
    switch (k) {
    case 0:
        foot.xi = along, foot.eta = -1;
        break;
    case 1:
        foot.xi = 1, foot.eta = along;
        break;
    case 2:
        foot.xi = -along, foot.eta = 1;
        break;
    default:
        foot.xi = -1, foot.eta = -along;
        break;
    }
    if (triangle && foot.eta == 1) foot.xi = 0;
    foot.edges = static_cast<uint8_t>(1u << k);
    const int next = triangle && k == 1 ? 3 : (k + 1) % 4;
    const int previous = triangle && k == 3 ? 1 : (k + 3) % 4;
    if (t == 0) foot.edges = static_cast<uint8_t>(foot.edges | 1u << previous);
    if (t == 1) foot.edges = static_cast<uint8_t>(foot.edges | 1u << next);
}

/// Closest point of the outline. Within rounding of a corner it is the corner.
Foot closest_on_outline(const Corners& c, Vec3 x, double tolerance) {
    const bool triangle = is_triangle(c);
    Foot best;
    double best_squared = std::numeric_limits<double>::infinity(), best_t = 0;
    int best_edge = 0;
    for (int k = 0; k < 4; ++k) {
        if (triangle && k == 2) continue;
        const Vec3 from = c[static_cast<std::size_t>(k)];
        const Vec3 to = c[static_cast<std::size_t>((k + 1) % 4)];
        const Vec3 edge = to - from;
        const double squared_length = squared_norm(edge), along = dot(x - from, edge);
        double t = !(along > 0) ? 0.0 : !(along < squared_length) ? 1.0 : along / squared_length;
        // A corner stays one unless its edge has no length.
        if ((t > 0 && t < 1) || squared_length <= 4 * tolerance * tolerance) {
            const double length = std::sqrt(squared_length);
            if (t * length <= tolerance) t = 0;
            if ((1 - t) * length <= tolerance) t = 1;
        }
        const Vec3 point = t == 1 ? to : from + t * edge;
        const double squared = squared_norm(x - point);
        if (squared < best_squared) {
            best_squared = squared;
            best.point = point;
            best_t = t;
            best_edge = k;
        }
    }
    set_on_edge(best, best_edge, best_t, triangle);
    best.distance = std::sqrt(best_squared);
    return best;
}

/// Whether the projection of x along n lies inside a convex outline by more than the tolerance.
bool inside_outline(const Corners& c, Vec3 n, Vec3 x, double tolerance) {
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 edge = c[(k + 1) % 4] - c[k];
        const double length = norm(edge);
        if (length == 0) continue;
        if (!(dot(n, cross(edge, x - c[k])) > tolerance * length)) return false;
    }
    return true;
}

/// S = centre + a xi + b eta + e xi eta
struct Bilinear {
    Vec3 centre, a, b, e;

    explicit Bilinear(const Corners& c)
        : centre(0.25 * ((c[0] + c[2]) + (c[1] + c[3]))), a(0.25 * ((c[1] - c[0]) + (c[2] - c[3]))),
          b(0.25 * ((c[3] - c[0]) + (c[2] - c[1]))), e(0.25 * ((c[0] - c[1]) + (c[2] - c[3]))) {}
    Vec3 operator()(double xi, double eta) const { return centre + xi * a + eta * b + xi * eta * e; }
};

Foot triangle_foot(const Corners& c, Vec3 x, double tolerance) {
    const Vec3 normal = unit(area_vector(c));
    if (!(squared_norm(normal) > 0) || !inside_outline(c, normal, x, tolerance)) {
        Foot foot = closest_on_outline(c, x, tolerance);
        foot.normal = normal;
        return foot;
    }
    Foot foot;
    foot.normal = normal;
    foot.point = x - dot(normal, x - c[0]) * normal;
    const double whole = 2 * area(c);
    const double w1 = dot(normal, cross(c[2] - c[1], x - c[1])) / whole;
    const double w2 = dot(normal, cross(c[0] - c[2], x - c[2])) / whole;
    const double w3 = dot(normal, cross(c[1] - c[0], x - c[0])) / whole;
    foot.eta = std::clamp(2 * w3 - 1, -1.0, 1.0);
    foot.xi = std::clamp((w2 - w1) / (w2 + w1), -1.0, 1.0);
    foot.distance = norm(x - foot.point);
    return foot;
}

/// The bilinear coordinates of a point in a convex planar quad. For eta a quadratic A eta^2 + B eta + C;
/// inside the quad its slope is minus the Jacobian, which picks the root, taken in the form without
/// cancellation.
void invert_planar(const Bilinear& s, Vec3 n, Vec3 p, double& xi, double& eta) {
    const Vec3 r = p - s.centre;
    const double A = dot(n, cross(s.b, s.e));
    const double B = dot(n, cross(s.b, s.a)) - dot(n, cross(r, s.e));
    const double C = dot(n, cross(s.a, r));
    const double root = std::sqrt(std::max(B * B - 4 * A * C, 0.0));
    eta = B < 0 ? 2 * C / (root - B) : A != 0 ? -(B + root) / (2 * A) : 0;
    eta = std::clamp(eta, -1.0, 1.0);
    const Vec3 along = s.a + eta * s.e;
    const double squared = squared_norm(along);
    xi = squared > 0 ? std::clamp(dot(r - eta * s.b, along) / squared, -1.0, 1.0) : 0;
}

/// Coefficients of a polynomial, lowest first.
template <std::size_t N>
double value(const std::array<double, N>& p, double t) {
    double sum = p[N - 1];
    for (std::size_t k = N - 1; k-- > 0;)
        sum = sum * t + p[k];
    return sum;
}

struct Roots {
    std::array<double, 5> at{};
    std::size_t count = 0;
};

/// Where p changes sign in [-1, 1], ascending: one change at most between neighbouring roots of its
/// derivative.
template <std::size_t N>
Roots sign_changes(const std::array<double, N>& p) {
    Roots roots;
    if constexpr (N == 2) {
        if (p[1] != 0 && std::abs(p[0]) <= std::abs(p[1])) roots.at[roots.count++] = -p[0] / p[1];
        return roots;
    } else {
        std::array<double, N - 1> slope;
        for (std::size_t k = 1; k < N; ++k)
            slope[k - 1] = static_cast<double>(k) * p[k];
        const Roots turns = sign_changes(slope);
        double lo = -1, at_lo = value(p, lo);
        for (std::size_t k = 0; k <= turns.count; ++k) {
            const double hi = k < turns.count ? turns.at[k] : 1.0;
            const double at_hi = value(p, hi);
            if ((at_lo < 0 && at_hi >= 0) || (at_lo > 0 && at_hi <= 0) || (at_lo == 0 && k == 0)) {
                double left = lo, right = hi, t = 0.5 * (lo + hi);
                for (int step = 0; step < 60 && right - left > 1e-15; ++step) {
                    const double f = value(p, t);
                    if (f == 0) break;
                    ((f < 0) == (at_lo < 0) ? left : right) = t;
                    const double newton = t - f / value(slope, t);
                    t = newton > left && newton < right ? newton : 0.5 * (left + right);
                    if (std::abs(newton - t) == 0 && std::abs(f) < 1e-300) break;
                }
                roots.at[roots.count++] = at_lo == 0 && k == 0 ? lo : t;
            }
            lo = hi, at_lo = at_hi;
        }
        return roots;
    }
}

/// Whether the distance can have a stationary point inside a patch: there x - S is perpendicular to both
/// S_xi = a + eta e and S_eta = b + xi e, and neither product can vanish when its constant term is larger
/// than all others are together. Most patches that are looked at lie beside the point and end here.
bool may_be_stationary(const Bilinear& s, Vec3 x) {
    const Vec3 r = x - s.centre;
    const double ab = std::abs(dot(s.a, s.b)), ae = std::abs(dot(s.a, s.e)), be = std::abs(dot(s.b, s.e));
    const double re = std::abs(dot(r, s.e)), ee = dot(s.e, s.e);
    constexpr double slack = 1 + 1e-9;
    return std::abs(dot(r, s.a)) <= slack * (dot(s.a, s.a) + ab + 2 * ae + be + re + ee) &&
           std::abs(dot(r, s.b)) <= slack * (dot(s.b, s.b) + ab + 2 * be + ae + re + ee);
}

/// Stationary points of the distance inside a patch that is not planar. For each eta the closest point of the
/// ruling is known; eta itself is then a root of a quintic, and all its roots are found. Returns the closest,
/// if any.
bool stationary_foot(const Bilinear& s, Vec3 x, double& best_xi, double& best_eta) {
    const Vec3 r = x - s.centre;
    // u = (x - ruling's middle) . direction, v = |direction|^2, w = (x - middle) . d(x - middle)/d eta
    const std::array<double, 3> u{dot(r, s.a), dot(r, s.e) - dot(s.b, s.a), -dot(s.b, s.e)};
    const std::array<double, 3> v{dot(s.a, s.a), 2 * dot(s.a, s.e), dot(s.e, s.e)};
    const std::array<double, 2> w{-dot(r, s.b), dot(s.b, s.b)};
    std::array<double, 6> f{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 2; ++k)
                f[i + j + k] += w[k] * v[i] * v[j];
            for (std::size_t k = 1; k < 3; ++k) {
                f[i + j + k - 1] -= u[i] * v[j] * static_cast<double>(k) * u[k];
                f[i + j + k - 1] += 0.5 * u[i] * u[j] * static_cast<double>(k) * v[k];
            }
        }
    const Roots roots = sign_changes(f);
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < roots.count; ++k) {
        double eta = roots.at[k];
        const double squared = v[0] + eta * (v[1] + eta * v[2]);
        if (!(squared > 0)) continue;
        double xi = (u[0] + eta * (u[1] + eta * u[2])) / squared;
        // The quintic squares rounding errors up; Newton on the two equations takes them out again.
        for (int step = 0; step < 8; ++step) {
            const Vec3 along_xi = s.a + eta * s.e, along_eta = s.b + xi * s.e;
            const Vec3 miss = s(xi, eta) - x;
            const double gx = dot(miss, along_xi), ge = dot(miss, along_eta);
            const double hxx = dot(along_xi, along_xi), hee = dot(along_eta, along_eta);
            const double hxe = dot(along_xi, along_eta) + dot(miss, s.e);
            const double det = hxx * hee - hxe * hxe;
            if (!(det > 1e-8 * hxx * hee)) break;
            const double dx = (hee * gx - hxe * ge) / det, de = (hxx * ge - hxe * gx) / det;
            if (std::abs(dx) > 0.01 || std::abs(de) > 0.01) break;
            xi -= dx, eta -= de;
            if (std::abs(dx) < 1e-15 && std::abs(de) < 1e-15) break;
        }
        if (std::abs(xi) > 1 || std::abs(eta) > 1) continue;
        const double squared_distance = squared_norm(x - s(xi, eta));
        if (squared_distance < best) best = squared_distance, best_xi = xi, best_eta = eta;
    }
    return best < std::numeric_limits<double>::infinity();
}

/// Of numbers whose products are numbers.
Foot foot_of(const Corners& c, Vec3 x, double tolerance) {
    if (is_triangle(c)) return triangle_foot(c, x, tolerance);
    const Vec3 normal = unit(area_vector(c));
    const Bilinear s(c);
    bool convex = squared_norm(normal) > 0;
    for (std::size_t k = 0; k < 4 && convex; ++k)
        convex = dot(normal, cross(c[(k + 1) % 4] - c[k], c[(k + 3) % 4] - c[k])) > 0;
    const bool planar = convex && std::abs(dot(normal, s.e)) <= tolerance;
    Foot foot;
    if (planar) {
        if (inside_outline(c, normal, x, tolerance)) {
            foot.point = x - dot(normal, x - s.centre) * normal;
            invert_planar(s, normal, foot.point, foot.xi, foot.eta);
            foot.distance = norm(x - foot.point);
        } else {
            foot = closest_on_outline(c, x, tolerance);
        }
        foot.branch = FootBranch::planar;
        foot.normal = normal;
        return foot;
    }
    foot = closest_on_outline(c, x, tolerance);
    foot.branch = FootBranch::edge;
    double xi = 0, eta = 0;
    if (stationary_foot(s, x, xi, eta)) {
        const Vec3 point = s(xi, eta);
        const double distance = norm(x - point);
        const bool off_edges = distance < foot.distance && norm(point - foot.point) > tolerance;
        if (off_edges) {
            foot.point = point;
            foot.xi = xi, foot.eta = eta;
            foot.distance = distance;
            foot.edges = 0;
            foot.branch = FootBranch::newton;
        }
    }
    foot.normal = patch_normal(c, foot.xi, foot.eta);
    return foot;
}

Vec3 times_power_of_two(Vec3 a, int exponent) {
    return {std::ldexp(a.x, exponent), std::ldexp(a.y, exponent), std::ldexp(a.z, exponent)};
}

/// Products of six lengths would leave the range of numbers.
bool is_extreme(double size) {
    return (size < 1e-40 && size > 0) || (size > 1e40 && std::isfinite(size));
}

} // namespace

Foot closest_foot(const Corners& c, Vec3 x) {
    const double size = magnitude(c, x);
    if (!is_triangle(c) && !is_extreme(size) && !may_be_stationary(Bilinear(c), x))
        return closest_on_outline(c, x, rounding * size);
    return closest_point(c, x);
}

Foot closest_point(const Corners& c, Vec3 x) {
    const double size = magnitude(c, x);
    const bool extreme = is_extreme(size);
    if (!extreme) return foot_of(c, x, rounding * size);
    // Near 1 they do not.
    const int exponent = std::ilogb(size);
    Corners scaled;
    for (std::size_t k = 0; k < 4; ++k)
        scaled[k] = times_power_of_two(c[k], -exponent);
    const Vec3 at = times_power_of_two(x, -exponent);
    Foot foot = foot_of(scaled, at, rounding * magnitude(scaled, at));
    foot.point = times_power_of_two(foot.point, exponent);
    foot.distance = std::ldexp(foot.distance, exponent);
    return foot;
}

double squared_distance_to_box(const Corners& c, Vec3 x) {
    const auto gap = [](double p, double q, double r, double s, double at) {
        const double lo = std::min(std::min(p, q), std::min(r, s)),
                     hi = std::max(std::max(p, q), std::max(r, s));
        return std::max({lo - at, at - hi, 0.0});
    };
    return squared_norm({gap(c[0].x, c[1].x, c[2].x, c[3].x, x.x), gap(c[0].y, c[1].y, c[2].y, c[3].y, x.y),
                         gap(c[0].z, c[1].z, c[2].z, c[3].z, x.z)});
}

} // namespace drawbead
