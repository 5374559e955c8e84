// Hard cases of the bead as a line: lengths, limits, order. Both laws share them; they are named for the law
// whose reading is tested.
#include "bead/bead_line.h"
#include "bead/line_check.h"
#include "study/hard_case_table.h"

#include <algorithm>
#include <numeric>

namespace drawbead {

namespace {

double total(const BeadLine& line) {
    return std::accumulate(line.tributary.begin(), line.tributary.end(), 0.0);
}

/// Σ limit · L
double total_limit(const BeadLine& line, double first, double last) {
    double sum = 0;
    for (std::size_t i = 0; i < line.size(); ++i)
        sum += limit_along(first, last, line.s[i], line.length) * line.tributary[i];
    return sum;
}

std::vector<Vec3> straight(std::size_t nodes, double spacing) {
    std::vector<Vec3> x;
    for (std::size_t i = 0; i < nodes; ++i)
        x.push_back(spacing * static_cast<double>(i) * Vec3{2.0 / 3, 1.0 / 3, 2.0 / 3});
    return x;
}

std::vector<uint32_t> numbers(std::size_t count) {
    std::vector<uint32_t> out(count);
    std::iota(out.begin(), out.end(), 1u);
    return out;
}

HardCaseResult million_nodes() {
    const BeadLine line = bead_line(straight(1'000'000, 0.7));
    const double expected = 0.5 * (100 + 300) * 0.7 * 999'999;
    return within(std::abs(total_limit(line, 100, 300) / expected - 1), 1e6 * eps<double>);
}

HardCaseResult uneven_spacing() {
    std::vector<Vec3> x;
    double s = 0;
    for (int i = 0; i < 60; ++i) {
        x.push_back({s, 0, 0});
        s += i % 3 == 0 ? 7.25 : i % 3 == 1 ? 0.125 : 1;
    }
    const BeadLine line = bead_line(x);
    return within(std::abs(total_limit(line, 100, 300) / (200 * line.length) - 1), 60 * eps<double>);
}

HardCaseResult curved_line() {
    // Chord tributaries of a quarter circle against the arc, in units of it.
    const auto error = [](int hops) {
        std::vector<Vec3> x;
        for (int i = 0; i <= hops; ++i) {
            const double angle = 0.5 * 3.14159265358979323846 * i / hops;
            x.push_back({std::cos(angle), std::sin(angle), 0});
        }
        return 1 - total(bead_line(x)) / (0.5 * 3.14159265358979323846);
    };
    return within(std::abs(std::log2(error(256) / error(512)) - 2), 0.02);
}

HardCaseResult one_place() {
    const std::vector<Vec3> x(5, Vec3{1, 2, 3});
    const BeadLine line = bead_line(x);
    double sum = 0;
    for (std::size_t i = 0; i < 5; ++i)
        sum += std::abs(limit_along(100, 300, line.s[i], line.length) - 100) + line.tributary[i];
    return within(sum, 0);
}

HardCaseResult first_normal_limit() {
    return within(std::abs(normal_limit_along(0, 300, 5, 10)), 0);
}

HardCaseResult no_taper() {
    return within(std::abs(limit_along(100, 0, 10, 10) - 100), 0);
}

HardCaseResult one_node() {
    const std::vector<Vec3> x{{1, 2, 3}};
    const BeadLine line = bead_line(x);
    return within(line.size() == 1 ? line.length + line.tributary[0] + arc_tributary(line, 0) : HUGE_VAL, 0);
}

HardCaseResult two_nodes() {
    const BeadLine line = bead_line(straight(2, 3));
    return within(std::abs(line.tributary[0] - 1.5) + std::abs(line.tributary[1] - 1.5), 4 * eps<double>);
}

HardCaseResult gap() {
    // 20 nodes 5 mm apart, a hop of 200 mm after the tenth.
    std::vector<Vec3> x;
    for (int i = 0; i < 20; ++i)
        x.push_back({5.0 * i + (i >= 10 ? 195 : 0), 0, 0});
    const std::span<const Vec3> all(x);
    const double whole = 50 * total(bead_line(all));
    const double split = 50 * (total(bead_line(all.first(10))) + total(bead_line(all.subspan(10))));
    return broken_by(whole - split, 50 * 200, 1e-14);
}

HardCaseResult cut_at_a_node() {
    const std::vector<Vec3> x = straight(21, 0.7);
    const std::span<const Vec3> all(x);
    const BeadLine whole = bead_line(all), left = bead_line(all.first(8)), right = bead_line(all.subspan(7));
    Largest error;
    error.add(std::abs(left.tributary[7] + right.tributary[0] - whole.tributary[7]));
    for (std::size_t i = 0; i < 7; ++i)
        error.add(std::abs(left.tributary[i] - whole.tributary[i]));
    for (std::size_t i = 8; i < 21; ++i)
        error.add(std::abs(right.tributary[i - 7] - whole.tributary[i]));
    return within(error.value(), 8 * eps<double>);
}

HardCaseResult fold_back() {
    std::vector<Vec3> x = straight(12, 1);
    for (int i = 10; i > 4; --i)
        x.push_back(x[static_cast<std::size_t>(i)] + Vec3{0, 0, 0.01});
    const BeadLine line = bead_line(x);
    const bool seen =
        !check_line(x, numbers(x.size())).folds.empty() || check_line(x, numbers(x.size())).scrambled;
    return within(seen ? std::max(total(line) / line.length - 1, 0.0) : HUGE_VAL, 4 * eps<double>);
}

HardCaseResult scrambled() {
    const std::vector<Vec3> x = straight(30, 2);
    std::vector<Vec3> listed;
    for (std::size_t i = 0; i < 30; ++i)
        listed.push_back(x[7 * i % 30]); // 7 and 30 have no factor in common: each once
    const LineCheck check = check_line(listed, numbers(30));
    if (!check.scrambled) return within(HUGE_VAL, 0);
    std::vector<Vec3> walked;
    for (const uint32_t position : check.walk.order)
        walked.push_back(listed[position]);
    return within(std::abs(total(bead_line(walked)) / total(bead_line(x)) - 1), 32 * eps<double>);
}

HardCaseResult open_loop() {
    // Twelve nodes of a ring, the first one not listed again: one hop is missing.
    std::vector<Vec3> x;
    for (int i = 0; i < 12; ++i) {
        const double angle = 2 * 3.14159265358979323846 * i / 12;
        x.push_back({10 * std::cos(angle), 10 * std::sin(angle), 0});
    }
    const double hop = distance(x[0], x[1]);
    return broken_by(12 * hop - bead_line(x).length, hop, 1e-12);
}

HardCaseResult reversed_line() {
    std::vector<Vec3> x = straight(25, 0.7);
    x[7] += Vec3{0.1, 0, 0.2};
    const BeadLine line = bead_line(x);
    std::reverse(x.begin(), x.end());
    const BeadLine back = bead_line(x);
    Largest error;
    for (std::size_t i = 0; i < 25; ++i) {
        error.add(std::abs(limit_along(100, 300, line.s[i], line.length) -
                           limit_along(300, 100, back.s[24 - i], back.length)));
        error.add(100 * std::abs(line.tributary[i] - back.tributary[24 - i]));
    }
    return within(error.value(), 300 * 32 * eps<double>);
}

} // namespace

std::vector<HardCaseRow> bead_line_cases() {
    constexpr Law manual = Law::manual, solver = Law::solver;
    return {
        {"line-million-nodes", manual, must_hold, "A straight line of 1 000 000 nodes with a linear limit.",
         "The total is the mean limit times the length, to an ulp per node.", "", million_nodes},
        {"line-uneven", manual, must_hold, "Hops of 0.125 to 7.25 mm with a linear limit.",
         "The total is the mean limit times the length.", "", uneven_spacing},
        {"line-curved", manual, must_hold, "A quarter circle of 256 and 512 hops.",
         "The total comes to the arc with order 2; measured: order less 2.", "", curved_line},
        {"line-one-place", manual, must_hold, "All nodes in one place, with a linear limit.",
         "The first limit, no tributary, no 0/0.", "bead/bead_line.cpp: s_total > 0", one_place},
        {"line-Fn-last-alone", solver, must_hold, "Fn_first = 0 with Fn_last = 300.", "No normal force.",
         "bead/bead_line.cpp: first == 0", first_normal_limit},
        {"line-last-zero", solver, must_hold, "A last value of 0.", "Constant, no taper to 0.",
         "bead/bead_line.cpp: last == 0", no_taper},
        {"line-one-node", solver, must_hold, "A bead of one node.", "No length, no NaN.", "", one_node},
        {"line-two-nodes", manual, must_hold, "A bead of two nodes.", "Half the hop each.", "", two_nodes},
        {"line-gap", solver, is_broken, "A hop of 200 mm in a list of 5 mm hops, Ft = 50.",
         "The total is that of the pieces.", "", gap},
        {"line-cut", manual, must_hold, "A bead cut in two at a node.",
         "The tributaries at the cut add up, the others stay.", "", cut_at_a_node},
        {"line-fold", solver, must_hold, "A list that runs back over itself.",
         "It is noticed, and the total is no more than the list's length.", "", fold_back},
        {"line-scrambled", manual, must_hold, "A line in scrambled order.",
         "It is noticed, and walking it restores the tributaries.", "", scrambled},
        {"line-open-loop", solver, is_broken, "A ring whose first node is not listed again.",
         "The length is that of the ring; measured: what is missing.", "", open_loop},
        {"line-reversed", manual, must_hold, "The list from its other end, first and last values swapped.",
         "The same limits and tributaries at each node.", "", reversed_line},
    };
}

} // namespace drawbead
