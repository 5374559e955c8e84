#pragma once
// Where a point is on one segment, in the number type of a study.
#include "geometry/segment_shape.h"
#include "geometry/vec3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drawbead {

template <class Real>
struct SegmentFoot {
    BasicVec3<Real> normal;
    Real distance = 0; ///< signed
    Real xi = 0, eta = 0;
    bool inside = true; ///< |ξ|, |η| of the ratios at most 1.05
};

template <class Real>
using RealCorners = std::array<BasicVec3<Real>, 4>;

template <class Real>
std::array<Real, 4> corner_weights(Real xi, Real eta) {
    const Real q = Real(0.25);
    return {q * (1 - xi) * (1 - eta), q * (1 + xi) * (1 - eta), q * (1 + xi) * (1 + eta),
            q * (1 - xi) * (1 + eta)};
}

template <class Real>
BasicVec3<Real> weighted(const RealCorners<Real>& c, Real xi, Real eta) {
    const auto h = corner_weights(xi, eta);
    return h[0] * c[0] + h[1] * c[1] + h[2] * c[2] + h[3] * c[3];
}

/// By ratios of the areas of triangles on opposite edges, as the solver does (solver notes 2.3).
template <class Real>
SegmentFoot<Real> ratio_foot(const RealCorners<Real>& c, const BasicVec3<Real>& x) {
    using V = BasicVec3<Real>;
    const V centre = Real(0.25) * (c[0] + c[1] + c[2] + c[3]);
    V sum;
    for (std::size_t k = 0; k < 4; ++k)
        sum += cross(c[k] - centre, c[(k + 1) % 4] - centre);
    SegmentFoot<Real> out;
    const Real size = norm(sum);
    if (!(size > 0)) {
        out.inside = false;
        return out;
    }
    out.normal = sum / size;
    std::array<Real, 4> a{}, b{};
    for (std::size_t k = 0; k < 4; ++k) {
        a[k] = dot(out.normal, cross(c[k] - centre, c[(k + 1) % 4] - centre));
        b[k] = dot(out.normal, cross(c[k] - x, c[(k + 1) % 4] - x));
    }
    const auto ratio = [](Real up, Real down) { return down != 0 ? up / down : Real(0); };
    out.xi = ratio(a[1] * b[3] - b[1] * a[3], a[1] * b[3] + b[1] * a[3]);
    out.eta =
        c[2] == c[3] ? ratio(b[0] - a[0], a[0]) : ratio(b[0] * a[2] - b[2] * a[0], b[0] * a[2] + b[2] * a[0]);
    out.inside = std::abs(out.xi) <= Real(1.05) && std::abs(out.eta) <= Real(1.05);
    out.xi = std::clamp(out.xi, Real(-1), Real(1));
    out.eta = std::clamp(out.eta, Real(-1), Real(1));
    out.distance = dot(out.normal, x - weighted(c, out.xi, out.eta));
    return out;
}

/// The closest point of the segment, by Newton steps that stay on it: from the inside, and along its edges
/// where that leads out.
template <class Real>
SegmentFoot<Real> closest_foot(const RealCorners<Real>& c, const BasicVec3<Real>& x) {
    using V = BasicVec3<Real>;
    SegmentFoot<Real> out = ratio_foot(c, x);
    const bool inside = out.inside;
    const Real q = Real(0.25);
    const V a = q * ((c[1] - c[0]) + (c[2] - c[3])), b = q * ((c[3] - c[0]) + (c[2] - c[1])),
            e = q * ((c[0] - c[1]) + (c[2] - c[3]));
    const bool triangle = c[2] == c[3];
    Real best = -1;
    const auto take = [&](Real xi, Real eta) {
        const Real squared = squared_norm(x - weighted(c, xi, eta));
        if (best >= 0 && !(squared < best)) return;
        best = squared;
        out.xi = xi;
        out.eta = eta;
    };
    Real xi = out.xi, eta = out.eta;
    bool converged = false;
    for (int step = 0; step < 12 && !converged; ++step) {
        const V along_xi = a + eta * e, along_eta = b + xi * e, miss = weighted(c, xi, eta) - x;
        const Real gx = dot(miss, along_xi), ge = dot(miss, along_eta);
        const Real xx = squared_norm(along_xi), ee = squared_norm(along_eta);
        // Without the second derivative where the full matrix does not lead downwards.
        Real xe = dot(along_xi, along_eta) + dot(miss, e);
        if (!(xx * ee - xe * xe > 0)) xe = dot(along_xi, along_eta);
        const Real det = xx * ee - xe * xe;
        if (!(det > 0)) break;
        const Real dx = (ee * gx - xe * ge) / det, de = (xx * ge - xe * gx) / det;
        xi -= dx;
        eta -= de;
        if (std::abs(xi) > 2 || std::abs(eta) > 2) break;
        converged = std::abs(dx) + std::abs(de) < Real(8) * std::numeric_limits<Real>::epsilon();
    }
    if (std::abs(xi) <= 1 && std::abs(eta) <= 1) take(xi, eta);
    if (best < 0 || !converged)
        for (std::size_t k = 0; k < 4; ++k) {
            if (triangle && k == 2) continue;
            const V from = c[k], edge = c[(k + 1) % 4] - from;
            const Real squared = squared_norm(edge);
            const Real t =
                squared > 0 ? std::clamp(dot(x - from, edge) / squared, Real(0), Real(1)) : Real(0);
            const Real along = 2 * t - 1;
            const std::array<std::array<Real, 2>, 4> place{
                {{along, -1}, {1, along}, {-along, 1}, {-1, -along}}};
            take(place[k][0], place[k][1]);
        }
    const V along_xi = a + out.eta * e, along_eta = b + out.xi * e;
    const V product = cross(along_xi, along_eta);
    const Real size = norm(product);
    if (!triangle && size > std::numeric_limits<Real>::epsilon() * norm(along_xi) * norm(along_eta))
        out.normal = product / size;
    const V away = x - weighted(c, out.xi, out.eta);
    out.distance = std::copysign(std::sqrt(best), dot(out.normal, away));
    out.inside = inside;
    return out;
}

} // namespace drawbead
