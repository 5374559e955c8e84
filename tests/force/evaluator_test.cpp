// Motion, and both laws over it, on a flat sheet where everything has a closed form.
#include "contact/bead_contact.h"
#include "force/evaluator.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace drawbead;

namespace {

constexpr double E = 210000, thickness = 1, k = 0.2 * E * thickness;

/// A sheet of 20 × 20 shells of 5 mm at z = 0 under a straight bead of 9 nodes along y, 4 mm apart.
class SheetScene {
public:
    explicit SheetScene(BeadLaw<double> law, double height = 0.3, double bead_x = 52.3) {
        std::vector<Vec3> x;
        std::vector<uint32_t> id;
        std::vector<SegmentNodes> segment;
        for (uint32_t j = 0; j <= 20; ++j)
            for (uint32_t i = 0; i <= 20; ++i) {
                x.push_back({5.0 * i, 5.0 * j, 0});
                id.push_back(static_cast<uint32_t>(id.size()) + 1);
            }
        for (uint32_t j = 0; j < 20; ++j)
            for (uint32_t i = 0; i < 20; ++i) {
                const uint32_t n = 21 * j + i;
                segment.push_back({n, n + 1, n + 22, n + 21});
            }
        SegmentMesh mesh;
        mesh.segment = segment;
        mesh.x = x;
        mesh.node_id = id;
        EvaluationBead bead;
        bead.id = 1;
        bead.law = law;
        for (int i = 0; i < 9; ++i) {
            bead.nodes.push_back(1000 + i);
            bead.x.push_back({bead_x, 31.7 + 4 * i, height});
        }
        const BeadInput input{bead.x, law.fn_first, law.depth, 0};
        ContactOptions options;
        options.layer_ratio = 0;
        options.travel = 1e3;
        const SegmentStiffness stiffness = of_shell(E, thickness);
        SurfaceContact contact = surface_contact(
            mesh, std::span(&input, 1), [&](uint32_t) { return stiffness; }, stiffness.k,
            std::vector<double>(400, stiffness.k), options);
        bead.track = contact.track[0];
        bead.slope = contact.bead[0].slope;
        for (const BeadNodeContact& node : contact.bead[0].node)
            bead.slope_read.push_back(node.slope_read);
        bead.motion.assign(9, 0);
        EvaluationSurface surface;
        surface.mesh = std::move(contact.mesh);
        surface.motion.assign(surface.mesh.x.size(), 1);
        surface.mass.assign(surface.mesh.x.size(), 2e-7);
        surface.stiffness.assign(surface.mesh.segment.size(), stiffness);
        surface.thickness.assign(surface.mesh.segment.size(), thickness);
        scene.motions.resize(2);
        scene.surfaces.push_back(std::move(surface));
        scene.beads.push_back(std::move(bead));
        times(1, 100);
    }

    void times(double end, std::size_t count) {
        scene.time.clear();
        scene.dt.clear();
        for (std::size_t n = 0; n <= count; ++n) {
            scene.time.push_back(end * static_cast<double>(n) / static_cast<double>(count));
            scene.dt.push_back(n > 0 ? scene.time[n] - scene.time[n - 1] : 0);
        }
    }
    Motion& tool() { return scene.motions[0]; }
    Motion& blank() { return scene.motions[1]; }
    EvaluationBead& bead() { return scene.beads[0]; }

    BeadPlan planned(Law law, bool node_output = false) {
        steps.clear();
        for (const Motion& motion : scene.motions)
            steps.push_back(integrate(motion, scene.time, scene.dt));
        PlanOptions options;
        options.node_output = node_output;
        return plan(scene, steps, 0, law, options);
    }
    std::unique_ptr<BeadRun> run(Law law, EffectSet stages) {
        auto one = make_run(scene, steps, 0, law, stages);
        one->keep_samples(1);
        one->advance(0, scene.time.size());
        one->finish();
        CHECK_FALSE(one->at_rim());
        return one;
    }
    std::unique_ptr<BeadRun> run(Law law) {
        const BeadPlan plan = planned(law);
        auto one = run(law, plan.needed());
        // Whatever was left out changes nothing.
        CHECK_FALSE(first_difference(one->history(), run(law, EffectSet::all())->history()));
        return one;
    }
    BeadHistory history(Law law) { return run(law)->history(); }

    EvaluationScene scene;
    std::vector<MotionSteps> steps;
};

Motion::Term velocity(std::size_t axis, TimeTable table) {
    return {true, axis, 1, 1, std::move(table)};
}
Motion::Term displacement(std::size_t axis, TimeTable table) {
    return {false, axis, 1, 1, std::move(table)};
}

constexpr double chord_sum = 32; ///< Σ L of nine nodes 4 mm apart

} // namespace

