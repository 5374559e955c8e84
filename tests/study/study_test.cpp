// Orders, picks and counters of the study on scenes with closed forms.
#include "sheet.h"
#include "study/line_points.h"
#include "study/study.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace drawbead;
using namespace drawbead::testing;

namespace {

Study studied(const Sheet& s, StudyOptions options = {}) {
    options.repeats = 0;
    options.most_evaluations = std::min<uint64_t>(options.most_evaluations, 4000);
    std::vector<MotionSteps> steps;
    for (const Motion& motion : s.scene.motions)
        steps.push_back(integrate(motion, s.scene.time, s.scene.dt));
    Study out = accuracy_study(s.scene, steps, options);
    CHECK_FALSE(out.rim);
    return out;
}

const StudyOrder& order(const Study& study, const std::string& knob, const std::string& quantity) {
    for (const StudyOrder& one : study.orders)
        if (one.knob == knob && one.quantity == quantity) return one;
    throw std::out_of_range(knob + ", " + quantity);
}

struct Ran {
    BeadHistory history;
    double absorbed;
    StudyCounts cost;
};
Ran ran(Sheet& s, const ManualSettings& settings) {
    set_steps(s.scene, 0, s.scene.time.back(), settings.steps);
    const auto run = make_stepped_run(s.scene, 0, settings);
    run->advance(0, s.scene.time.size());
    run->finish();
    return {run->history(), run->absorbed(), run->cost()};
}

/// Drawn on and back with a continuous velocity.
Sheet smooth(std::vector<Vec3> line = straight(7, 6)) {
    Sheet s(std::move(line), {20, 0, 40, 0, 5});
    s.blank().terms.push_back(velocity(0, {0, 0.31, 0.83, 1}, {8, 0.5, -7, 2}));
    return s;
}
Sheet kinked() {
    Sheet s(straight(7, 6), {20, 0, 40, 0, 5});
    s.blank().terms.push_back(displacement(0, {0, 0.377, 0.791, 1}, {0, 3, -1, 0.5}));
    return s;
}

/// What decides between rows within a tolerance, as docs/accuracy.md says it.
auto price(const Study& study, const StudyRow& row) {
    return std::tuple(row.cost.evaluations, row.cost.searches, row.settings.projection == Projecting::exact,
                      std::max({row.error(), study.reference_error, 1e-13}));
}

/// The picks are what was asked, and nothing cheaper is.
void check_picks(const Study& study) {
    for (const StudyPick& pick : study.picks) {
        REQUIRE(pick.row);
        CHECK(study.rows[*pick.row].error() <= pick.tolerance);
        for (const StudyRow& row : study.rows)
            if (price(study, row) < price(study, study.rows[*pick.row])) CHECK(row.error() > pick.tolerance);
    }
}

} // namespace

TEST_CASE("study: order 2 in steps for smooth reversals") {
    const Study study = studied(smooth());
    CHECK_FALSE(study.kinked);
    CHECK(study.reference_error < 1e-9);
    for (const char* quantity : {"work", "dissipated", "restraint, mean"}) {
        const StudyOrder& one = order(study, "steps", quantity);
        REQUIRE(one.observed.order);
        CHECK(*one.observed.order == Approx(2).margin(0.1));
        CHECK(one.observed.verdict == OrderVerdict::as_expected);
    }
    CHECK(order(study, "steps", "normal force").observed.verdict == OrderVerdict::exact);
    CHECK(order(study, "steps", "first slip").observed.verdict == OrderVerdict::exact);
    check_picks(study);
}

TEST_CASE("study: order 1 in steps where the velocity jumps") {
    const Study study = studied(kinked());
    CHECK(study.kinked);
    for (const char* quantity : {"work", "dissipated"}) {
        const StudyOrder& one = order(study, "steps", quantity);
        REQUIRE(one.observed.order);
        CHECK(*one.observed.order == Approx(1).margin(0.1));
        CHECK(one.observed.verdict == OrderVerdict::as_expected);
    }
    check_picks(study);
    // Steps that end at the kinks leave nothing.
    for (const StudyRow& row : study.rows)
        if (row.settings.kinks == Kinks::split && row.settings.number == Number::twice)
            CHECK(row.error() < 1e-10);
}

