// Hard cases of the solver's search: start, tracking from cycle to cycle, projection.
#include "contact/bead_contact.h"
#include "contact/solver_search.h"
#include "study/hard_case_table.h"

#include <array>

namespace drawbead {

namespace {

/// Segments over nodes 1, 2, …
struct Sheet {
    std::vector<Vec3> x;
    std::vector<SegmentNodes> segment;
    std::vector<uint32_t> id;

    Sheet(std::vector<Vec3> at, std::vector<SegmentNodes> nodes)
        : x(std::move(at)), segment(std::move(nodes)) {
        for (uint32_t i = 0; i < x.size(); ++i)
            id.push_back(i + 1);
    }
    SegmentMesh view() const {
        SegmentMesh mesh;
        mesh.segment = segment;
        mesh.x = x;
        mesh.node_id = id;
        return mesh;
    }
    NearMesh whole() const { return near_mesh(view(), {}, whole_surface); }
};

/// n × n squares of side 1.
Sheet squares(uint32_t n, double side = 1) {
    std::vector<Vec3> x;
    std::vector<SegmentNodes> segment;
    for (uint32_t j = 0; j <= n; ++j)
        for (uint32_t i = 0; i <= n; ++i)
            x.push_back({side * i, side * j, 0});
    for (uint32_t j = 0; j < n; ++j)
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t at = (n + 1) * j + i;
            segment.push_back({at, at + 1, at + n + 2, at + n + 1});
        }
    return {std::move(x), std::move(segment)};
}

double weight_error(const SolverHit& hit) {
    const double sum = hit.h[0] + hit.h[1] + hit.h[2] + hit.h[3];
    return std::isfinite(hit.d) && std::isfinite(norm(hit.normal)) ? std::abs(sum - 1) : HUGE_VAL;
}

HardCaseResult point_segment() {
    const Vec3 p{1, 2, 3};
    return within(weight_error(solver_project({p, p, p, p}, false, {2, 2, 2})), 0);
}

HardCaseResult point_triangle() {
    const Vec3 p{1, 2, 3};
    return within(weight_error(solver_project({p, p, p, p}, true, {2, 2, 2})), 0);
}

HardCaseResult tie_between_nodes() {
    // Over the middle of an edge, tracked from the node with the larger number.
    const NearMesh mesh = squares(2).whole();
    Track track{4, 3};
    solver_follow(track, mesh, mesh.x, {0.5, 1, 1});
    return within(std::abs(double(track.nearest) - 3), 0);
}

HardCaseResult tie_between_segments() {
    // Two segments on one side of a gap, equally far from the node: the smaller quadruple of node numbers.
    const Sheet sheet({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}},
                      {{0, 4, 5, 6}, {0, 3, 2, 1}, {0, 1, 2, 3}});
    const NearMesh mesh = sheet.whole();
    Track track{0, 1}; // the same square, seen from behind: equal in every number
    Track other = track;
    solver_follow(track, mesh, mesh.x, {0.4375, -0.25, 1});
    // The quadruple (0, 1, 2, 3) is smaller than (0, 3, 2, 1).
    other.segment = 2;
    solver_follow(other, mesh, mesh.x, {0.4375, -0.25, 1});
    return within(std::abs(double(track.segment) - 2) + std::abs(double(other.segment) - 2), 0);
}

HardCaseResult collapsed_segment() {
    // A node whose segment has no area moves on over a sound one.
    const Sheet sheet({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}},
                      {{0, 0, 0, 0}, {0, 1, 2, 3}});
    const NearMesh mesh = sheet.whole();
    Track track{0, 0};
    solver_follow(track, mesh, mesh.x, {0.25, 0.25, 1});
    return within(std::abs(double(track.segment) - 1), 0);
}

HardCaseResult one_ring_per_cycle() {
    const NearMesh mesh = squares(20).whole();
    Track track{0, 0};
    const Vec3 bead{10.25, 0.25, 0.5}; // ten segments on
    int cycles = 0;
    while (track.segment != 10 && cycles < 100) {
        solver_follow(track, mesh, mesh.x, bead);
        ++cycles;
    }
    return broken_by(cycles, 10, 0);
}

