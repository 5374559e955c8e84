#pragma once
// A bead over a flat sheet, for which the manual's law has closed forms.
#include "study/stepped_run.h"

#include <cmath>
#include <numbers>

namespace drawbead::testing {

/// 30 × 30 shells of 5 mm at z = 0; motion 0 is the bead's, motion 1 the sheet's. `skew`: nodes are moved in
/// the plane by up to so much.
struct Sheet {
    explicit Sheet(std::vector<Vec3> bead_nodes, BeadLaw<double> law, double young = 210000,
                   double skew = 0) {
        EvaluationSurface surface;
        NearMesh& mesh = surface.mesh;
        constexpr uint32_t n = 30;
        for (uint32_t j = 0; j <= n; ++j)
            for (uint32_t i = 0; i <= n; ++i) {
                mesh.x.push_back({5.0 * i + skew * std::sin(1.3 * i + 2.1 * j),
                                  5.0 * j + skew * std::cos(1.7 * i - j), 0});
                mesh.node_id.push_back(static_cast<uint32_t>(mesh.x.size()));
            }
        for (uint32_t j = 0; j < n; ++j)
            for (uint32_t i = 0; i < n; ++i) {
                const uint32_t a = (n + 1) * j + i;
                mesh.segment.push_back({a, a + 1, a + n + 2, a + n + 1});
                mesh.segment_index.push_back(static_cast<uint32_t>(mesh.segment.size()) - 1);
            }
        mesh.around_begin.assign(mesh.x.size() + 1, 0);
        for (uint32_t node = 0; node < mesh.x.size(); ++node) {
            for (uint32_t s = 0; s < mesh.segment.size(); ++s)
                for (const uint32_t corner : mesh.segment[s])
                    if (corner == node) mesh.around.push_back(s);
            mesh.around_begin[node + 1] = static_cast<uint32_t>(mesh.around.size());
        }
        surface.motion.assign(mesh.x.size(), 1);
        surface.mass.assign(mesh.x.size(), 2e-7);
        surface.stiffness.assign(mesh.segment.size(), {0.2 * young, 0.5, 0.2 * young});
        surface.thickness.assign(mesh.segment.size(), 1);
        EvaluationBead bead;
        bead.id = 1;
        bead.law = law;
        bead.x = std::move(bead_nodes);
        for (std::size_t i = 0; i < bead.x.size(); ++i) {
            bead.nodes.push_back(static_cast<int64_t>(1001 + i));
            bead.track.emplace_back();
            bead.slope_read.emplace_back();
        }
        bead.motion.assign(bead.x.size(), 0);
        scene.motions.resize(2);
        scene.surfaces.push_back(std::move(surface));
        scene.beads.push_back(std::move(bead));
        set_steps(scene, 0, 1, 100);
    }

    Motion& tool() { return scene.motions[0]; }
    Motion& blank() { return scene.motions[1]; }

    EvaluationScene scene;
};

inline std::vector<Vec3> straight(std::size_t count, double hop, double z = 0.3) {
    std::vector<Vec3> x;
    for (std::size_t i = 0; i < count; ++i)
        x.push_back({72.3, 31.7 + hop * static_cast<double>(i), z});
    return x;
}

/// A quarter of a circle of radius 40 in `hops` hops.
inline std::vector<Vec3> quarter(std::size_t hops, double z = 0.3) {
    std::vector<Vec3> x;
    for (std::size_t i = 0; i <= hops; ++i) {
        const double a = 0.5 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(hops);
        x.push_back({60 + 40 * std::cos(a), 60 + 40 * std::sin(a), z});
    }
    return x;
}

inline Motion::Term velocity(std::size_t axis, std::vector<double> t, std::vector<double> y) {
    return {true, axis, 1, 1, TimeTable(std::move(t), std::move(y))};
}
inline Motion::Term displacement(std::size_t axis, std::vector<double> t, std::vector<double> y) {
    return {false, axis, 1, 1, TimeTable(std::move(t), std::move(y))};
}

} // namespace drawbead::testing
