// Hard cases of the closest point of a segment and of a surface, which the manual's law stands on.
#include "contact/closest_segment.h"
#include "study/hard_case_table.h"

#include <array>

namespace drawbead {

namespace {

/// Distance by brute force: a fine net over the patch.
double sampled_distance(const Corners& c, Vec3 x) {
    constexpr int n = 400;
    double best = HUGE_VAL;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
            best = std::min(best, norm(x - patch_point(c, 2.0 * i / n - 1, 2.0 * j / n - 1)));
    return best;
}

bool is_finite(const Foot& foot) {
    for (const double v : {foot.point.x, foot.point.y, foot.point.z, foot.normal.x, foot.normal.y,
                           foot.normal.z, foot.xi, foot.eta, foot.distance})
        if (!std::isfinite(v)) return false;
    return true;
}

/// Segments over nodes 1, 2, …
class Sheet {
public:
    Sheet(std::vector<Vec3> x, std::vector<SegmentNodes> segment)
        : x_(std::move(x)), segment_(std::move(segment)) {
        for (uint32_t i = 0; i < x_.size(); ++i)
            id_.push_back(i + 1);
        SegmentMesh view;
        view.segment = segment_;
        view.x = x_;
        view.node_id = id_;
        mesh = near_mesh(view, {}, whole_surface);
    }
    NearMesh mesh;

private:
    std::vector<Vec3> x_;
    std::vector<SegmentNodes> segment_;
    std::vector<uint32_t> id_;
};

/// n × n squares of side 1 from the origin, moved and scaled.
Sheet squares(uint32_t n, Vec3 origin = {}, double side = 1) {
    std::vector<Vec3> x;
    std::vector<SegmentNodes> segment;
    for (uint32_t j = 0; j <= n; ++j)
        for (uint32_t i = 0; i <= n; ++i)
            x.push_back(origin + side * Vec3{double(i), double(j), 0});
    for (uint32_t j = 0; j < n; ++j)
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t at = (n + 1) * j + i;
            segment.push_back({at, at + 1, at + n + 2, at + n + 1});
        }
    return {std::move(x), std::move(segment)};
}

HardCaseResult point_segment() {
    const Vec3 p{1, 2, 3};
    const Foot foot = closest_point({p, p, p, p}, {1, 2, 7});
    return within(is_finite(foot) ? std::abs(foot.distance - 4) : HUGE_VAL, 0);
}

HardCaseResult point_quad_without_normal() {
    // Four corners on one line, none of them the same.
    const Foot foot = closest_point({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}}, {1.5, 0, 2});
    return within(is_finite(foot) ? std::abs(foot.distance - 2) + norm(foot.normal) : HUGE_VAL, 0);
}

HardCaseResult triangle_inside() {
    const Foot foot = closest_point({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 4, 0}}}, {1, 1, 2});
    return within(std::abs(foot.distance - 2) + norm(foot.point - Vec3{1, 1, 0}), 16 * eps<double>);
}

HardCaseResult flat_triangle() {
    const Foot foot = closest_point({{{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {8, 0, 0}}}, {6, 0, 2});
    return within(is_finite(foot) ? std::abs(foot.distance - 2) : HUGE_VAL, 0);
}

HardCaseResult corner_within_rounding() {
    const Foot foot = closest_point({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}},
                                    {4 + 2 * eps<double>, 4 - 2 * eps<double>, 1});
    return within(std::abs(foot.edges - 0b0110) + norm(foot.point - Vec3{4, 4, 0}), 0);
}

HardCaseResult concave_quad() {
    const Corners c{{{0, 0, 0}, {4, 0, 0}, {0.5, 0.5, 0}, {0, 4, 0}}};
    Largest error;
    for (const Vec3 x : {Vec3{2, 2, 0.1}, Vec3{1.5, 0.1, 1}, Vec3{0.2, 0.2, 1}, Vec3{3, 3, 0}})
        error.add(std::abs(closest_point(c, x).distance - sampled_distance(c, x)));
    return within(error.value(), 4.0 / 400);
}