TEST_CASE("study: what is picked for one tolerance does not depend on the others") {
    const std::vector<double> all{1e-1, 1e-2, 3e-3, 1e-3, 1e-4, 1e-5};
    for (const Sheet& s : {smooth(quarter(9)), smooth(), kinked()}) {
        StudyOptions options;
        options.tolerances = all;
        const Study together = studied(s, options);
        check_picks(together);
        for (std::size_t i = 0; i < all.size(); ++i) {
            options.tolerances = {all[i]};
            const Study alone = studied(s, options);
            REQUIRE(alone.picks[0].row);
            CHECK(alone.rows[*alone.picks[0].row].settings == together.rows[*together.picks[i].row].settings);
        }
    }
    // Sums and numbers that rounding alone tells apart stay what they are by default.
    const Study study = studied(smooth());
    for (const StudyPick& pick : study.picks) {
        CHECK(study.rows[*pick.row].settings == study.rows[*study.picks[0].row].settings);
        CHECK(study.rows[*pick.row].settings.sum == Summing::compensated);
        CHECK(study.rows[*pick.row].settings.number == Number::twice);
    }
}

TEST_CASE("study: every row says when it is at the floor, and settings of the scene's own stand once") {
    StudyOptions options;
    options.own.emplace();
    options.own->steps = 16;
    options.own->kinks = Kinks::split;
    const Study study = studied(kinked(), options);
    CHECK(study.rows[0].settings == *options.own);
    std::size_t other = 0;
    for (const StudyRow& row : study.rows) {
        CHECK(row.at_floor == (row.error() <= 4 * std::max(study.reference_error, 1e-13)));
        other += row.at_floor && row.settings.search == Searching::tracked;
        CHECK(std::count_if(study.rows.begin(), study.rows.end(),
                            [&](const StudyRow& one) { return one.settings == row.settings; }) == 1);
    }
    CHECK(study.rows[0].at_floor);
    CHECK(other > 0);
    // The other rows are those of a study without own settings.
    options.own.reset();
    CHECK(study.rows.size() == studied(kinked(), options).rows.size());
}

TEST_CASE("study: order 2 where the sheet turns under the bead") {
    Sheet s(quarter(4), {20, 0, 40, 0, 5}, 2100);
    s.blank().turn = Motion::Turn{{60, 60, 0}, {0, 0, 1}, TimeTable({0, 1}, {0, 0.2})};
    s.blank().terms.push_back(velocity(0, {0, 1}, {30, -20}));
    StudyOptions options;
    options.tolerances = {1e-2};
    const Study study = studied(s, options);
    for (const char* quantity : {"work", "dissipated"}) {
        const StudyOrder& one = order(study, "steps", quantity);
        REQUIRE(one.observed.order);
        CHECK(*one.observed.order == Approx(2).margin(0.1));
    }
    CHECK(study.reference_error < 1e-4);
    check_picks(study);
}

TEST_CASE("study: order 2 in the chord angle, against the true circle") {
    std::vector<double> angle, error;
    for (const std::size_t hops : {8u, 16u, 32u, 64u}) {
        Sheet s(quarter(hops), {10, 0, 0, 0, 5});
        ManualSettings settings;
        settings.steps = 1;
        const double expected = 10 * 40 * 0.5 * std::numbers::pi;
        angle.push_back(0.5 * std::numbers::pi / static_cast<double>(hops));
        error.push_back(std::abs(norm(ran(s, settings).history.steps[0].normal) - expected) / expected);
        settings.tributary = Tributary::arc;
        const double by_hops = std::abs(norm(ran(s, settings).history.steps[0].normal) - expected) / expected;
        CHECK(by_hops < 0.3 * error.back());
    }
    const ObservedOrder observed = observed_order(angle, error, 2);
    REQUIRE(observed.order);
    CHECK(*observed.order == Approx(2).margin(0.1));
    const Study study = studied(smooth(quarter(16)));
    CHECK(*order(study, "chord angle", "length").observed.order == Approx(2).margin(0.02));
    check_picks(study);
}

