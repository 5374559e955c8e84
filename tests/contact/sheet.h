#pragma once
// Sheets of segments for tests: regular, jittered, warped, graded, of triangles, with shuffled ids.
#include "contact/segment_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace drawbead {

struct Sheet {
    std::vector<Vec3> x;
    std::vector<uint32_t> id;
    std::vector<SegmentNodes> segment;

    SegmentMesh mesh() const { return {segment, x, id, {}, {}}; }
};

/// n by m cells of unit size in the plane z = 0.
inline Sheet flat_sheet(uint32_t n, uint32_t m, double size = 1) {
    Sheet s;
    for (uint32_t j = 0; j <= m; ++j)
        for (uint32_t i = 0; i <= n; ++i)
            s.x.push_back({size * i, size * j, 0});
    for (uint32_t j = 0; j < m; ++j)
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t a = j * (n + 1) + i;
            s.segment.push_back({a, a + 1, a + n + 2, a + n + 1});
        }
    s.id.resize(s.x.size());
    std::iota(s.id.begin(), s.id.end(), 1u);
    return s;
}

inline void split_into_triangles(Sheet& s) {
    std::vector<SegmentNodes> triangles;
    for (const SegmentNodes& n : s.segment) {
        triangles.push_back({n[0], n[1], n[2], n[2]});
        triangles.push_back({n[0], n[2], n[3], n[3]});
    }
    s.segment = triangles;
}

/// `kind` 0 … 5: regular, jittered in the plane, warped, graded, triangles, two layers. Ids and segment order
/// shuffled.
inline Sheet random_sheet(int kind, std::mt19937& random) {
    std::uniform_real_distribution<double> u(-1, 1);
    Sheet s = flat_sheet(8 + uint32_t(random() % 6), 8 + uint32_t(random() % 6));
    for (Vec3& p : s.x) {
        if (kind == 1 || kind == 4) p = p + Vec3{0.3 * u(random), 0.3 * u(random), 0};
        if (kind == 2) p = p + Vec3{0.2 * u(random), 0.2 * u(random), 0.5 * u(random)};
        if (kind == 3) p = {std::pow(1.4, p.x), 0.2 * p.y * p.y, 0.1 * p.x};
    }
    if (kind == 4) split_into_triangles(s);
    if (kind == 5) {
        const auto nodes = static_cast<uint32_t>(s.x.size());
        const std::size_t segments = s.segment.size();
        for (uint32_t k = 0; k < nodes; ++k)
            s.x.push_back(s.x[k] + Vec3{0.4, 0.3, -1.5 + 0.1 * u(random)});
        for (std::size_t k = 0; k < segments; ++k) {
            SegmentNodes n = s.segment[k];
            for (uint32_t& row : n)
                row += nodes;
            s.segment.push_back(n);
        }
        s.id.resize(s.x.size());
        std::iota(s.id.begin(), s.id.end(), 1u);
    }
    std::shuffle(s.id.begin(), s.id.end(), random);
    std::shuffle(s.segment.begin(), s.segment.end(), random);
    return s;
}

/// Bead nodes at random over, under, on and beside a sheet.
inline std::vector<Vec3> random_points(const Sheet& s, std::size_t count, std::mt19937& random) {
    std::uniform_real_distribution<double> u(-1, 1);
    std::vector<Vec3> points;
    for (std::size_t k = 0; k < count; ++k) {
        const SegmentNodes& n = s.segment[random() % s.segment.size()];
        const Vec3 on = k % 5 == 0   ? s.x[n[0]]
                        : k % 5 == 1 ? 0.5 * (s.x[n[0]] + s.x[n[1]])
                                     : 0.25 * (s.x[n[0]] + s.x[n[1]] + s.x[n[2]] + s.x[n[3]]);
        const double away = k % 3 == 0 ? 0.1 : k % 3 == 1 ? 2 : 20;
        points.push_back(on + (k % 7 == 0 ? Vec3{0, 0, away} : away * Vec3{u(random), u(random), u(random)}));
    }
    return points;
}

} // namespace drawbead