HardCaseResult squared_reach() {
    // The start node of a node between two clusters of the blank, in millimetres and in metres.
    const auto start = [](double unit) {
        std::vector<Vec3> x{{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}};
        for (int i = 0; i < 10; ++i)
            for (int j = 0; j < 10; ++j)
                x.push_back({41.0 + 0.1 * i, 43.0 + 0.1 * j, 0});
        x.push_back({49.9, 40.1, 0});
        x.push_back({60.5, 40, 0});
        for (Vec3& p : x)
            p = unit * p;
        std::vector<SegmentNodes> segment;
        for (uint32_t i = 0; i + 3 < x.size(); ++i)
            segment.push_back({i, i + 1, i + 2, i + 3});
        const Sheet sheet(std::move(x), std::move(segment));
        const NearMesh mesh = sheet.whole();
        double worst = 0; // how much farther the start node is than the nearest
        for (int i = 0; i < 40; ++i)
            for (int j = 0; j < 40; ++j) {
                const Vec3 bead = unit * Vec3{2.5 * i, 2.5 * j, 1};
                const auto node = StartSearch(mesh, std::span(&bead, 1)).start_node(bead);
                double nearest = HUGE_VAL;
                for (const Vec3& p : mesh.x)
                    nearest = std::min(nearest, distance(p, bead));
                if (node) worst = std::max(worst, distance(mesh.x[*node], bead) / nearest - 1);
            }
        return worst;
    };
    const double in_millimetres = start(1), in_metres = start(1e-3);
    // Never too far in millimetres; in metres by some share of the distance.
    return {in_metres > 0.01 && in_millimetres == 0 ? 1.0 : 0.0, 1, 0};
}

HardCaseResult stays_of_coincident_nodes() {
    // Two nodes of a ring in one place: where the track may change is not known.
    const Sheet sheet({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {-1, 1, 0}},
                      {{0, 1, 2, 3}, {0, 3, 6, 4}});
    const NearMesh mesh = sheet.whole();
    const Track track{0, 0};
    return within(TrackRegion(track, mesh, mesh.x, {0.25, 0.25, 1}).margin({}), 0);
}

HardCaseResult crowded_node() {
    // 24 triangles about one node: more neighbours than a region has planes.
    std::vector<Vec3> x{{0, 0, 0}};
    std::vector<SegmentNodes> segment;
    for (uint32_t i = 0; i < 24; ++i) {
        const double angle = 2 * 3.14159265358979323846 * i / 24;
        x.push_back({std::cos(angle), std::sin(angle), 0});
        const uint32_t next = i == 23 ? 1 : i + 2;
        segment.push_back({0, i + 1, next, next});
    }
    const NearMesh mesh = Sheet(std::move(x), std::move(segment)).whole();
    return within(TrackRegion(Track{0, 0}, mesh, mesh.x, {0.25, 0.01, 1}).margin({}), 0);
}

HardCaseResult no_sample_size() {
    const Sheet sheet({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2, 2}});
    return within(first_reach(sheet.view()) == whole_surface ? 0 : 1, 0);
}

HardCaseResult no_length() {
    const SolverTributary one = solver_tributary({0, 0, 1}, {0, 0, 3});
    return within(std::abs(one.l2 - 1e-20) / 1e-20 + std::abs(one.l - 1e-10) / 1e-10, 4 * eps<double>);
}

HardCaseResult absent_depth() {
    SolverHit hit;
    hit.d = 1e6;
    Largest error;
    for (const double depth : {0.0, -1.0, -1e300})
        error.add(std::abs(solver_penetration(hit, depth, 0.5) - 1));
    return within(error.value(), 0);
}

HardCaseResult flat_blank() {
    // A bead in the plane of a flat blank: no extent along z.
    const Sheet sheet = squares(10);
    std::vector<BeadInput> beads(1);
    for (int i = 0; i < 5; ++i)
        beads[0].x.push_back({2.5, 2.25 + i, 0});
    beads[0].fn_first = 100;
    beads[0].depth = 5;
    const auto contact = surface_contact(
        sheet.view(), beads, [](uint32_t) { return of_shell(210000, 1); }, 42000,
        std::vector<double>(100, 42000.0));
    Largest error;
    for (std::size_t i = 0; i < 5; ++i) {
        const BeadNodeContact& node = contact.bead[0].node[i];
        error.add(std::abs(double(node.segment) - (10.0 * (2 + double(i)) + 2)));
        error.add(std::abs(node.distance));
    }
    return within(error.value(), 0);
}

HardCaseResult volume_of_nothing() {
    return within(std::abs(solid_face_stiffness(25, 175000, 0)), 0);
}

HardCaseResult slope_of_no_stiffness() {
    // A void blank: Fn/DEPTH stays, or the bead would have no force at all.
    const SlopeChoice slope = choose_slope(100, 5, 0);
    return within(slope.kind == Slope::ramp ? std::abs(slope.of(0) - 20) : HUGE_VAL, 0);
}

HardCaseResult slope_of_no_depth() {
    Largest error;
    for (const double depth : {0.0, 1e-20, 1e-300, -5.0}) {
        const SlopeChoice slope = choose_slope(100, depth, 42000);
        error.add(slope.kind == Slope::depth_absent ? std::abs(slope.of(42000) - 42000) : HUGE_VAL);
    }
    return within(error.value(), 0);
}

HardCaseResult slope_in_metres() {
    // 100 N/mm over 1 mm on 1 mm of steel, and the same in metres.
    const bool mm = choose_slope(100, 1, 0.2 * 210000 * 1).kind == Slope::reset;
    const bool m = choose_slope(1e5, 1e-3, 0.2 * 210e9 * 1e-3).kind == Slope::reset;
    return broken_by(mm == m ? 0 : 1, 1, 0);
}

