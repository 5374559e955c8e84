// Properties of bead lines on generated lines; a counterexample is printed made small.
#include "bead/bead_line.h"
#include "bead/line_check.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <rapidcheck.h>

using namespace drawbead;

namespace {

/// An arc (or a straight line) of unevenly spaced nodes, at most three quarters of a turn.
std::vector<Vec3> any_line() {
    const auto count = static_cast<std::size_t>(*rc::gen::inRange(3, 60).as("nodes"));
    const double turn = 0.01 * *rc::gen::inRange(0, 470).as("turn in 0.01 rad");
    std::vector<double> along(count, 0.0);
    for (std::size_t i = 1; i < count; ++i)
        along[i] = along[i - 1] + 0.1 * *rc::gen::inRange(10, 15);
    std::vector<Vec3> x;
    for (const double s : along) {
        const double angle = turn * s / along.back();
        const double radius = turn > 0 ? along.back() / turn : 0;
        x.push_back(turn > 0 ? Vec3{radius * std::sin(angle), radius * (1 - std::cos(angle)), 3}
                             : Vec3{s, 0, 3});
    }
    return x;
}

std::vector<uint32_t> ids(std::size_t count) {
    std::vector<uint32_t> id(count);
    std::iota(id.begin(), id.end(), 1u);
    return id;
}

bool is_ascending_or_descending(const std::vector<uint32_t>& v) {
    return std::is_sorted(v.begin(), v.end()) || std::is_sorted(v.rbegin(), v.rend());
}

/// The numbers 0 … n - 1 upwards or downwards, from any of them and on over the end.
bool goes_round(const std::vector<uint32_t>& v) {
    const auto n = static_cast<uint32_t>(v.size());
    uint32_t up = 0, down = 0;
    for (uint32_t i = 0; i < n; ++i) {
        up += v[(i + 1) % n] == (v[i] + 1) % n;
        down += v[i] == (v[(i + 1) % n] + 1) % n;
    }
    return up == n || down == n;
}

double tour(const std::vector<Vec3>& x) {
    double length = 0;
    for (std::size_t i = 1; i < x.size(); ++i)
        length += distance(x[i - 1], x[i]);
    return length;
}

/// Ends as near as neighbours may be: the line may as well start elsewhere.
bool is_nearly_closed(const std::vector<Vec3>& x) {
    double longest = 0;
    for (std::size_t i = 1; i < x.size(); ++i)
        longest = std::max(longest, distance(x[i - 1], x[i]));
    return distance(x.front(), x.back()) <= 1.5 * longest;
}

} // namespace

// A list that is hardly longer than the line (three nodes on a wide arc) may be another line just as well.
TEST_CASE("a line in order is clean from either end; in an order that is a fifth longer it is "
          "scrambled, and the walk restores it") {
    CHECK(rc::check([] {
        const std::vector<Vec3> x = any_line();
        std::vector<uint32_t> order(x.size());
        std::iota(order.begin(), order.end(), 0u);
        if (*rc::gen::arbitrary<bool>().as("swap only one pair")) {
            const auto i =
                static_cast<std::size_t>(*rc::gen::inRange<int>(0, static_cast<int>(x.size()) - 1));
            std::swap(order[i], order[i + 1]);
        } else {
            for (std::size_t k = order.size(); k > 1; --k)
                std::swap(order[k - 1],
                          order[static_cast<std::size_t>(*rc::gen::inRange<int>(0, static_cast<int>(k)))]);
        }
        std::vector<Vec3> listed;
        for (const uint32_t i : order)
            listed.push_back(x[i]);
        const bool in_order = is_ascending_or_descending(order), closed = is_nearly_closed(x);
        RC_PRE(in_order || (tour(listed) > 1.2 * tour(x) && !(closed && goes_round(order))));
        const LineCheck check = check_line(listed, ids(listed.size()));
        RC_ASSERT(check.scrambled != in_order);
        RC_ASSERT(check.gaps.empty());
        RC_ASSERT(check.folds.empty());
        std::vector<uint32_t> walked;
        for (const uint32_t position : check.walk.order)
            walked.push_back(order[position]);
        RC_ASSERT(walked.size() == order.size());
        RC_ASSERT(is_ascending_or_descending(walked) || (closed && goes_round(walked)));
    }));
}

TEST_CASE("walking a line from its other end reverses the tributary lengths and keeps the length") {
    CHECK(rc::check([] {
        std::vector<Vec3> x = any_line();
        const BeadLine line = bead_line(x);
        std::reverse(x.begin(), x.end());
        const BeadLine back = bead_line(x);
        for (std::size_t i = 0; i < x.size(); ++i)
            RC_ASSERT(back.tributary[i] == line.tributary[x.size() - 1 - i]);
        RC_ASSERT(std::abs(back.length - line.length) <= 1e-14 * static_cast<double>(x.size()) * line.length);
    }));
}

TEST_CASE("on a straight line limits times tributary lengths sum to the mean limit times the length") {
    CHECK(rc::check([] {
        const auto count = static_cast<std::size_t>(*rc::gen::inRange(2, 200));
        std::vector<Vec3> x{Vec3{}};
        for (std::size_t i = 1; i < count; ++i)
            x.push_back(x.back() + 0.1 * *rc::gen::inRange(1, 100) * Vec3{2. / 3, 1. / 3, 2. / 3});
        const double first = *rc::gen::inRange(0, 500), last = *rc::gen::inRange(1, 500);
        const BeadLine line = bead_line(x);
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i)
            sum += limit_along(first, last, line.s[i], line.length) * line.tributary[i];
        const double expected = 0.5 * (first + last) * line.length;
        RC_ASSERT(std::abs(sum - expected) <= 1e-13 * expected);
    }));
}

TEST_CASE("a line cut at a node is two lines of the same length, and the tributary of that node is shared") {
    CHECK(rc::check([] {
        const std::vector<Vec3> x = any_line();
        const auto cut = static_cast<std::size_t>(*rc::gen::inRange<int>(1, static_cast<int>(x.size()) - 1));
        const BeadLine whole = bead_line(x);
        const std::span<const Vec3> all(x);
        const BeadLine left = bead_line(all.subspan(0, cut + 1)), right = bead_line(all.subspan(cut));
        RC_ASSERT(left.s.back() == whole.s[cut]);
        RC_ASSERT(std::abs(left.length + right.length - whole.length) <= 1e-13 * whole.length);
        const Vec3 shared = left.half_chord.back() + right.half_chord.front();
        RC_ASSERT(norm(shared - whole.half_chord[cut]) <= 1e-13 * whole.length);
    }));
}