TEST_CASE("time table: linear, beyond its ends too, with exact integrals and slopes from the right") {
    const TimeTable f({0, 1, 3}, {0, 2, -2});
    CHECK(f.value(0.5) == 1);
    CHECK(f.value(2) == 0);
    CHECK(f.value(4) == -4);
    CHECK(f.value(-1) == -2);
    CHECK(f.slope(0.5) == 2);
    CHECK(f.slope(1) == -2);
    CHECK(f.slope(3) == -2);
    CHECK(f.integral(0, 1) == 1);
    CHECK(f.integral(0, 3) == 1);
    CHECK(f.integral(1, 4) == Approx(-3));
    CHECK(f.corners(0, 4) == std::vector<double>{1, 2, 3});
    const TimeTable constant = TimeTable::constant(3);
    CHECK(constant.value(7) == 3);
    CHECK(constant.integral(1, 3) == 6);
    CHECK(constant.corners(0, 9).empty());
}

TEST_CASE("motion: it turns where the sum of its velocities is zero, not where one of them is") {
    Motion sum;
    sum.terms.push_back({true, 2, 1, 1, TimeTable::constant(-2000)});
    sum.terms.push_back({true, 2, 1, 1, TimeTable({0, 1e-2}, {0, 4000})});
    CHECK(sum.bends(0, 1e-2).empty());
    REQUIRE(sum.corners(0, 1e-2).size() == 1);
    CHECK(sum.corners(0, 1e-2)[0] == Approx(5e-3).epsilon(1e-14));
    CHECK(sum.accelerates());
    Motion steady;
    steady.terms.push_back({true, 0, 1, 1, TimeTable::constant(3)});
    steady.terms.push_back({false, 1, 1, 1, TimeTable({0, 1, 2}, {0, 1, 0})});
    CHECK(steady.corners(0, 2) == std::vector<double>{1});
    CHECK_FALSE(steady.accelerates());
}

TEST_CASE("motion: velocities are integrated by the midpoint, displacements reach their place") {
    Motion motion;
    motion.terms = {velocity(0, TimeTable({0, 1}, {0, 4})), displacement(1, TimeTable({0, 1}, {0, 3}))};
    const std::vector<double> t{0, 0.25, 0.5, 0.75, 1}, dt{0, 0.25, 0.25, 0.25, 0.25};
    const MotionSteps steps = integrate(motion, t, dt);
    Vec3 at;
    for (std::size_t n = 1; n < t.size(); ++n) {
        at += steps.increment[n];
        CHECK(steps.velocity[n].x == Approx(4 * (t[n] - 0.125)).epsilon(1e-14));
        CHECK(at.y == Approx(3 * t[n]).epsilon(1e-14));
    }
    CHECK(at.x == Approx(2).epsilon(1e-14)); // the rule is exact for a straight line
    CHECK(motion.displacement(1) == Vec3{2, 3, 0});
    CHECK_FALSE(motion.at_rest());
    CHECK(Motion{}.at_rest());
}

TEST_CASE("motion: a quarter turn, and back") {
    Motion motion;
    motion.turn = Motion::Turn{{1, 0, 0}, {0, 0, 1}, TimeTable({0, 1}, {0, std::numbers::pi / 2})};
    const Placement end = motion.placement(1);
    const Vec3 y = end({2, 0, 5});
    CHECK(distance(y, {1, 1, 5}) < 1e-14);
    CHECK(distance(end.back(y), {2, 0, 5}) < 1e-14);
    CHECK(distance(motion.velocity_at(1, y), std::numbers::pi / 2 * Vec3{-1, 0, 0}) < 1e-14);
}

TEST_CASE("manual law: the tool closes; contact, plateau and forces where the closed form has them") {
    SheetScene s({100, 0, 0, 0, 5}, 8);
    s.tool().terms.push_back(velocity(2, TimeTable::constant(-9)));
    const BeadHistory h = s.history(Law::manual);
    REQUIRE(h.first_contact);
    REQUIRE(h.first_plateau);
    CHECK(*h.first_contact == Approx((8 - 5.5) / 9).epsilon(1e-12));
    CHECK(*h.first_plateau == Approx((8 - 0.5) / 9).epsilon(1e-12));
    for (std::size_t n = 0; n < s.scene.time.size(); ++n) {
        const double penetration = 5.5 - (8 - 9 * s.scene.time[n]);
        const double expected = 100 * chord_sum * std::clamp(penetration / 5, 0.0, 1.0);
        CHECK(h.steps[n].normal.z == Approx(-expected).margin(1e-9 * 3200));
    }
    CHECK(h.ever_in_contact == 9);
    CHECK(h.energy.tool_work == Approx(-3200 * (0.5 * 5 + (9 - 7.5))).epsilon(1e-9));
    CHECK(h.energy.normal_work == 0);
}

