#pragma once
// One segment as a shape: four corners in its own order, a triangle repeats its third corner (n1 n2 n3 n3).
// Bilinear map S(xi, eta) = 1/4 sum (1 +- xi)(1 +- eta) X_k, corners at (-1,-1) (1,-1) (1,1) (-1,1).
#include "geometry/vec3.h"

#include <array>
#include <cstdint>

namespace drawbead {

using Corners = std::array<Vec3, 4>;

constexpr bool is_triangle(const Corners& c) {
    return c[2] == c[3];
}

/// Half the cross product of the diagonals: exact for planar and warped quads and for triangles. Its length
/// is the area (of the mean plane, when warped), its direction the normal by the right-hand rule.
constexpr Vec3 area_vector(const Corners& c) {
    return 0.5 * cross(c[2] - c[0], c[3] - c[1]);
}
inline double area(const Corners& c) {
    return norm(area_vector(c));
}

constexpr Vec3 centroid(const Corners& c) {
    return 0.25 * (c[0] + c[1] + c[2] + c[3]);
}

/// a / |a|; zero for a zero vector.
Vec3 unit(Vec3 a);

std::array<double, 4> bilinear_weights(double xi, double eta);
Vec3 patch_point(const Corners&, double xi, double eta);

/// Unit vector of dS/dxi x dS/deta. A triangle, and a point where the product vanishes (a corner with
/// collinear edges), has the normal of the whole segment; a segment without area has none: zero.
Vec3 patch_normal(const Corners&, double xi, double eta);

/// Volume of an 8-node solid by one point: |det| of the Jacobian at its centre times 8, as the solver takes
/// it.
double one_point_volume(const std::array<Vec3, 8>&);

/// Whether a face looks away from `inside`, a point of the solid behind it.
bool faces_away(const Corners&, Vec3 inside);

} // namespace drawbead
