#include "bead/line_check.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <random>

using namespace drawbead;

namespace {

constexpr double pi = 3.14159265358979323846;
using Line = std::vector<Vec3>;

std::vector<uint32_t> numbers(std::size_t n) {
    std::vector<uint32_t> node(n);
    std::iota(node.begin(), node.end(), 1u);
    return node;
}

LineCheck check(const Line& x, std::vector<double> element = {}) {
    return check_line(x, numbers(x.size()), element);
}

Line straight(int n, double step = 1) {
    Line x;
    for (int k = 0; k < n; ++k)
        x.push_back({0.3 * k * step, 0.8 * k * step, 5});
    return x;
}

Line arc(int n, double radius, double from, double to) {
    Line x;
    for (int k = 0; k < n; ++k) {
        const double a = from + (to - from) * k / (n - 1);
        x.push_back({radius * std::cos(a), radius * std::sin(a), 0});
    }
    return x;
}

Line ring(int n, double radius) {
    return arc(n, radius, 0, 2 * pi * (n - 1) / n);
}

/// Corner points joined by steps of about the given size.
Line polyline(const Line& corners, double step) {
    Line x{corners[0]};
    for (std::size_t k = 1; k < corners.size(); ++k) {
        const int n = std::max(1, static_cast<int>(std::lround(distance(corners[k - 1], corners[k]) / step)));
        for (int m = 1; m <= n; ++m)
            x.push_back(corners[k - 1] + (double(m) / n) * (corners[k] - corners[k - 1]));
    }
    return x;
}

Line s_curve(int n) {
    Line x;
    for (int k = 0; k < n; ++k)
        x.push_back({double(k), 12 * std::sin(k * 0.15), 3 * std::cos(k * 0.1)});
    return x;
}

/// Geometrically graded: 1, 1.3, 1.69 …
Line graded(int n, double ratio) {
    Line x{{0, 0, 0}};
    double step = 1;
    for (int k = 1; k < n; ++k)
        x.push_back(x.back() + Vec3{step, 0, 0}), step *= ratio;
    return x;
}

/// Steps at random between 0.4 and 1.6.
Line uneven(int n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> step(0.4, 1.6);
    Line x{{0, 0, 0}};
    for (int k = 1; k < n; ++k)
        x.push_back(x.back() + step(random) * Vec3{0.6, 0.8, 0});
    return x;
}

Line with_gap(Line x, std::size_t from, std::size_t count) {
    x.erase(x.begin() + static_cast<std::ptrdiff_t>(from),
            x.begin() + static_cast<std::ptrdiff_t>(from + count));
    return x;
}

Line joined(Line a, const Line& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// A U: two legs `apart`, joined by a half circle.
Line hairpin(double apart, int leg) {
    Line x;
    for (int k = 0; k < leg; ++k)
        x.push_back({double(k), 0, 0});
    const double r = apart / 2;
    const int bend = std::max(2, static_cast<int>(std::lround(pi * r)));
    for (int k = 1; k < bend; ++k)
        x.push_back({leg - 1 + r * std::sin(pi * k / bend), r - r * std::cos(pi * k / bend), 0});
    for (int k = leg; k-- > 0;)
        x.push_back({double(k), apart, 0});
    return x;
}

struct Named {
    const char* name;
    Line line;
};

std::vector<Named> sound_lines() {
    return {{"straight", straight(30)},
            {"two nodes", straight(2)},
            {"three nodes", straight(3)},
            {"quarter arc", arc(20, 40, 0, pi / 2)},
            {"three quarters of a circle", arc(40, 40, 0, 1.5 * pi)},
            {"coarse ring", ring(8, 10)},
            {"ring", ring(60, 50)},
            {"rectangle", polyline({{0, 0, 0}, {30, 0, 0}, {30, 20, 0}, {0, 20, 0}, {0, 1, 0}}, 1)},
            {"corners of 90 degrees", polyline({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {25, 10, 3}}, 1)},
            {"corner of 120 degrees", polyline({{0, 0, 0}, {10, 0, 0}, {5, 8.66, 0}}, 1)},
            {"S", s_curve(80)},
            {"graded", graded(15, 1.5)},
            {"uneven", uneven(60, 3)},
            {"uneven again", uneven(200, 4)},
            {"hairpin", hairpin(3, 20)},
            {"tight hairpin", hairpin(1.2, 20)},
            {"spiral", [] {
                 Line x;
                 for (int k = 0; k < 200; ++k) {
                     const double a = std::sqrt(k + 20.0) * 1.2;
                     x.push_back({2 * a * std::cos(a), 2 * a * std::sin(a), 0});
                 }
                 return x;
             }()}};
}

bool no_errors(const LineCheck& c) {
    return !c.scrambled && c.gaps.empty() && c.folds.empty() && c.repeated.empty() && c.coincident.empty() &&
           c.walk.branches.empty() && !c.too_short;
}

/// The walk visits the places of `line` in order, from either end, or around from anywhere.
bool walks(const LineWalk& walk, const Line& listed, const Line& line) {
    if (walk.order.size() != line.size()) return false;
    Line x;
    for (const uint32_t p : walk.order)
        x.push_back(listed[p]);
    if (walk.closed) {
        std::rotate(x.begin(), std::find(x.begin(), x.end(), line[0]), x.end());
        if (x.back() == line[1]) std::reverse(x.begin() + 1, x.end());
    } else if (x.front() != line.front()) {
        std::reverse(x.begin(), x.end());
    }
    return x == line;
}

} // namespace

TEST_CASE("sound lines have no errors, from either end") {
    for (auto [name, line] : sound_lines()) {
        CAPTURE(name);
        CHECK(no_errors(check(line)));
        std::reverse(line.begin(), line.end());
        CHECK(no_errors(check(line)));
    }
}

TEST_CASE("a sound line listed in order walks as listed") {
    const Line x = s_curve(50);
    const LineCheck c = check(x);
    std::vector<uint32_t> identity(50);
    std::iota(identity.begin(), identity.end(), 0u);
    CHECK(c.walk.order == identity);
    CHECK(c.walk.unambiguous);
    CHECK(c.walk.pieces == std::vector<uint32_t>{0});
    CHECK_FALSE(c.walk.closed);
}

TEST_CASE("any pair of neighbours swapped is a scrambled line and nothing else") {
    for (const auto& [name, line] : sound_lines()) {
        if (line.size() < 5) continue;
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
            // On a ring the first and last may be swapped with their neighbour into another sound start.
            Line x = line;
            std::swap(x[k], x[k + 1]);
            const LineCheck c = check(x);
            CAPTURE(name, k);
            CHECK(c.scrambled);
            CHECK(c.gaps.empty());
            CHECK(c.folds.empty());
            CHECK(c.corners.empty());
            CHECK(c.walk.branches.empty());
        }
    }
}

