#include "geometry/segment_shape.h"

namespace drawbead {

Vec3 unit(Vec3 a) {
    const double length = norm(a);
    return length > 0 ? a / length : Vec3{};
}

std::array<double, 4> bilinear_weights(double xi, double eta) {
    return {0.25 * (1 - xi) * (1 - eta), 0.25 * (1 + xi) * (1 - eta), 0.25 * (1 + xi) * (1 + eta),
            0.25 * (1 - xi) * (1 + eta)};
}

Vec3 patch_point(const Corners& c, double xi, double eta) {
    const auto h = bilinear_weights(xi, eta);
    return h[0] * c[0] + h[1] * c[1] + h[2] * c[2] + h[3] * c[3];
}

Vec3 patch_normal(const Corners& c, double xi, double eta) {
    if (!is_triangle(c)) {
        const Vec3 along_xi = (1 - eta) * (c[1] - c[0]) + (1 + eta) * (c[2] - c[3]);
        const Vec3 along_eta = (1 - xi) * (c[3] - c[0]) + (1 + xi) * (c[2] - c[1]);
        const Vec3 product = cross(along_xi, along_eta);
        const double scale = norm(along_xi) * norm(along_eta);
        if (norm(product) > 1e-12 * scale) return unit(product);
    }
    return unit(area_vector(c));
}

double one_point_volume(const std::array<Vec3, 8>& x) {
    Vec3 a, b, c;
    for (int k = 0; k < 8; ++k) {
        const Vec3& p = x[static_cast<std::size_t>(k)];
        const int in_face = k % 4;
        a += in_face == 1 || in_face == 2 ? p : -p;
        b += in_face >= 2 ? p : -p;
        c += k >= 4 ? p : -p;
    }
    return std::abs(dot(a, cross(b, c))) / 64;
}

bool faces_away(const Corners& c, Vec3 inside) {
    return dot(area_vector(c), centroid(c) - inside) > 0;
}

} // namespace drawbead