TEST_CASE("study: linear limits are exact, order 2 along the line where they are not met") {
    Sheet s(straight(6, 7), {10, 30, 40, 20, 5});
    s.blank().terms.push_back(velocity(0, {0, 0.31, 0.83, 1}, {8, 0.5, -7, 2}));
    const Study linear = studied(s);
    CHECK(order(linear, "linear limits", "sum of limits").observed.verdict == OrderVerdict::exact);
    CHECK(order(linear, "line", "normal force").observed.verdict == OrderVerdict::exact);
    CHECK(order(linear, "line", "largest restraint").observed.verdict == OrderVerdict::exact);

    // A bead that stands inclined: on the ramp, part of it on the plateau, limits that vary.
    std::vector<Vec3> inclined;
    for (int i = 0; i < 7; ++i)
        inclined.push_back({72.3, 30 + 6.0 * i, 1 + 0.7 * i});
    Sheet ramp(inclined, {10, 30, 40, 20, 8});
    ramp.blank().terms.push_back(velocity(0, {0, 1}, {8, 5}));
    const Study study = studied(ramp);
    for (const char* quantity : {"normal force", "largest restraint"}) {
        const StudyOrder& one = order(study, "line", quantity);
        REQUIRE(one.observed.order);
        CHECK(*one.observed.order == Approx(2).margin(0.1));
    }
    check_picks(study);
}

TEST_CASE("study: the manual's law as evaluate runs it is the reference's sum over nodes") {
    StudyOptions options;
    options.truth = Truth::nodes;
    for (const Sheet& s : {smooth(quarter(8)), kinked()}) {
        const Study study = studied(s, options);
        for (const double e : study.evaluate)
            CHECK(e < 1e-9);
        check_picks(study);
    }
}

TEST_CASE("stepped run: every setting of the other knobs tells the same on a flat sheet") {
    for (const double skew : {0.0, 0.8}) {
        Sheet s(quarter(9), {20, 0, 40, 0, 5}, 210000, skew);
        s.blank().terms.push_back(velocity(0, {0, 0.31, 0.83, 1}, {8, 0.5, -7, 2}));
        ManualSettings base;
        base.steps = 100;
        base.kinks = Kinks::split;
        const Ran exact = ran(s, base);
        for (const Projecting projection : {Projecting::ratio, Projecting::exact})
            for (const Searching search : {Searching::tracked, Searching::exact})
                for (const Number number : {Number::single, Number::twice}) {
                    ManualSettings other = base;
                    other.projection = projection;
                    other.search = search;
                    other.number = number;
                    other.sum = Summing::plain;
                    const Ran one = ran(s, other);
                    CHECK(one.absorbed ==
                          Approx(exact.absorbed).epsilon(number == Number::twice ? 1e-11 : 1e-4));
                    CHECK(one.cost.evaluations == exact.cost.evaluations);
                    const uint64_t points = 10;
                    CHECK(one.cost.searches == (search == Searching::exact ? one.cost.evaluations : points));
                    CHECK(one.cost.follows == one.cost.evaluations - one.cost.searches);
                }
    }
}