TEST_CASE("any two nodes swapped, and shuffled lists, are scrambled; the walk puts them right") {
    std::mt19937 random(11);
    for (const auto& [name, line] : sound_lines()) {
        if (line.size() < 5) continue;
        for (int round = 0; round < 40; ++round) {
            Line x = line;
            if (round % 2 == 0) {
                const std::size_t a = random() % x.size(), b = random() % x.size();
                if (a == b) continue;
                std::swap(x[a], x[b]);
            } else {
                std::shuffle(x.begin(), x.end(), random);
            }
            const LineCheck c = check(x);
            CAPTURE(name, round);
            CHECK(c.scrambled);
            CHECK(c.gaps.empty());
            CHECK(c.folds.empty());
            if (c.walk.unambiguous) CHECK(walks(c.walk, x, line));
        }
    }
    Line x = straight(40);
    std::shuffle(x.begin(), x.end(), random);
    CHECK(check(x).walk.unambiguous);
    x = ring(40, 30);
    std::shuffle(x.begin(), x.end(), random);
    CHECK(check(x).walk.unambiguous);
    CHECK(check(x).walk.closed);
    CHECK(check(x).walk.order.front() == 0);
    x = uneven(100, 9);
    std::shuffle(x.begin(), x.end(), random);
    CHECK(check(x).walk.unambiguous);
    CHECK(walks(check(x).walk, x, uneven(100, 9)));
}