TEST_CASE("manual law: stick and slip of a blank that is drawn in and back") {
    SheetScene s({100, 0, 50, 0, 5});
    // 0.1 mm on, 0.1 mm back, in a time in which nothing else matters.
    s.blank().terms.push_back(velocity(0, TimeTable({0, 0.5, 1}, {0.4, 0, -0.4})));
    const BeadHistory h = s.history(Law::manual);
    const auto u = [](double t) { return 0.4 * t - 0.4 * t * t; };
    for (std::size_t n = 0; n < s.scene.time.size(); ++n) {
        const double t = s.scene.time[n];
        double expected = 0;
        for (int i = 0; i < 9; ++i) {
            const double limit = 50 * (i == 0 || i == 8 ? 2 : 4);
            const double top = std::min(k * u(std::min(t, 0.5)), limit);
            expected += t <= 0.5 ? top : std::max(top - k * (u(0.5) - u(t)), -limit);
        }
        CHECK(-h.steps[n].restraint.x == Approx(expected).margin(1e-9 * 1600));
    }
    REQUIRE(h.first_slip);
    CHECK(u(*h.first_slip) == Approx(100 / k).epsilon(1e-9)); // end nodes have half the length
    CHECK(-h.energy.restraint_work == Approx(h.energy.dissipated + h.energy.stored).epsilon(1e-12));
    double dissipated = 0; // limit times way, less the way of the spring: once on, twice that back
    for (int i = 0; i < 9; ++i) {
        const double limit = 50 * (i == 0 || i == 8 ? 2 : 4);
        dissipated += limit * (u(0.5) - limit / k) + limit * (u(0.5) - 2 * limit / k);
    }
    CHECK(h.energy.dissipated == Approx(dissipated).epsilon(1e-9));
    CHECK(h.energy.created == 0);
}

TEST_CASE("manual law: what is stored is forgotten at lift-off, under the solver it is not") {
    SheetScene s({100, 0, 50, 0, 5});
    s.times(1, 400);
    s.blank().terms.push_back(velocity(0, TimeTable({0, 0.25, 0.2500001, 1}, {0.4, 0.4, 0, 0})));
    s.tool().terms.push_back(displacement(2, TimeTable({0, 0.3, 0.5, 0.7, 1}, {0, 0, 20, 0, 0})));
    const BeadHistory manual = s.history(Law::manual), solver = s.history(Law::solver);
    CHECK(norm(manual.steps[100].restraint) == Approx(1600));
    CHECK(norm(manual.steps[200].restraint) == 0);
    CHECK(norm(manual.steps[400].restraint) == Approx(0).margin(1e-9));
    CHECK(norm(solver.steps[400].restraint) == Approx(1600).epsilon(1e-3));
    CHECK(manual.energy.stored == Approx(0).margin(1e-12));
}

TEST_CASE("a window: nothing outside, forces at both ends under the solver, not at Tstop by the manual") {
    SheetScene s({100, 0, 50, 0, 5});
    s.blank().terms.push_back(velocity(0, TimeTable::constant(1)));
    s.bead().t_start = 0.25;
    s.bead().t_stop = 0.75;
    const BeadHistory manual = s.history(Law::manual), solver = s.history(Law::solver);
    for (const BeadHistory* h : {&manual, &solver}) {
        CHECK(h->steps[24].in_contact == 0);
        CHECK(h->steps[25].in_contact == 9);
        CHECK(h->steps[74].in_contact == 9);
        CHECK(h->steps[76].in_contact == 0);
        CHECK(h->first_contact == 0.25);
    }
    CHECK(solver.steps[75].in_contact == 9);
    CHECK(manual.steps[75].in_contact == 0);
    CHECK(manual.energy.stored == 0);
    CHECK(-manual.energy.restraint_work == Approx(manual.energy.dissipated).epsilon(1e-12));
}

TEST_CASE("what moves together feels nothing of it: the manual's law is relative, the solver's is not") {
    SheetScene s({100, 0, 50, 0, 5});
    for (Motion& motion : s.scene.motions)
        motion.terms.push_back(velocity(0, TimeTable::constant(20)));
    CHECK(s.history(Law::manual).steps.back().restraint_sum == Approx(0).margin(1e-6));
    CHECK(norm(s.history(Law::solver).steps.back().restraint) == Approx(1600));

    SheetScene turned({100, 0, 50, 0, 5});
    for (Motion& motion : turned.scene.motions)
        motion.turn = Motion::Turn{{50, 50, 0}, {1, 0, 0}, TimeTable({0, 1}, {0, 1})};
    const BeadHistory h = turned.history(Law::manual);
    CHECK(norm(h.steps.back().normal) == Approx(3200).epsilon(1e-12));
    CHECK(h.steps.back().restraint_sum == Approx(0).margin(1e-6));
    const Vec3 normal = h.steps.back().normal / -3200.0;
    CHECK(distance(normal, {0, -std::sin(1.0), std::cos(1.0)}) < 1e-12);
}