HardCaseResult second_root() {
    // Warped: the ruling's stationary point lies on the patch's continuation, beside an edge.
    const Corners c{{{0, 0, 0}, {4, 0, 2}, {4, 4, 0}, {0, 4, 2}}};
    Largest error;
    for (const Vec3 x : {Vec3{-3, 2, 4}, Vec3{7, 2, 4}, Vec3{2, -4, -3}, Vec3{2, 9, 3}, Vec3{-2, -2, -2}}) {
        const Foot foot = closest_point(c, x);
        error.add(std::abs(foot.distance - sampled_distance(c, x)));
        error.add(std::abs(foot.xi) > 1 || std::abs(foot.eta) > 1 ? 1 : 0);
    }
    return within(error.value(), 1e-3);
}

HardCaseResult collinear_corner() {
    // At corner 3 both edges run along the same line.
    const Corners c{{{0, 0, 0}, {4, 0, 0}, {2, 2, 0}, {0, 4, 0}}};
    const Vec3 n = patch_normal(c, 1, 1);
    return within(norm(n - Vec3{0, 0, 1}), 4 * eps<double>);
}

HardCaseResult needle() {
    Largest error;
    for (const double thin : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const Corners c{{{0, 0, 0}, {1000, 0, 0}, {1000, thin, 0}, {0, thin, 0}}};
        const Foot foot = closest_point(c, {300, thin / 2, 2});
        const auto h = bilinear_weights(foot.xi, foot.eta);
        error.add(is_finite(foot) ? std::abs(foot.distance - 2) : HUGE_VAL);
        error.add(std::abs(h[0] + h[1] + h[2] + h[3] - 1));
        error.add(std::abs(foot.point.x - 300) / 1000);
    }
    return within(error.value(), 8 * eps<double>);
}

HardCaseResult any_size() {
    const Corners c{{{-1, -1, 0}, {1.25, -1, 0.25}, {1, 1.125, 0}, {-1, 1, 0.375}}};
    const Vec3 x{0.25, 0.5, 2};
    const Foot one = closest_point(c, x);
    Largest error;
    for (int exponent = -990; exponent <= 990; exponent += 30) {
        const double s = std::ldexp(1.0, exponent); // a power of two: nothing is rounded
        Corners scaled = c;
        for (Vec3& p : scaled)
            p = s * p;
        const Foot foot = closest_point(scaled, s * x);
        error.add(is_finite(foot) ? std::abs(foot.distance / s - one.distance) : HUGE_VAL);
        error.add(std::abs(foot.xi - one.xi) + std::abs(foot.eta - one.eta));
        error.add(norm(foot.normal - one.normal));
    }
    return within(error.value(), 1e-12);
}

HardCaseResult shared_edge() {
    // Over the edge of the first two segments: the smaller one, whichever is looked at first.
    const Sheet sheet = squares(2);
    const ClosestSegment closest(sheet.mesh);
    Largest error;
    error.add(closest.find({1, 0.5, 1}).segment);
    error.add(closest.find({1, 1, 1}).segment);
    // The same node numbers in the other order of segments.
    const Sheet turned({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}},
                       {{1, 2, 5, 4}, {0, 1, 4, 3}});
    const ClosestHit hit = ClosestSegment(turned.mesh).find({1, 0.5, 1});
    error.add(hit.segment);
    error.add(std::abs(hit.d - 1));
    return within(error.value(), 0);
}

HardCaseResult foot_inside_wins() {
    // A step: the first segment's edge is as near as the inside of the second.
    const Sheet sheet(
        {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {1.5, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1.5, 1, 0}},
        {{0, 1, 2, 3}, {4, 5, 6, 7}});
    const ClosestHit hit = ClosestSegment(sheet.mesh).find({2, 0.5, 1});
    return within(hit.found() ? std::abs(double(hit.segment) - 1) : HUGE_VAL, 0);
}