TEST_CASE("a line listed from its middle, and one sorted by coordinate") {
    Line x = straight(20);
    std::rotate(x.begin(), x.begin() + 8, x.end());
    CHECK(check(x).scrambled);
    x = arc(30, 20, 0, 1.2 * pi);
    std::sort(x.begin(), x.end(), [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
    CHECK(check(x).scrambled);
    x = ring(30, 20);
    std::rotate(x.begin(), x.begin() + 8, x.end());
    CHECK(no_errors(check(x)));
}

TEST_CASE("three and four nodes out of order") {
    CHECK(check({{1, 0, 0}, {0, 0, 0}, {2, 0, 0}}).scrambled);
    CHECK(check({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).scrambled);
    CHECK_FALSE(check({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}).scrambled);
    // 0 1 2 3 on an arc, listed from its middle: the jump back is no side of a loop
    const Line wide = arc(4, 1.5, 0, 2.5);
    CHECK(check({wide[1], wide[2], wide[3], wide[0]}).scrambled);
    // three nodes have no middle to start from, a triangle with one longer side has one order
    CHECK(check({{1, 0, 0}, {1.2, 1, 0}, {0, 0, 0}}).scrambled);
    CHECK_FALSE(check({{0, 0, 0}, {1, 0, 0}, {1.2, 1, 0}}).scrambled);
}

TEST_CASE("a few nodes listed out and back along their line are scrambled, many are a fold") {
    const auto out_and_back = [](uint32_t count) {
        Line x;
        for (uint32_t k = 0; k < count; k += 2)
            x.push_back({1.0 * k, 0, 0});
        for (uint32_t k = count % 2 == 0 ? count - 1 : count - 2; k < count; k -= 2)
            x.push_back({1.0 * k, 0, 0});
        return x;
    };
    for (const uint32_t count : {7u, 8u, 11u, 12u}) {
        CAPTURE(count);
        CHECK(check(out_and_back(count)).scrambled);
    }
    for (const uint32_t count : {13u, 14u, 30u}) {
        CAPTURE(count);
        CHECK_FALSE(check(out_and_back(count)).scrambled);
        CHECK(check(out_and_back(count)).folds.size() == 1);
    }
}

TEST_CASE("gaps are found and nothing else") {
    struct Case {
        const char* name;
        Line line;
        std::vector<uint32_t> after; ///< list positions before each gap
    };
    const std::vector<Case> cases{
        {"straight", with_gap(straight(30), 12, 5), {11}},
        {"two gaps", with_gap(with_gap(straight(40), 25, 6), 10, 4), {9, 20}},
        {"one node between gaps", with_gap(with_gap(straight(40), 21, 8), 12, 8), {11, 12}},
        {"arc", with_gap(arc(60, 50, 0, pi), 20, 5), {19}},
        {"ring", with_gap(ring(40, 30), 15, 6), {14}},
        {"near the end", with_gap(straight(20), 13, 5), {12}},
        {"two parallel pieces, both upwards",
         joined(straight(4, 3), polyline({{21, 0, 5}, {23.4, 6.4, 5}}, 3)),
         {3}},
        {"pieces in another order",
         joined(joined(straight(8), polyline({{40, 40, 5}, {40, 48, 5}}, 1)),
                polyline({{20, 20, 5}, {20, 28, 5}}, 1)),
         {7, 16}},
    };
    for (const auto& [name, line, after] : cases) {
        const LineCheck c = check(line);
        CAPTURE(name);
        std::vector<uint32_t> found;
        for (const LineHop& gap : c.gaps)
            found.push_back(gap.from);
        CHECK(found == after);
        CHECK_FALSE(c.scrambled);
        CHECK(c.folds.empty());
        CHECK(c.corners.empty());
        CHECK(c.uneven.empty());
        CHECK(c.walk.pieces.size() == after.size() + 1);
        CHECK(c.piece_starts().size() == after.size() + 1);
    }
    CHECK(check(with_gap(straight(30), 12, 5)).gaps[0].length == Approx(6 * std::sqrt(0.73)));
    CHECK(check(with_gap(straight(30), 12, 5)).gaps[0].usual == Approx(std::sqrt(0.73)));
}

TEST_CASE("a long step over a large element is no gap") {
    Line x = with_gap(straight(30), 12, 3); // 4 steps of 0.854
    CHECK(check(x).gaps.size() == 1);
    CHECK(check(x, std::vector<double>(x.size(), 1.0)).gaps.size() == 1);
    const LineCheck coarse = check(x, std::vector<double>(x.size(), 5.0));
    CHECK(coarse.gaps.empty());
    CHECK(coarse.uneven.size() == 2);
    CHECK(coarse.too_fine.size() == x.size() - 2);
}

TEST_CASE("steps against the elements under them") {
    const Line x = straight(6, 1 / std::sqrt(0.73)); // steps of 1
    CHECK(check(x, std::vector<double>(6, 0.9)).over_element.size() == 5);
    CHECK(check(x, std::vector<double>(6, 1.1)).over_element.empty());
    CHECK(check(x, std::vector<double>(6, 6.0)).too_fine.size() == 5);
    CHECK(check(x, std::vector<double>(6, 0.0)).over_element.empty()); // nothing under it
}

TEST_CASE("uneven steps are not errors") {
    const LineCheck c = check({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {6, 0, 0}, {10, 0, 0}, {14, 0, 0}});
    CHECK(no_errors(c));
    REQUIRE(c.uneven.size() == 1);
    CHECK(c.uneven[0].from == 2);
    CHECK(c.uneven[0].length == 4);
    CHECK(c.uneven[0].usual == 1);
    CHECK(no_errors(check(graded(12, 1.7))));
}

TEST_CASE("corners and folds") {
    const LineCheck right = check(polyline({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}, 1));
    REQUIRE(right.corners.size() == 1);
    CHECK(right.corners[0].at == 10);
    CHECK(right.corners[0].degrees == Approx(90));
    CHECK(right.corners[0].lost == Approx(1 - std::sqrt(0.5)));
    CHECK(right.folds.empty());

    for (const double degrees : {137.0, 150.0, 170.0, 179.0}) {
        const double a = (180 - degrees) * pi / 180;
        const LineCheck fold =
            check(polyline({{0, 0, 0}, {10, 0, 0}, {10 - 8 * std::cos(a), 8 * std::sin(a), 0}}, 1));
        CAPTURE(degrees);
        REQUIRE(fold.folds.size() == 1);
        CHECK(fold.folds[0].at == 10);
        CHECK(fold.folds[0].degrees == Approx(degrees));
        CHECK_FALSE(fold.scrambled);
        CHECK(fold.gaps.empty());
        CHECK(fold.corners.empty());
    }
    // out and back on itself, between its own nodes
    Line back = polyline({{0, 0, 0}, {10, 0, 0}}, 1);
    for (int k = 9; k >= 0; --k)
        back.push_back({k + 0.5, 0, 0});
    CHECK(check(back).folds.size() == 1);
    CHECK_FALSE(check(back).scrambled);
    // a short V
    CHECK(check({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1.234, 0.643, 0}, {0.468, 1.286, 0}}).folds.size() == 1);
    // out and back over the same places, with nodes of its own
    back = polyline({{0, 0, 0}, {10, 0, 0}, {0, 0, 0}}, 1);
    CHECK(check(back).folds.size() == 1);
    CHECK((!check(back).scrambled && check(back).coincident.empty()));
}

TEST_CASE("repeated nodes are reported once, and nothing follows from them") {
    Line x = straight(20);
    std::vector<uint32_t> node = numbers(20);
    x.insert(x.begin() + 7, x[6]);
    node.insert(node.begin() + 7, node[6]);
    LineCheck c = check_line(x, node);
    REQUIRE(c.repeated.size() == 1);
    CHECK(c.repeated[0].first == 6);
    CHECK(c.repeated[0].second == 7);
    CHECK(c.coincident.empty());
    CHECK((!c.scrambled && c.gaps.empty() && c.folds.empty() && c.uneven.empty()));

    x = straight(20);
    node = numbers(20);
    x.push_back(x[4]); // listed again far from its place
    node.push_back(node[4]);
    c = check_line(x, node);
    CHECK(c.repeated.size() == 1);
    CHECK_FALSE(c.closed_by_repeat);
    CHECK((!c.scrambled && c.gaps.empty() && c.folds.empty()));

    x = ring(20, 10);
    node = numbers(20);
    x.push_back(x[0]);
    node.push_back(node[0]);
    c = check_line(x, node);
    CHECK(c.closed_by_repeat);
    CHECK((!c.scrambled && c.gaps.empty() && c.folds.empty()));
    CHECK(c.walk.closed);
}

TEST_CASE("two nodes at one place") {
    Line x = straight(20);
    x.insert(x.begin() + 7, x[6]);
    const LineCheck c = check(x);
    REQUIRE(c.coincident.size() == 1);
    CHECK(c.coincident[0].first == 6);
    CHECK(c.coincident[0].second == 7);
    CHECK((!c.scrambled && c.gaps.empty() && c.folds.empty() && c.uneven.empty()));
    CHECK(c.walk.order.size() == 20);
}

TEST_CASE("loops") {
    LineCheck c = check(ring(20, 10));
    CHECK(c.loop_open);
    CHECK(c.walk.closed);
    CHECK(c.closing.from == 19);
    CHECK(c.closing.to == 0);
    CHECK(c.closing.length == Approx(c.median_hop));
    Line joined_ring = ring(20, 10); // closed by a node of its own
    joined_ring.push_back(joined_ring[0]);
    c = check(joined_ring);
    CHECK(no_errors(c));
    CHECK_FALSE(c.loop_open);
    CHECK(c.walk.closed);
    CHECK_FALSE(check(arc(20, 10, 0, 1.5 * pi)).loop_open);
    CHECK_FALSE(check(hairpin(1.2, 20)).loop_open);
    CHECK_FALSE(check(straight(4)).loop_open);
    CHECK(check(polyline({{0, 0, 0}, {30, 0, 0}, {30, 20, 0}, {0, 20, 0}, {0, 1, 0}}, 1)).loop_open);
    // a joined ring listed out of order is scrambled all the same
    std::swap(joined_ring[5], joined_ring[9]);
    CHECK(check(joined_ring).scrambled);
}

TEST_CASE("a T and a Y branch, and are not called scrambled") {
    const Line t = joined(polyline({{0, 0, 0}, {20, 0, 0}}, 1), polyline({{10, 1, 0}, {10, 9, 0}}, 1));
    LineCheck c = check(t);
    REQUIRE(c.walk.branches.size() == 1);
    CHECK(c.walk.branches[0] == 10);
    CHECK_FALSE(c.scrambled);
    CHECK((c.gaps.empty() && c.folds.empty()));
    const Line y =
        joined(polyline({{0, 0, 0}, {10, 0, 0}, {17, 7, 0}}, 1), polyline({{10.7, -0.7, 0}, {17, -7, 0}}, 1));
    c = check(y);
    CHECK(c.walk.branches.size() == 1);
    CHECK_FALSE(c.scrambled);
}

TEST_CASE("degenerate lists") {
    CHECK(check({}).too_short);
    CHECK(check({{1, 2, 3}}).too_short);
    const LineCheck one_place = check(Line(50, Vec3{1, 2, 3}));
    CHECK(one_place.too_short);
    CHECK(one_place.coincident.size() == 49);
    CHECK_FALSE(check(straight(2)).too_short);
    CHECK(check_line(Line(3, Vec3{1, 2, 3}), std::vector<uint32_t>(3, 7)).repeated.size() == 2);
}

TEST_CASE("100 000 nodes, in order and shuffled") {
    Line x;
    for (int k = 0; k < 100000; ++k)
        x.push_back({k * 0.01, 50 * std::sin(k * 1e-3), 0});
    CHECK(no_errors(check(x)));
    std::mt19937 random(5);
    Line shuffled = x;
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    const LineCheck c = check(shuffled);
    CHECK(c.scrambled);
    CHECK(c.walk.unambiguous);
    CHECK(walks(c.walk, shuffled, x));
}
