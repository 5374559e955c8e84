#include "contact/rigid_tracks.h"

#include "contact/solver_search.h"
#include "sheet.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace drawbead;

namespace {

/// A sheet that moves as one, every position summed step by step as the solver does.
class MovingSheet final : public SurfaceNow {
public:
    explicit MovingSheet(NearMesh part) : mesh(std::move(part)), x(mesh.x) {}

    void move(Vec3 increment) {
        for (Vec3& p : x)
            p += increment;
        gone += increment;
    }
    const Vec3& at(uint32_t node) override {
        ++asked;
        return x[node];
    }

    NearMesh mesh;
    std::vector<Vec3> x;
    Vec3 gone;
    uint64_t asked = 0; ///< positions that a search needed
};

/// A few ulp for each step of a way of this length.
double rounding(const MovingSheet& sheet, Vec3 step, std::size_t steps) {
    double size = 0;
    for (const Vec3& p : sheet.mesh.x)
        size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const double n = static_cast<double>(steps);
    return 2.3e-16 * (size + 1 + 2 * n * norm(step)) * (16 + 4 * n);
}

} // namespace

TEST_CASE("over a sheet that keeps its shape tracks are those of the solver's search, with no doubt left") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int round = 0; round < 60; ++round) {
        const Sheet s = random_sheet(round % 6, random);
        std::vector<Vec3> beads = random_points(s, 12, random);
        // Over nodes, edges and centres, where many comparisons are ties.
        for (std::size_t k = 0; k < 6; ++k) {
            const SegmentNodes& n = s.segment[random() % s.segment.size()];
            const Vec3 up{0, 0, 0.5};
            beads.push_back(s.x[n[0]] + up);
            beads.push_back(0.5 * (s.x[n[0]] + s.x[n[1]]) + up);
            beads.push_back(0.25 * (s.x[n[0]] + s.x[n[1]] + s.x[n[2]] + s.x[n[3]]) + up);
        }
        MovingSheet sheet(near_mesh(s.mesh(), {}, whole_surface));
        const StartSearch search(sheet.mesh, beads);
        // Steps along the mesh and aslant, small, of an element, and none.
        const double length = std::array{0.0, 0.03, 0.25, 1.7}[random() % 4];
        const Vec3 step = random() % 2 != 0 ? Vec3{length, 0, 0} : length * Vec3{u(random), u(random), 0.1};
        const Vec3 tool = random() % 2 != 0 ? Vec3{} : 0.01 * Vec3{u(random), u(random), u(random)};
        const std::size_t steps = 60;
        RigidTracks rigid(sheet.mesh, rounding(sheet, step, steps) + rounding(sheet, tool, steps));
        struct Node {
            Track track, expected;
            double left = 0; ///< of the margin
        };
        std::vector<Node> nodes;
        for (const Vec3& bead : beads) {
            const auto start = solver_start(search, sheet.mesh, bead);
            REQUIRE(start);
            nodes.push_back({*start, *start});
        }
        for (std::size_t n = 0; n < steps; ++n) {
            if (n > 0) {
                sheet.move(step);
                for (Vec3& bead : beads)
                    bead += tool;
            }
            for (std::size_t i = 0; i < beads.size(); ++i) {
                Node& node = nodes[i];
                const bool complete = solver_follow(node.expected, sheet.mesh, sheet.x, beads[i]);
                node.left -= norm(tool - step);
                if (node.left <= 0) {
                    const RigidTracks::Step out =
                        rigid.follow(node.track, beads[i] - sheet.gone, beads[i], sheet);
                    CHECK(out.complete == complete);
                    node.left = out.margin;
                }
                REQUIRE(node.track.nearest == node.expected.nearest);
                REQUIRE(node.track.segment == node.expected.segment);
            }
        }
    }
}

TEST_CASE("away from ties no position of the moved sheet is needed") {
    const Sheet s = flat_sheet(10, 10);
    MovingSheet sheet(near_mesh(s.mesh(), {}, whole_surface));
    const Vec3 bead{5.3137, 5.2, 0.5};
    const StartSearch search(sheet.mesh, std::span(&bead, 1));
    Track track = solver_start(search, sheet.mesh, bead).value();
    RigidTracks rigid(sheet.mesh, 1e-12);
    uint64_t searched = 0;
    for (int n = 0; n < 30; ++n) {
        searched += rigid.follow(track, bead - sheet.gone, bead, sheet).searched;
        sheet.move({0.1, 0, 0});
    }
    CHECK(searched == 6); // half elements passed on the way from 5.3137 to 2.4137
    CHECK(sheet.asked == 0);
}

TEST_CASE("a node without a margin is on a border, and is looked at with the positions of now") {
    const Sheet s = flat_sheet(4, 4);
    MovingSheet sheet(near_mesh(s.mesh(), {}, whole_surface));
    const Vec3 bead{1.5, 2, 0.5}; // over the middle of an edge
    const StartSearch search(sheet.mesh, std::span(&bead, 1));
    Track track = solver_start(search, sheet.mesh, bead).value();
    RigidTracks rigid(sheet.mesh, 1e-12);
    const RigidTracks::Step out = rigid.follow(track, bead, bead, sheet);
    CHECK(out.margin == 0);
    CHECK(out.searched);
    CHECK(sheet.asked > 0);
}