TEST_CASE("beside the free edge the manual has contact for 5 % of a segment") {
    for (const auto& [x, nodes] : {std::pair{100.2, 9u}, std::pair{100.3, 0u}}) {
        SheetScene s({100, 0, 50, 0, 5}, 0.3, x);
        s.tool().terms.push_back(velocity(1, TimeTable::constant(1)));
        CHECK(s.history(Law::manual).steps.back().in_contact == nodes);
    }
}

TEST_CASE("forces at the feet and their reactions: the couple between them") {
    SheetScene s({100, 300, 50, 10, 5}, 3);
    s.blank().terms.push_back(velocity(0, TimeTable::constant(2)));
    for (const Law law : {Law::solver, Law::manual}) {
        const BeadPlan plan = s.planned(law, true);
        auto one = s.run(law, plan.needed());
        const auto samples = one->take_samples();
        for (const auto& sample : samples) {
            Vec3 couple, total;
            for (const NodeSample& node : sample.nodes) {
                const Vec3 foot = node.x - node.distance * Vec3{0, 0, 1};
                couple += cross(foot - node.x, node.normal + node.restraint);
                total += node.normal + node.restraint;
            }
            const StepTotals& step = one->history().steps[sample.step];
            CHECK(distance(step.couple, couple) <= 1e-9 * 2000);
            CHECK(distance(step.total(), total) <= 1e-12 * 3200);
        }
    }
}

TEST_CASE("plan: what a scene does not call for is left out, with the numbers that say so") {
    using E_ = Effect;
    SECTION("out of reach") {
        SheetScene s({100, 0, 50, 0, 5}, 12.4);
        s.blank().terms.push_back(velocity(0, TimeTable::constant(20)));
        for (const Law law : {Law::solver, Law::manual}) {
            const BeadPlan plan = s.planned(law);
            CHECK(plan[E_::search].verdict == Verdict::off);
            CHECK(plan[E_::search].reason == "nearest approach 12.4 > DEPTH + t/2 = 5.5");
            CHECK(s.history(law).steps.back().in_contact == 0);
        }
        CHECK(s.planned(Law::solver, true)[E_::search].verdict == Verdict::on);
    }
    SECTION("just in reach at the end") {
        SheetScene s({100, 0, 50, 0, 5}, 12.4);
        s.tool().terms.push_back(velocity(2, TimeTable::constant(-7)));
        for (const Law law : {Law::solver, Law::manual}) {
            CHECK(s.planned(law)[E_::search].verdict == Verdict::on);
            CHECK(s.history(law).steps.back().in_contact == 9);
        }
    }
    SECTION("reversed sheet: no distance is too large, behind it") {
        SheetScene s({100, 0, 50, 0, 5}, -12.4);
        for (const Law law : {Law::solver, Law::manual})
            CHECK(s.planned(law)[E_::search].verdict == Verdict::on);
        CHECK(s.history(Law::solver).steps.back().in_contact == 9);
    }
    SECTION("static: one step stands for all") {
        SheetScene s({100, 0, 50, 0, 5});
        for (const Law law : {Law::solver, Law::manual}) {
            const BeadPlan plan = s.planned(law);
            CHECK(plan[E_::moving].verdict == Verdict::off);
            CHECK(plan[E_::energy].verdict == Verdict::off);
            CHECK(plan[E_::incremental].verdict == Verdict::off);
            const auto one = s.run(law);
            CHECK(one->counts()[static_cast<std::size_t>(E_::normal)] <= 9 * 3);
            CHECK(one->history().steps.back().normal.z == Approx(-3200));
            CHECK(one->history().impulse.z == Approx(-3200));
        }
    }
    SECTION("closed window") {
        SheetScene s({100, 0, 50, 0, 5});
        s.bead().t_start = 2;
        for (const Law law : {Law::solver, Law::manual})
            CHECK(s.planned(law)[E_::search].verdict == Verdict::off);
    }
    SECTION("a blank that moves in two parts deforms") {
        SheetScene s({100, 0, 50, 0, 5});
        s.scene.motions.push_back({});
        s.scene.motions[2].terms.push_back(velocity(0, TimeTable::constant(1)));
        for (std::size_t i = 0; i < s.scene.surfaces[0].motion.size(); ++i)
            if (s.scene.surfaces[0].mesh.x[i].x > 50) s.scene.surfaces[0].motion[i] = 2;
        for (const Law law : {Law::solver, Law::manual}) {
            CHECK(s.planned(law)[E_::deforming_blank].verdict == Verdict::on);
            CHECK(s.planned(law)[E_::search].verdict == Verdict::on);
            CHECK(norm(s.history(law).steps.back().restraint) > 0);
        }
    }
}
