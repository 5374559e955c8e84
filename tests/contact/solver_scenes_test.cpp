// Scenes that were run through the real solver: the Starter's messages and the first traced cycle.
#include "bead/bead_line.h"
#include "scene.h"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace drawbead;

namespace {

std::vector<std::string> scene_files() {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(DRAWBEAD_TESTS_DIR "/contact/data"))
        if (entry.path().extension() == ".txt") files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

void require_near(double ours, double theirs, double scale) {
    REQUIRE(std::abs(ours - theirs) <= 1e-12 * std::max(scale, std::abs(theirs)));
}

SurfaceContact contact_of(const Scene& scene, const Scene::Bead& bead) {
    const auto& surface = scene.surface[bead.surface];
    const BeadInput input{scene.positions(bead), bead.fn, bead.depth, 0};
    return surface_contact(
        scene.mesh(bead), std::span(&input, 1), [&](uint32_t s) { return surface.stiffness[s]; },
        smallest_stiffness(surface.stiffness), surface.k);
}

} // namespace

TEST_CASE("the Starter says what we foresee") {
    for (const std::string& file : scene_files()) {
        const Scene scene = read_scene(file);
        CAPTURE(scene.name);
        std::set<int> ours;
        for (const auto& bead : scene.bead) {
            const SurfaceContact contact = contact_of(scene, bead);
            const StarterVerdict verdict =
                starter_verdict({bead.ordered, bead.iform, scene.admesh_idt, bead.fn, bead.depth,
                                 smallest_stiffness(scene.surface[bead.surface].stiffness)},
                                contact.bead[0].nodes_346());
            if (verdict.error_112) ours.insert(112);
            if (verdict.error_703) ours.insert(703);
            if (verdict.warning_1040) ours.insert(1040);
            if (verdict.warning_1043) ours.insert(1043);
            if (!verdict.nodes_346.empty()) ours.insert({346, 499});
            if (verdict.error_112)
                continue; // a sorted group: the order that the Starter saw is not in the deck
            std::vector<uint32_t> warned;
            for (const uint32_t place : verdict.nodes_346)
                warned.push_back(scene.id[bead.node[place]]);
            std::sort(warned.begin(), warned.end());
            REQUIRE(warned == bead.warned);
        }
        std::set<int> theirs = scene.messages;
        theirs.erase(312); // of /BCS, not of the interface
        REQUIRE(ours == theirs);
    }
}

TEST_CASE("the first traced cycle is the solver's") {
    std::size_t rows = 0;
    for (const std::string& file : scene_files()) {
        const Scene scene = read_scene(file);
        for (std::size_t b = 0; b < scene.bead.size(); ++b) {
            const auto& bead = scene.bead[b];
            const SurfaceContact contact = contact_of(scene, bead);
            std::vector<Track> track = contact.track[0];
            std::vector<Vec3> blank = contact.mesh.x;
            for (Vec3& p : blank)
                p += scene.moved;
            const std::vector<Vec3> x = scene.positions(bead);
            const BeadLine line = bead_line(x);
            const bool varies = bead.fn_last != 0 || bead.ft_last != 0;
            for (const auto& row : scene.row) {
                if (row.bead != static_cast<int>(b) + 1) continue;
                CAPTURE(scene.name, row.node);
                const auto i = static_cast<std::size_t>(row.place) - 1;
                REQUIRE(row.node == scene.id[bead.node[i]]);
                REQUIRE(row.x == x[i]);
                const SolverHit hit = solver_step(track[i], contact.mesh, blank, x[i]);
                std::array<uint32_t, 4> segment;
                for (std::size_t k = 0; k < 4; ++k)
                    segment[k] = contact.mesh.node_id[contact.mesh.segment[hit.segment][k]];
                REQUIRE(segment == row.segment);
                REQUIRE(hit.inside == row.inside);
                require_near(hit.xi, row.xi, 1);
                require_near(hit.eta, row.eta, 1);
                // Sums run in the solver's order: where nothing has moved, the last bit agrees.
                if (scene.moved == Vec3{})
                    REQUIRE((hit.xi == row.xi && hit.eta == row.eta && hit.d == row.d));
                for (std::size_t k = 0; k < 4; ++k)
                    require_near(hit.h[k], row.h[k], 1);
                require_near(hit.d, row.d, 50);
                const SegmentStiffness s =
                    scene.surface[bead.surface].stiffness[contact.mesh.segment_index[hit.segment]];
                require_near(s.k, row.k, 0);
                require_near(s.half_thickness, row.g, 0);
                const double pen = solver_penetration(hit, bead.depth, s.half_thickness);
                require_near(pen, row.pen, 50);
                const SlopeChoice slope = contact.bead[0].slope;
                require_near(slope.of(s.k), row.slope, 0);
                if (const auto read = slope_read(slope, scene.surface[bead.surface].k,
                                                 scene.surface[bead.surface].k.size(), i))
                    require_near(*read, row.slope_read, 0);
                else
                    REQUIRE(i >= scene.surface[bead.surface].segment.size());
                if (pen > 0) {
                    const SolverTributary t = solver_tributary(hit.normal, line.half_chord[i]);
                    require_near(t.l2, row.l2, 0);
                    require_near(t.l, row.l, 0);
                }
                if (varies) {
                    require_near(line.s[i], row.s, 0);
                    require_near(line.length, row.s_total, 0);
                }
                require_near(limit_along(bead.fn, bead.fn_last, line.s[i], line.length), row.fn, 0);
                require_near(limit_along(bead.ft, bead.ft_last, line.s[i], line.length), row.ft, 0);
                ++rows;
            }
        }
    }
    REQUIRE(rows > 500);
}
