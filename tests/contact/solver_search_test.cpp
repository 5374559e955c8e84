#include "contact/solver_search.h"

#include "contact/bead_contact.h"
#include "sheet.h"

#include <catch2/catch.hpp>

using namespace drawbead;

namespace {

struct Whole {
    Sheet sheet;
    NearMesh mesh;
    explicit Whole(Sheet s) : sheet(std::move(s)), mesh(near_mesh(sheet.mesh(), {}, whole_surface)) {}

    Track start(Vec3 bead) const {
        const StartSearch search(mesh, std::span(&bead, 1));
        return solver_start(search, mesh, bead).value();
    }
};

} // namespace

TEST_CASE("over a regular sheet the search finds the segment below") {
    const Whole w(flat_sheet(10, 10));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> u(0, 10);
    for (int round = 0; round < 200; ++round) {
        const Vec3 bead{u(random), u(random), 0.2 + 0.3 * u(random)};
        Track track = w.start(bead);
        const SolverHit hit = solver_step(track, w.mesh, w.mesh.x, bead);
        REQUIRE(hit.segment == static_cast<uint32_t>(bead.y) * 10 + static_cast<uint32_t>(bead.x));
        REQUIRE(hit.inside);
        REQUIRE(hit.xi == Approx(2 * (bead.x - std::floor(bead.x)) - 1).margin(1e-12));
        REQUIRE(hit.d == Approx(bead.z));
    }
}

TEST_CASE("the second scan takes a squared distance for a length") {
    // Loose segments with nodes of their own, so that no refinement pass leads from one to the next.
    const auto loose = [](double size) {
        const Sheet s = flat_sheet(8, 8, size);
        Sheet out;
        for (const SegmentNodes& n : s.segment) {
            const auto first = static_cast<uint32_t>(out.x.size());
            for (std::size_t k = 0; k < 4; ++k) {
                const Vec3 middle = 0.25 * (s.x[n[0]] + s.x[n[1]] + s.x[n[2]] + s.x[n[3]]);
                out.x.push_back(middle + 0.3 * (s.x[n[k]] - middle));
                out.id.push_back(first + static_cast<uint32_t>(k) + 1);
            }
            out.segment.push_back({first, first + 1, first + 2, first + 3});
        }
        return Whole(out);
    };
    const Whole metres = loose(0.2), millimetres = loose(200);
    const auto is_nearest = [](const Whole& w, Vec3 bead, uint32_t node) {
        return std::none_of(w.mesh.x.begin(), w.mesh.x.end(),
                            [&](Vec3 p) { return distance(p, bead) < distance(w.mesh.x[node], bead); });
    };
    std::mt19937 random(4);
    std::uniform_real_distribution<double> u(0, 1.6);
    int lost = 0;
    for (int round = 0; round < 500; ++round) {
        const Vec3 bead{u(random), u(random), 0.05 * u(random)};
        lost += !is_nearest(metres, bead, metres.start(bead).nearest);
        REQUIRE(is_nearest(millimetres, 1000 * bead, millimetres.start(1000 * bead).nearest));
    }
    CHECK(lost > 0); // in metres the search stops short of the nearest node now and then
}

TEST_CASE("a bead far from the track follows by one ring per cycle") {
    const Whole w(flat_sheet(10, 10));
    Vec3 bead{0.5, 0.5, 1};
    Track track = w.start(bead);
    bead.x = 9.5;
    for (int cycle = 1; cycle <= 12; ++cycle) {
        const SolverHit hit = solver_step(track, w.mesh, w.mesh.x, bead);
        CHECK(hit.inside == (cycle >= 9));
    }
}

TEST_CASE("projection: inside, beside, clamped") {
    const Corners square{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}};
    SolverHit hit = solver_project(square, false, {1.5, 0.5, 3});
    CHECK(hit.xi == 0.5);
    CHECK(hit.eta == -0.5);
    CHECK(hit.d == 3);
    CHECK(hit.inside);
    CHECK(hit.normal == Vec3{0, 0, 1});
    hit = solver_project(square, false, {2.04, 1, 3}); // xi = 1.04
    CHECK(hit.inside);
    CHECK(hit.xi == 1);
    hit = solver_project(square, false, {2.06, 1, 3});
    CHECK_FALSE(hit.inside);
    CHECK(hit.xi == Approx(1.06));
    CHECK(hit.h[0] + hit.h[1] + hit.h[2] + hit.h[3] == Approx(1));
    const Corners triangle{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 2, 0}}};
    hit = solver_project(triangle, true, {0, 2, 1});
    CHECK(hit.eta == 1);
    hit = solver_project(triangle, true, {1, 0, 1});
    CHECK(hit.xi == Approx(0).margin(1e-15));
    CHECK(hit.eta == -1);
}

TEST_CASE("degenerate segments give numbers") {
    const Corners nothing{};
    const SolverHit hit = solver_project(nothing, false, {1, 2, 3});
    CHECK(hit.xi == 0);
    CHECK(hit.eta == 0);
    CHECK(hit.d == 0);
    CHECK_FALSE(warns_346(nothing, false, {1, 2, 3}));
}