TEST_CASE("stepped run: what is counted") {
    Sheet s = smooth();
    ManualSettings settings;
    settings.steps = 64;
    CHECK(ran(s, settings).cost == StudyCounts{7 * 65, 7 * 65, 0, 0, 65});
    settings.kinks = Kinks::split; // two bends, two zeros
    CHECK(ran(s, settings).cost.evaluations == 7 * (65 + 4));
    settings.line = {LineRule::Kind::points, 4};
    CHECK(ran(s, settings).cost.evaluations == (24 + 2) * 69);
    settings.line = {LineRule::Kind::adaptive, 2};
    // Half hops at five instants and three places find nothing to halve.
    CHECK(ran(s, settings).cost.evaluations == (12 + 2) * 69 + 12 * 5 * 3);
    settings.search = Searching::tracked;
    settings.line = {};
    const StudyCounts tracked = ran(s, settings).cost;
    CHECK(tracked.searches == 7);
    CHECK(tracked.follows == 7 * 68);
    CHECK(tracked.projections == 7 * 68);
}

TEST_CASE("stepped run: the window, and what is lost when it closes") {
    Sheet s(straight(7, 6), {20, 0, 40, 0, 5});
    s.blank().terms.push_back(velocity(0, {0, 1}, {4, 4}));
    s.scene.beads[0].t_start = 0.23;
    s.scene.beads[0].t_stop = 0.71;
    ManualSettings settings;
    settings.steps = 10;
    settings.kinks = Kinks::split;
    const Ran one = ran(s, settings);
    // Limit times way, less half of the spring's.
    double expected = 0;
    for (int i = 0; i < 7; ++i) {
        const double f = 40 * (i == 0 || i == 6 ? 3 : 6), k = 42000;
        expected += f * (4 * 0.48 - f / k) + 0.5 * f * f / k;
    }
    CHECK(one.absorbed == Approx(expected).epsilon(1e-12));
    CHECK(one.history.energy.stored == 0);
    CHECK(one.history.energy.dissipated == Approx(expected).epsilon(1e-12));
    CHECK(norm(one.history.steps[2].restraint) == 0);
    CHECK(norm(one.history.steps[3].restraint) > 0);
    CHECK(norm(one.history.steps[8].restraint) == 0);
    check_picks(studied(s));
}

TEST_CASE("line points: parts of hops make up the line") {
    for (const LineRule& line : {LineRule{LineRule::Kind::points, 2}, LineRule{LineRule::Kind::points, 6},
                                 LineRule{LineRule::Kind::adaptive, 2}}) {
        std::vector<double> of_node(4, 0.0);
        for (const LinePoint& p : line_points(
                 4, line, [](uint32_t a, double from, double to) { return a == 1 && to - from > 0.1; }))
            if (p.counts) of_node[p.node] += p.part;
        CHECK(of_node == std::vector<double>{0.5, 1, 1, 0.5});
    }
    CHECK(line_points(1, {LineRule::Kind::points, 4}).size() == 1);
    CHECK(line_points(0, {}).empty());
}

TEST_CASE("orders: floor, saturation, exactness") {
    const std::vector<double> h{1, 0.5, 0.25, 0.125, 0.0625};
    CHECK(*observed_order(h, std::vector<double>{0.9, 0.08, 0.02, 0.005, 1e-15}, 2).order == Approx(2));
    CHECK(observed_order(h, std::vector<double>{0.9, 0.9, 0.02, 0.005, 1e-15}, 2).verdict ==
          OrderVerdict::unresolved);
    CHECK(observed_order(h, std::vector<double>{1e-14, 0, 0, 0, 1e-15}, 2).verdict == OrderVerdict::exact);
    CHECK(observed_order(h, std::vector<double>{.08, .04, .02, .01, .005}, 2).verdict == OrderVerdict::below);
    CHECK(*order_of_differences(std::vector<double>{5, 4.0625, 4.015625}, 2, 4).order > 4);
    CHECK(order_of_differences(std::vector<double>{4, 4, 4}, 2, 4).verdict == OrderVerdict::exact);
    CHECK(order_of_differences(std::vector<double>{4, 4.1, 4.3}, 2, 4).verdict == OrderVerdict::unresolved);
}
