#include "geometry/segment_shape.h"
#include "rules/srf/bead_side.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace drawbead;

namespace {

/// Elements of size 1 on a map of (u, v) to space, u in [0, columns], v in [0, rows].
NearMesh mesh_of(uint32_t columns, uint32_t rows, const std::function<Vec3(double, double)>& map,
                 const std::vector<uint32_t>& turned_segments = {}) {
    NearMesh m;
    for (uint32_t j = 0; j <= rows; ++j)
        for (uint32_t i = 0; i <= columns; ++i)
            m.x.push_back(map(i, j));
    for (uint32_t j = 0; j < rows; ++j)
        for (uint32_t i = 0; i < columns; ++i) {
            const uint32_t a = j * (columns + 1) + i;
            m.segment.push_back({a, a + 1, a + columns + 2, a + columns + 1});
        }
    for (const uint32_t s : turned_segments)
        m.segment[s] = turned(m.segment[s]);
    return m;
}

void finish(NearMesh& m) {
    m.around_begin.assign(m.x.size() + 1, 0);
    m.around.clear();
    for (uint32_t n = 0; n < m.x.size(); ++n) {
        for (uint32_t s = 0; s < m.segment.size(); ++s)
            if (std::find(m.segment[s].begin(), m.segment[s].end(), n) != m.segment[s].end())
                m.around.push_back(s);
        m.around_begin[n + 1] = static_cast<uint32_t>(m.around.size());
    }
}

Vec3 flat(double u, double v) {
    return {u, v, 0};
}

/// A bead node over a flat part of the mesh, d measured along the segment's normal.
BeadFoot over(const NearMesh& m, uint32_t segment, double height) {
    Corners c;
    for (std::size_t k = 0; k < 4; ++k)
        c[k] = m.x[m.segment[segment][k]];
    BeadFoot f;
    f.segment = segment;
    f.foot = centroid(c);
    f.bead = f.foot + Vec3{0, 0, height};
    f.d = dot(unit(area_vector(c)), f.bead - f.foot);
    f.element = std::sqrt(area(c));
    return f;
}

/// A bead along v over column `column` of a mesh of `columns` columns, one node per element.
struct Bead {
    std::vector<BeadFoot> feet;
    std::vector<std::pair<uint32_t, uint32_t>> hops;
};
Bead along(const NearMesh& m, uint32_t columns, uint32_t column, uint32_t from, uint32_t to, double height) {
    Bead b;
    for (uint32_t j = from; j < to; ++j) {
        b.feet.push_back(over(m, j * columns + column, height));
        if (b.feet.size() > 1)
            b.hops.emplace_back(static_cast<uint32_t>(b.feet.size() - 2),
                                static_cast<uint32_t>(b.feet.size() - 1));
    }
    return b;
}

std::vector<uint32_t> away(const BeadSide& side) {
    std::vector<uint32_t> out;
    for (const ZoneSegment& z : side.zone)
        if (z.facing == Facing::away) out.push_back(z.segment);
    return out;
}

BeadSide judged(NearMesh& m, const Bead& b) {
    finish(m);
    return judge_side(m, b.feet, b.hops);
}

} // namespace

TEST_CASE("a sheet that looks at its bead is judged whole, from below too") {
    NearMesh m = mesh_of(12, 8, flat);
    const BeadSide above = judged(m, along(m, 12, 5, 1, 7, 4));
    CHECK(above.patches == 1);
    CHECK(above.count(Facing::toward) == above.zone.size());
    CHECK(above.zone.size() < m.segment.size()); // far columns are not judged
    const BeadSide below = judged(m, along(m, 12, 5, 1, 7, -4));
    CHECK(below.count(Facing::away) == below.zone.size());
    CHECK(std::all_of(below.node.begin(), below.node.end(), [](Facing f) { return f == Facing::away; }));
}

TEST_CASE("single turned segments are found under the bead and beside it, not far from it") {
    // Column 5 holds the bead, its line is at u = 5.5; reach is 3 elements from there.
    NearMesh m = mesh_of(20, 8, flat, {3 * 20 + 5, 4 * 20 + 8, 4 * 20 + 12});
    const BeadSide side = judged(m, along(m, 20, 5, 1, 7, 4));
    CHECK(away(side) == std::vector<uint32_t>{3 * 20 + 5, 4 * 20 + 8});
    CHECK(std::count(side.node.begin(), side.node.end(), Facing::away) == 1);
}

TEST_CASE("a turned segment between two bead nodes has none of its own and is judged by its neighbours") {
    NearMesh m = mesh_of(12, 8, flat, {4 * 12 + 5});
    Bead b = along(m, 12, 5, 1, 7, 4);
    b.feet.erase(b.feet.begin() + 3); // the one over row 4
    b.hops.pop_back();
    CHECK(away(judged(m, b)) == std::vector<uint32_t>{4 * 12 + 5});
}