HardCaseResult edge_margin() {
    // Offsets about 5 % of a segment of side 1 (binary fractions), from both sides.
    const Sheet sheet = squares(4);
    const ClosestSegment closest(sheet.mesh);
    Largest error;
    const auto contact = [&](double x) { return closest.find({x, 2.5, 0}).in_contact_range(); };
    const double limit = 4 + 0.05 - eps<double> * 4;
    double low = 4, high = 4.5;
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (contact(middle) ? low : high) = middle;
    }
    error.add(std::abs(low - limit));
    for (int k = 0; k < 4; ++k) { // no hysteresis
        error.add(contact(low) ? 0 : 1);
        error.add(contact(high) ? 1 : 0);
    }
    ClosestHit exactly = closest.find({4.5, 2.5, 0});
    exactly.offset = 0.05;
    error.add(exactly.in_contact_range() ? 0 : 1);
    return within(error.value(), 16 * eps<double>);
}

HardCaseResult point_on_the_edge() {
    // A node in the very place of a segment that has shrunk to a point.
    const Sheet sheet({{1, 1, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}});
    const ClosestHit hit = ClosestSegment(sheet.mesh).find({1, 1, 0});
    return within(hit.found() ? hit.offset : HUGE_VAL, 0);
}

HardCaseResult zero_area_neighbour() {
    // The middle one of three strips has no width.
    const Sheet sheet(
        {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 1, 0}, {2, 1, 0}},
        {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}});
    const ClosestSegment closest(sheet.mesh);
    Largest error;
    for (const double x : {0.25, 0.75, 1.25, 1.75}) {
        const ClosestHit hit = closest.find({x, 0.5, 1});
        error.add(std::abs(hit.d - 1));
        error.add(std::abs(double(hit.segment) - (x < 1 ? 0 : 2)));
    }
    return within(error.value(), 0);
}

HardCaseResult empty_surface() {
    const Sheet sheet({}, {});
    const ClosestHit hit = ClosestSegment(sheet.mesh).find({1, 2, 3});
    return within(hit.found() || hit.in_contact_range() || !hit.exact ? 1 : 0, 0);
}

HardCaseResult behind_the_surface() {
    const Sheet sheet = squares(2);
    return within(std::abs(ClosestSegment(sheet.mesh).find({0.5, 0.5, -0.25}).d + 0.25), 0);
}

HardCaseResult jump_over_elements() {
    const Sheet sheet = squares(20);
    const ClosestSegment closest(sheet.mesh);
    Largest error;
    for (int i = 0; i < 50; ++i) {
        const Vec3 x{std::fmod(7.3 * i, 20), std::fmod(11.9 * i, 20), 0.25};
        double best = HUGE_VAL;
        for (uint32_t s = 0; s < sheet.mesh.segment.size(); ++s)
            best = std::min(best, closest_point(sheet.mesh.corners(s), x).distance);
        error.add(std::abs(closest.find(x).foot.distance - best));
    }
    return within(error.value(), 0);
}

HardCaseResult far_away() {
    Largest error;
    for (const double offset : {1e6, 1e9}) {
        const Sheet sheet = squares(4, {offset, -offset, 0});
        const ClosestSegment closest(sheet.mesh);
        const ClosestHit hit = closest.find({offset + 1.3, 2.6 - offset, 0.25});
        error.add(std::abs(hit.d - 0.25) / (eps<double> * offset));
        error.add(hit.foot.xi < -1 || hit.foot.xi > 1 ? HUGE_VAL : 0);
    }
    return within(error.value(), 16);
}

HardCaseResult in_metres() {
    // What only looks at its own scale does not notice one of 1e-150.
    Largest error;
    for (const double side : {1e-150, 1e-3, 1e150}) {
        const Sheet sheet = squares(4, {}, side);
        const ClosestHit hit = ClosestSegment(sheet.mesh).find(side * Vec3{2.25, 1.5, 0.25});
        error.add(std::abs(hit.d / side - 0.25) + std::abs(double(hit.segment) - 6));
    }
    return within(error.value(), 1e-12);
}

} // namespace