TEST_CASE("warning 346: strictly behind the normal, beside the segment too") {
    const Corners square{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}};
    CHECK_FALSE(warns_346(square, false, {1, 1, 0.1}));
    CHECK_FALSE(warns_346(square, false, {1, 1, 0}));
    CHECK(warns_346(square, false, {1, 1, -0.1}));
    CHECK(warns_346(square, false, {5, 1, -0.1}));
    CHECK_FALSE(warns_346(square, false, {5, 1, -0.1}, 1)); // Ipri 1 skips nodes outside
    CHECK(warns_346(square, false, {1, 1, -0.1}, 1));
    const Corners triangle{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 2, 0}}};
    CHECK(warns_346(triangle, true, {0.5, 0.5, -1}));
}

TEST_CASE("penetration and tributary vector") {
    SolverHit hit;
    hit.inside = true;
    hit.d = 3;
    CHECK(solver_penetration(hit, 5, 0.5) == 2.5);
    hit.inside = false;
    CHECK(solver_penetration(hit, 5, 0.5) == 0);
    CHECK(solver_penetration(hit, 0, 0.5) == 1);
    CHECK(solver_penetration(hit, -5, 0.5) == 1);
    const SolverTributary t = solver_tributary({0, 0, 1}, {0, 2, 1});
    CHECK(t.t == Vec3{-2, 0, 0});
    CHECK(t.l2 == 4);
    CHECK(solver_tributary({0, 0, 1}, {0, 0, 1}).l2 == 1e-20);
}

TEST_CASE("a part of the surface gives the tracks of the whole") {
    std::mt19937 random(12);
    for (int round = 0; round < 200; ++round) {
        const Sheet s = random_sheet(round % 6, random);
        const NearMesh all = near_mesh(s.mesh(), {}, whole_surface);
        const ClosestSegment closest(all);
        std::vector<BeadInput> beads(1 + random() % 3);
        for (BeadInput& bead : beads) {
            bead.x = random_points(s, 1 + random() % 4, random);
            bead.fn_first = 100, bead.depth = 5;
        }
        const SurfaceContact contact =
            surface_contact(s.mesh(), beads, [](uint32_t) { return of_shell(210000, 1); }, 42000, {});
        for (std::size_t b = 0; b < beads.size(); ++b) {
            const std::vector<Vec3>& x = beads[b].x;
            const StartSearch search(all, x);
            for (std::size_t i = 0; i < x.size(); ++i) {
                Track track = solver_start(search, all, x[i]).value();
                const BeadNodeContact& node = contact.bead[b].node[i];
                REQUIRE(node.start_segment == all.segment_index[track.segment]);
                REQUIRE(contact.mesh.node_row[contact.track[b][i].nearest] == all.node_row[track.nearest]);
                const SolverHit hit = solver_step(track, all, all.x, x[i]);
                REQUIRE(node.segment == all.segment_index[hit.segment]);
                REQUIRE(node.nodes == s.segment[node.segment]);
                REQUIRE(node.xi == hit.xi);
                REQUIRE(node.distance == hit.d);
                REQUIRE(node.slope == 20);
                REQUIRE(node.closest == all.segment_index[closest.find(x[i]).segment]);
            }
        }
    }
}

TEST_CASE("a small part of a large surface is enough, in millimetres and in metres") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> u(0, 1);
    for (int round = 0; round < 24; ++round) {
        const double size = round % 2 ? 1.0 : 0.002;
        Sheet s = flat_sheet(60, 60, size);
        for (Vec3& p : s.x)
            p = p + size * Vec3{0.2 * u(random), 0.2 * u(random),
                                (round % 3) * 2 * std::sin(p.x / size * 0.1) * std::cos(p.y / size * 0.1)};
        std::shuffle(s.id.begin(), s.id.end(), random);
        const NearMesh all = near_mesh(s.mesh(), {}, whole_surface);
        BeadInput bead;
        const Vec3 from = size * Vec3{40 * u(random), 40 * u(random), 3 + 6 * u(random)};
        for (int k = 0; k < 20; ++k)
            bead.x.push_back(from + size * k * Vec3{0.8, 0.3, 0});
        const SurfaceContact contact = surface_contact(
            s.mesh(), std::span(&bead, 1), [](uint32_t) { return of_shell(210000, 1); }, 42000, {});
        CHECK(contact.mesh.segment.size() < all.segment.size());
        const StartSearch search(all, bead.x);
        for (std::size_t i = 0; i < bead.x.size(); ++i) {
            Track track = solver_start(search, all, bead.x[i]).value();
            REQUIRE(contact.bead[0].node[i].start_segment == all.segment_index[track.segment]);
            const SolverHit hit = solver_step(track, all, all.x, bead.x[i]);
            REQUIRE(contact.bead[0].node[i].segment == all.segment_index[hit.segment]);
            REQUIRE(contact.bead[0].node[i].xi == hit.xi);
        }
    }
}

TEST_CASE("beads over nothing") {
    const Sheet s;
    const BeadInput bead{{{0, 0, 0}, {1, 0, 0}}, 100, 5, 0};
    const SurfaceContact contact =
        surface_contact(s.mesh(), std::span(&bead, 1), [](uint32_t) { return SegmentStiffness{}; }, 0, {});
    CHECK(contact.bead[0].node.size() == 2);
    CHECK(contact.bead[0].node[0].segment == no_segment);
    CHECK(contact.bead[0].node[0].closest == no_segment);
    CHECK(contact.bead[0].nodes_346().empty());
}