HardCaseResult slope_past_the_table() {
    // More bead nodes than segments: the Engine reads what lies behind its table.
    const SlopeChoice slope{Slope::reset, 0};
    const std::vector<double> k{1, 2, 3};
    Largest error;
    for (std::size_t i = 0; i < 3; ++i)
        error.add(slope_read(slope, k, 3, i) ? std::abs(*slope_read(slope, k, 3, i) - k[i]) : HUGE_VAL);
    for (const std::size_t i : {3u, 4u, 1000u})
        error.add(slope_read(slope, k, 3, i) ? 1 : 0);
    return within(error.value(), 0);
}

HardCaseResult slope_of_another_segment() {
    // After a reset on a blank of two stiffnesses the third bead node reads the third segment's.
    const std::vector<double> k{42000, 42000, 84000, 84000};
    return broken_by(*slope_read({Slope::reset, 0}, k, 4, 2) - 42000, 42000, 0);
}

} // namespace

std::vector<HardCaseRow> solver_search_cases() {
    constexpr Law law = Law::solver;
    return {
        {"project-point-segment", law, must_hold, "A segment whose corners are one point.",
         "Weights are finite and sum to 1.", "contact/solver_search.cpp: zero denominator of ξ",
         point_segment},
        {"project-point-triangle", law, must_hold, "A triangle whose corners are one point.",
         "Weights are finite and sum to 1.", "contact/solver_search.cpp: a₁ = 0", point_triangle},
        {"tie-between-nodes", law, must_hold, "A bead node equally far from two main nodes.",
         "The smaller user id, wherever the track comes from.", "contact/solver_search.cpp: tie of nodes",
         tie_between_nodes},
        {"tie-between-segments", law, must_hold, "Two segments on which the corner test is equal.",
         "The smaller quadruple of node ids.", "contact/solver_search.cpp: tie of segments",
         tie_between_segments},
        {"collapsed-segment", law, must_hold, "The tracked segment has no area.",
         "The node moves on to a sound one.", "contact/solver_search.cpp: isnan", collapsed_segment},
        {"one-ring-per-cycle", law, is_broken, "A node ten segments away from its track.",
         "Its segment is found in the next cycle; measured: the cycles that it takes.", "",
         one_ring_per_cycle},
        {"start-in-metres", law, is_broken, "The same blank in millimetres and in metres.",
         "Each start node is the nearest one in both; measured: 1 when that fails in metres alone.", "",
         squared_reach},
        {"region-coincident-nodes", law, must_hold, "Two main nodes in one place under a bead node.",
         "Nothing is promised about its track.", "contact/solver_search.cpp: margin of a NaN",
         stays_of_coincident_nodes},
        {"region-crowded-node", law, must_hold, "A main node with 24 segments.",
         "Nothing is promised about the track.", "contact/solver_search.cpp: no planes", crowded_node},
        {"reach-without-size", law, must_hold, "A surface whose segments have no size.", "It is taken whole.",
         "contact/segment_mesh.cpp: reach > 0", no_sample_size},
        {"tributary-without-length", law, must_hold, "The bead stands perpendicular to the blank.",
         "L = 1e-10, as the Engine takes it.", "contact/solver_search.cpp: max(T·T, 1e-20)", no_length},
        {"depth-absent", law, must_hold, "DEPTH = 0, −1 and −1e300.", "δ = 1, as the Engine takes it.",
         "contact/solver_search.cpp: depth > 0", absent_depth},
        {"flat-blank", law, must_hold, "A bead in the plane of a flat blank: boxes without height.",
         "The segments below are found, distance 0.", "", flat_blank},
        {"solid-without-volume", law, must_hold, "The face of a solid without volume.", "k = 0, no division.",
         "contact/blank_stiffness.cpp: volume > 0", volume_of_nothing},
        {"slope-of-void", law, must_hold, "A blank without stiffness.", "The slope stays Fn/DEPTH.",
         "contact/blank_stiffness.cpp: smallest_k != 0", slope_of_no_stiffness},
        {"slope-without-depth", law, must_hold, "DEPTH of 0, 1e-20, 1e-300 and −5.",
         "The slope is k, no division.", "contact/blank_stiffness.cpp: depth <= 1e-20", slope_of_no_depth},
        {"slope-in-metres", law, is_broken, "The same bead in millimetres and in metres.",
         "Reset in both or in none; measured: 1 when they differ.", "", slope_in_metres},
        {"slope-past-the-table", law, must_hold, "More bead nodes than segments.",
         "No value is made up for those past the end.", "contact/blank_stiffness.cpp: bead_node >= segments",
         slope_past_the_table},
        {"slope-of-another-segment", law, is_broken, "A reset on a blank of two stiffnesses.",
         "Each node has its own segment's slope; measured: how far the third one's is off.", "",
         slope_of_another_segment},
    };
}

} // namespace drawbead