std::vector<HardCaseRow> closest_point_cases() {
    constexpr Law law = Law::manual;
    return {
        {"closest-point-segment", law, must_hold, "A segment whose corners are one point.",
         "Its distance is that of the point.", "geometry/closest_point.cpp: edge without length",
         point_segment},
        {"closest-line-segment", law, must_hold, "A segment whose corners are on one line.",
         "Its distance is that of the line; it has no normal.", "geometry/segment_shape.cpp: unit",
         point_quad_without_normal},
        {"closest-triangle", law, must_hold, "A node over the inside of a triangle.", "Its foot is below it.",
         "geometry/closest_point.cpp: skipped edge", triangle_inside},
        {"closest-flat-triangle", law, must_hold, "A triangle whose corners are on one line.",
         "Its distance is that of the line.", "geometry/closest_point.cpp: triangle without normal",
         flat_triangle},
        {"closest-corner", law, must_hold, "A node a rounding error beside a corner.",
         "The foot is the corner, on both its edges.", "geometry/closest_point.cpp: corner",
         corner_within_rounding},
        {"closest-concave", law, must_hold, "Nodes about a quad with a reentrant corner.",
         "The distance found by sampling the patch.", "geometry/closest_point.cpp: convex", concave_quad},
        {"closest-second-root", law, must_hold, "Nodes beside a warped quad.",
         "The distance found by sampling the patch; the foot is on it.",
         "geometry/closest_point.cpp: root outside", second_root},
        {"closest-collinear-corner", law, must_hold, "A corner whose edges are on one line.",
         "The normal is that of the segment.", "geometry/segment_shape.cpp: patch_normal", collinear_corner},
        {"closest-needle", law, must_hold, "Quads of 1000 mm by 1e-3 to 1e-12 mm.",
         "Distance to rounding, weights sum to 1.", "", needle},
        {"closest-any-size", law, must_hold, "A warped quad scaled by 2^-990 to 2^990.",
         "The same place and normal, the distance scaled.", "geometry/closest_point.cpp: scale", any_size},
        {"closest-shared-edge", law, must_hold, "A node over an edge or corner that segments share.",
         "The first segment in storage order, in whatever order they are found.",
         "contact/closest_segment.cpp: smaller segment", shared_edge},
        {"closest-foot-inside", law, must_hold, "An edge and the inside of another segment, equally near.",
         "The foot inside wins.", "contact/closest_segment.cpp: foot inside", foot_inside_wins},
        {"closest-edge-margin", law, must_hold, "A node leaves and enters at 5 % beside the free edge.",
         "Contact up to exactly 5 %, from either side.", "contact/closest_segment.h: offset <= 0.05",
         edge_margin},
        {"closest-shrunk-edge", law, must_hold, "A node in the place of a segment shrunk to a point.",
         "No offset, no NaN.", "contact/closest_segment.cpp: size > 0", point_on_the_edge},
        {"closest-zero-area", law, must_hold, "A segment without width between two sound ones.",
         "The sound ones are found, at the same distances.", "", zero_area_neighbour},
        {"closest-nothing", law, must_hold, "A surface without segments.", "No contact, and that is exact.",
         "contact/closest_segment.cpp: no candidate", empty_surface},
        {"closest-behind", law, must_hold, "A node behind the surface.", "Its distance is negative.",
         "contact/closest_segment.cpp: sign", behind_the_surface},
        {"closest-jump", law, must_hold, "A node that jumps over many segments in each step.",
         "The distance found over all segments.", "", jump_over_elements},
        {"closest-translated", law, must_hold, "The surface 1e6 and 1e9 mm away from the origin.",
         "Distance to 16 ulp of that place.", "", far_away},
        {"closest-surface-size", law, must_hold, "A surface with segments of 1e-150, 1e-3 and 1e150.",
         "The same segment, the distance scaled.", "", in_metres},
    };
}

} // namespace drawbead