TEST_CASE("the bead decides, not the majority") {
    std::vector<uint32_t> most;
    for (uint32_t s = 0; s < 12 * 8; ++s)
        if (s % 12 != 5) most.push_back(s);
    NearMesh m = mesh_of(12, 8, flat, most);
    const BeadSide side = judged(m, along(m, 12, 5, 1, 7, 4));
    CHECK(side.patches == 3);
    for (const ZoneSegment& z : side.zone)
        CHECK((z.facing == Facing::toward) == (z.segment % 12 == 5));
}

TEST_CASE("half of the bead over turned elements") {
    std::vector<uint32_t> half;
    for (uint32_t s = 12 * 4; s < 12 * 8; ++s)
        half.push_back(s);
    NearMesh m = mesh_of(12, 8, flat, half);
    const BeadSide side = judged(m, along(m, 12, 5, 0, 8, 4));
    for (const ZoneSegment& z : side.zone)
        CHECK(z.facing == (z.segment >= 12 * 4 ? Facing::away : Facing::toward));
}

TEST_CASE("a bead in the surface or beside it is not guessed at") {
    NearMesh m = mesh_of(12, 8, flat);
    Bead in = along(m, 12, 5, 1, 7, 1e-5);
    in.feet[2] = over(m, in.feet[2].segment, -1e-5);
    CHECK(judged(m, in).count(Facing::unknown) == judged(m, in).zone.size());
    Bead beside = along(m, 12, 5, 1, 7, 3);
    for (BeadFoot& f : beside.feet)
        f.beside = true;
    CHECK(judged(m, beside).count(Facing::unknown) == judged(m, beside).zone.size());
    CHECK(judge_side(m, {}, {}).zone.empty());
}

TEST_CASE("a bead that crosses the surface is not judged, one that dips into it is") {
    NearMesh m = mesh_of(12, 8, flat);
    Bead b = along(m, 12, 5, 0, 8, 3);
    b.feet[3] = over(m, b.feet[3].segment, -0.05);
    const BeadSide dips = judged(m, b);
    CHECK(dips.count(Facing::toward) == dips.zone.size());
    for (std::size_t i = 4; i < 8; ++i)
        b.feet[i] = over(m, b.feet[i].segment, -3);
    const BeadSide crosses = judged(m, b);
    CHECK(crosses.count(Facing::unknown) == crosses.zone.size());
}

TEST_CASE("walls beside the bead follow their neighbours, whatever the bead sees of them") {
    // A flange (u to 3), a wall going down, and a bottom that looks up again: one sheet of one orientation;
    // beyond the wall, a hem that looks down because the sheet is folded over.
    const auto channel = [](double u, double v) {
        if (u <= 3) return Vec3{u, v, 0};
        if (u <= 4) return Vec3{3, v, 3 - u};
        return Vec3{7 - u, v, -1}; // folded back under the flange
    };
    NearMesh m = mesh_of(7, 6, channel);
    const BeadSide side = judged(m, along(m, 7, 1, 0, 6, 2));
    CHECK(side.zone.size() == m.segment.size());
    CHECK(side.count(Facing::toward) == m.segment.size());
}

TEST_CASE("a patch that hangs together with nothing is judged as it sees the bead") {
    NearMesh m = mesh_of(12, 8, flat);
    const auto island = static_cast<uint32_t>(m.x.size());
    for (const Vec3 x : {Vec3{6.2, 8.5, 0}, Vec3{6.2, 9.5, 0}, Vec3{7.2, 9.5, 0}, Vec3{7.2, 8.5, 0}})
        m.x.push_back(x);
    m.segment.push_back({island, island + 1, island + 2, island + 3}); // looks down
    const Bead b = along(m, 12, 5, 1, 8, 4);
    CHECK(away(judged(m, b)) == std::vector<uint32_t>{12 * 8});
    std::vector<uint8_t> solid(m.segment.size(), 0);
    solid.back() = 1;
    CHECK(away(judge_side(m, b.feet, b.hops, solid)).empty());
}

TEST_CASE("a zone reaches along hops that are longer than elements, and over gaps it does not") {
    NearMesh m = mesh_of(12, 40, flat, {20 * 12 + 6});
    Bead b;
    b.feet = {over(m, 5, 4), over(m, 39 * 12 + 5, 4)};
    CHECK(away(judged(m, b)).empty());
    b.hops = {{0, 1}};
    CHECK(away(judged(m, b)) == std::vector<uint32_t>{20 * 12 + 6});
}
