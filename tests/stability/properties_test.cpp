// What holds for any scene, each for the law that it is named after; a counterexample is printed made small.
#include "force/manual_law.h"
#include "force/solver_law.h"
#include "geometry/closest_point.h"
#include "study/hard_scene.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <rapidcheck.h>

using namespace drawbead;

namespace {

/// A number of thousandths between two bounds.
double between(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000;
}
Vec3 vector_within(double size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
}
/// Any magnitude, either sign or not.
double any_number(bool with_sign) {
    const double size = std::pow(10.0, *rc::gen::inRange(-300, 301)) * between(1, 9);
    return with_sign && *rc::gen::arbitrary<bool>() ? -size : size;
}

/// Limits, ramp and motion as they come; on a place without ties, and never at a height at which the solver's
/// law jumps (hard cases linear-Fn and reset-slope): rounding would take one side or the other.
SheetSpec any_scene(Law law) {
    SheetSpec spec;
    spec.steps = 24;
    spec.iform = *rc::gen::element(1, 2).as("Iform");
    spec.law = {between(0, 200), between(0, 200), between(0, 90), between(0, 90), between(0, 6)};
    if (law == Law::solver && spec.law.depth < 0.5) spec.law.depth = 0.5;
    spec.straight(52.1 + between(0, 0.8), 0.000317 + between(-1, 5), 31.2 + between(0, 0.8), 3.7);
    for (const std::size_t axis : {0u, 1u})
        spec.blank.terms.push_back(
            speed(axis, TimeTable({0, 0.4, 1}, {between(-2, 2), between(-2, 2), between(-2, 2)})));
    spec.tool.terms = {way(2, TimeTable({0, 0.5, 1}, {0, between(-2, 4), between(-2, 4)}))};
    return spec;
}

double apart(const SheetOutcome& a, const SheetOutcome& b) {
    double worst = 0;
    for (std::size_t n = 0; n < a.history.steps.size(); ++n)
        worst = std::max({worst, norm(a.history.steps[n].normal - b.history.steps[n].normal),
                          norm(a.history.steps[n].restraint - b.history.steps[n].restraint)});
    return worst;
}
double scale(const SheetSpec& spec) {
    return 34 * std::max({1.0, spec.law.fn_first, spec.law.fn_last, spec.law.ft_first, spec.law.ft_last});
}

/// A rotation, by Rodrigues' formula, or a mirror image of it.
struct Frame {
    Vec3 axis{0, 0, 1};
    double angle = 0;
    bool mirror = false;

    Vec3 operator()(Vec3 v) const {
        if (mirror) v.x = -v.x;
        return std::cos(angle) * v + std::sin(angle) * cross(axis, v) +
               (1 - std::cos(angle)) * dot(axis, v) * axis;
    }
    Motion of(const Motion& motion) const {
        Motion out;
        for (const Motion::Term& term : motion.terms) {
            const Vec3 to =
                (*this)({term.axis == 0 ? 1.0 : 0, term.axis == 1 ? 1.0 : 0, term.axis == 2 ? 1.0 : 0});
            for (const auto& [along, share] :
                 {std::pair{0u, to.x}, std::pair{1u, to.y}, std::pair{2u, to.z}}) {
                Motion::Term one = term;
                one.axis = along;
                one.scale *= share;
                out.terms.push_back(one);
            }
        }
        return out;
    }
};

/// The scene as another frame sees it.
SheetSpec seen(SheetSpec spec, const Frame& frame, Vec3 shift) {
    spec.place = [=](Vec3 x) { return frame(x) + shift; };
    spec.flipped = frame.mirror;
    spec.tool = frame.of(spec.tool);
    spec.blank = frame.of(spec.blank);
    return spec;
}
double apart(const SheetOutcome& a, const SheetOutcome& b, const Frame& frame) {
    double worst = 0;
    for (std::size_t n = 0; n < a.history.steps.size(); ++n)
        worst = std::max({worst, norm(frame(a.history.steps[n].normal) - b.history.steps[n].normal),
                          norm(frame(a.history.steps[n].restraint) - b.history.steps[n].restraint)});
    return worst;
}

constexpr std::array<Law, 2> both_laws{Law::manual, Law::solver};

} // namespace

TEST_CASE("any scene, both laws: forces go with a rigid motion of everything") {
    for (const Law law : both_laws)
        CHECK(rc::check([law] {
            const SheetSpec spec = any_scene(law);
            Frame frame;
            const Vec3 axis = vector_within(1);
            RC_PRE(norm(axis) > 0.1);
            frame.axis = axis / norm(axis);
            frame.angle = between(-3, 3);
            const SheetOutcome other = evaluate(seen(spec, frame, vector_within(1000)), law);
            RC_ASSERT(apart(evaluate(spec, law), other, frame) <= 1e-8 * scale(spec));
        }));
}

TEST_CASE("any scene, both laws: forces are mirrored with everything") {
    for (const Law law : both_laws)
        CHECK(rc::check([law] {
            const SheetSpec spec = any_scene(law);
            Frame frame;
            frame.mirror = true;
            frame.angle = between(-3, 3);
            const SheetOutcome other = evaluate(seen(spec, frame, vector_within(100)), law);
            RC_ASSERT(apart(evaluate(spec, law), other, frame) <= 1e-8 * scale(spec));
        }));
}

TEST_CASE("any scene, manual law: forces do not depend on the units") {
    CHECK(rc::check([] {
        const SheetSpec spec = any_scene(Law::manual);
        // One new unit of length, force and time in old ones.
        const double l = std::pow(10.0, *rc::gen::inRange(-4, 5)),
                     f = std::pow(10.0, *rc::gen::inRange(-4, 5)),
                     t = std::pow(10.0, *rc::gen::inRange(-4, 5));
        SheetSpec other = spec;
        other.size /= l;
        other.thickness /= l;
        other.young *= l * l / f;
        other.node_mass *= l / (f * t * t); // force · time² / length
        other.law = {spec.law.fn_first * l / f, spec.law.fn_last * l / f, spec.law.ft_first * l / f,
                     spec.law.ft_last * l / f, spec.law.depth / l};
        for (Vec3& x : other.bead)
            x = x / l;
        for (Motion* motion : {&other.tool, &other.blank})
            for (Motion::Term& term : motion->terms) {
                term.scale /= term.velocity ? l / t : l;
                term.time_scale = 1 / t;
            }
        other.end = 1 / t;
        SheetOutcome one = evaluate(spec, Law::manual), two = evaluate(other, Law::manual);
        for (StepTotals& step : two.history.steps)
            step.normal = f * step.normal, step.restraint = f * step.restraint;
        RC_ASSERT(apart(one, two) <= 1e-6 * scale(spec));
    }));
}

TEST_CASE("any scene, both laws: node ids and the order of segments do not matter") {
    for (const Law law : both_laws)
        CHECK(rc::check([law] {
            SheetSpec spec = any_scene(law);
            const SheetOutcome plain = evaluate(spec, law);
            spec.shuffle = static_cast<unsigned>(*rc::gen::inRange(1, 100000));
            RC_ASSERT(apart(plain, evaluate(spec, law)) <= 1e-9 * scale(spec));
        }));
}

TEST_CASE("any scene, manual law: the list from its other end with swapped values") {
    CHECK(rc::check([] {
        SheetSpec spec = any_scene(Law::manual);
        RC_PRE(spec.law.fn_first > 0 && spec.law.fn_last > 0 && spec.law.ft_first > 0 &&
               spec.law.ft_last > 0);
        const SheetOutcome forth = evaluate(spec, Law::manual);
        std::reverse(spec.bead.begin(), spec.bead.end());
        std::swap(spec.law.fn_first, spec.law.fn_last);
        std::swap(spec.law.ft_first, spec.law.ft_last);
        RC_ASSERT(apart(forth, evaluate(spec, Law::manual)) <= 1e-9 * scale(spec));
    }));
}

TEST_CASE("any scene with a constant Fn, solver's law: the list from its other end with swapped values") {
    CHECK(rc::check([] {
        SheetSpec spec = any_scene(Law::solver);
        spec.law.fn_last = 0;
        RC_PRE(spec.law.ft_first > 0 && spec.law.ft_last > 0);
        const SheetOutcome forth = evaluate(spec, Law::solver);
        std::reverse(spec.bead.begin(), spec.bead.end());
        std::swap(spec.law.ft_first, spec.law.ft_last);
        RC_ASSERT(apart(forth, evaluate(spec, Law::solver)) <= 1e-9 * scale(spec));
    }));
}

TEST_CASE("a bead cut at any node, both laws: Fn is the sum, and so is a restraint that slips") {
    for (const Law law : both_laws)
        CHECK(rc::check([law] {
            SheetSpec spec = any_scene(law);
            spec.iform = 2;
            spec.node_mass = 0;
            spec.law.fn_last = spec.law.ft_last = 0;
            spec.law.depth = 5;
            spec.straight(52.25, 0.25);
            spec.tool.terms.clear();
            spec.blank.terms = {speed(0, TimeTable::constant(between(0.5, 3)))};
            const std::vector<Vec3> whole = spec.bead;
            const Vec3 together = evaluate(spec, law).end().total();
            const auto cut = static_cast<std::ptrdiff_t>(*rc::gen::inRange(1, 8));
            spec.bead.assign(whole.begin(), whole.begin() + cut + 1);
            Vec3 sum = evaluate(spec, law).end().total();
            spec.bead.assign(whole.begin() + cut, whole.end());
            sum += evaluate(spec, law).end().total();
            RC_ASSERT(norm(sum - together) <= 1e-9 * scale(spec));
        }));
}

TEST_CASE("any scene, manual law: steps of any lengths end with the same forces and energies") {
    CHECK(rc::check([] {
        SheetSpec spec = any_scene(Law::manual);
        spec.iform = 2;
        spec.tool.terms.clear(); // lifting goes through shrinking limits: the limit of small steps
        const SheetOutcome even = evaluate(spec, Law::manual);
        spec.time = {0};
        while (spec.time.back() < 1)
            spec.time.push_back(std::min(spec.time.back() + between(0.001, 0.3), 1.0));
        const SheetOutcome uneven = evaluate(spec, Law::manual);
        RC_ASSERT(norm(even.end().restraint - uneven.end().restraint) <= 1e-7 * scale(spec));
        RC_ASSERT(std::abs(even.history.energy.dissipated - uneven.history.energy.dissipated) <=
                  1e-7 * scale(spec));
    }));
}

TEST_CASE("any scene, manual law: nothing is created, dissipation is not negative, work is accounted for") {
    CHECK(rc::check([] {
        const SheetSpec spec = any_scene(Law::manual);
        const SheetOutcome out = evaluate(spec, Law::manual);
        const BeadEnergy& e = out.history.energy;
        RC_ASSERT(out.is_finite());
        RC_ASSERT(e.created == 0);
        RC_ASSERT(e.dissipated >= 0);
        RC_ASSERT(e.stored >= 0);
    }));
}

TEST_CASE("any scene, solver's law, Iform 1: nothing is created, dissipation is not negative") {
    CHECK(rc::check([] {
        SheetSpec spec = any_scene(Law::solver);
        spec.iform = 1;
        spec.blank.terms = {speed(0, TimeTable::constant(between(-3, 3)))}; // the trapezium rule is exact
        const BeadEnergy e = evaluate(spec, Law::solver).history.energy;
        RC_ASSERT(e.created <= 1e-12 * scale(spec));
        RC_ASSERT(e.dissipated >= 0);
    }));
}

TEST_CASE("any scene, both laws: |restraint| is no more than limit times length") {
    for (const Law law : both_laws)
        CHECK(rc::check([law] {
            const SheetSpec spec = any_scene(law);
            const SheetOutcome out = evaluate(spec, law);
            const double most = out.history.restraint_capacity * (1 + 1e-12);
            for (const StepTotals& step : out.history.steps)
                RC_ASSERT(step.restraint_sum <= most);
        }));
}

TEST_CASE("one node, manual law: finite in, finite out, from 1e-300 to 1e300, and within the limit") {
    CHECK(rc::check([] {
        BeadLaw<double> law{any_number(true), any_number(true), any_number(true), any_number(true),
                            any_number(true)};
        ManualContact<double> at;
        const Vec3 normal = vector_within(1);
        RC_PRE(norm(normal) > 0.1);
        at.normal = normal / norm(normal);
        at.distance = any_number(true);
        at.stiffness = any_number(false);
        at.half_thickness = any_number(false);
        at.mass = any_number(false);
        ManualInput<double> in;
        in.tributary = any_number(false);
        in.half_chord = in.tributary * Vec3{0, 0.6, -0.8};
        in.s_fraction = between(0, 1);
        in.velocity = any_number(true) * Vec3{1, 0, 0};
        in.displacement = any_number(true) * Vec3{0.6, 0.8, 0};
        double q = any_number(true);
        // Numbers that the law itself asks for and that no double holds are not its fault.
        const double limit = std::max(
            {std::abs(law.fn_first), std::abs(law.fn_last), std::abs(law.ft_first), std::abs(law.ft_last)});
        RC_PRE(std::isfinite(limit * in.tributary * 4));
        RC_PRE(
            std::isfinite(at.stiffness * (std::abs(law.depth) + std::abs(at.distance) + at.half_thickness)));
        RC_PRE(std::isfinite(at.stiffness * norm(in.displacement) + std::abs(q)));
        RC_PRE(std::isfinite(norm(in.displacement)));
        RC_PRE(std::isfinite(std::sqrt(at.stiffness * at.mass) * norm(in.velocity)));
        const auto fine = [&](const ManualForce<double>& f) {
            const double most = f.ft_limit * in.tributary * f.ramp * (1 + 1e-15);
            return std::isfinite(f.normal_force) && std::isfinite(f.restraint) && std::isfinite(f.total.x) &&
                   std::isfinite(f.total.y) && std::isfinite(f.total.z) && f.ramp >= 0 && f.ramp <= 1 &&
                   f.normal_force >= 0 && f.normal_force <= f.fn_limit * in.tributary &&
                   std::abs(f.restraint) <= most;
        };
        RC_ASSERT(fine(manual_node_force<double, Effects{Restraint::viscous, true, true}>(law, at, in, q)));
        RC_ASSERT(
            fine(manual_node_force<double, Effects{Restraint::incremental, true, true}>(law, at, in, q)));
        RC_ASSERT(std::isfinite(q));
    }));
}

TEST_CASE("one node, solver's law: finite in, finite out, and |restraint| within the limit") {
    // Lengths from 1e-150 to 1e150 only: the law squares them (hard case huge-length).
    CHECK(rc::check([] {
        const auto length = [] { return std::pow(10.0, *rc::gen::inRange(-70, 71)) * between(1, 9); };
        const auto sized = [](int reach) {
            return std::pow(10.0, *rc::gen::inRange(-reach, reach + 1)) * between(1, 9);
        };
        const BeadLaw<double> law{sized(100), sized(100), sized(100), sized(100), length()};
        SegmentState<double> segment;
        const double size = length();
        const std::array<Vec3, 4> square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
        const double speed = sized(50);
        for (std::size_t k = 0; k < 4; ++k) {
            segment.x[k] = size * (square[k] + vector_within(0.2));
            segment.v[k] = speed * vector_within(1);
            segment.mass[k] = sized(50);
        }
        segment.stiffness = sized(50);
        segment.half_thickness = length();
        NodeInput<double> in;
        in.x = size * Vec3{0.5, 0.5, between(-2, 2)};
        in.half_chord = length() * Vec3{0.6, 0.8, 0};
        in.s_fraction = between(0, 1);
        in.slope = law.fn_first / law.depth;
        in.dt = sized(50);
        NodeState<double> state;
        const auto fine = [&](const NodeForce<double>& f) {
            return std::isfinite(f.total.x) && std::isfinite(f.total.y) && std::isfinite(f.total.z) &&
                   std::isfinite(f.restraint) && std::abs(f.restraint) <= std::abs(f.ft_limit);
        };
        RC_ASSERT(fine(
            solver_node_force<double, Effects{Restraint::viscous, true, true}>(law, segment, in, state)));
        RC_ASSERT(fine(
            solver_node_force<double, Effects{Restraint::incremental, true, true}>(law, segment, in, state)));
    }));
}

TEST_CASE("any quad, both laws: weights sum to 1, and the manual's foot is what they say") {
    CHECK(rc::check([] {
        Corners corner;
        for (Vec3& c : corner)
            c = vector_within(10);
        if (*rc::gen::arbitrary<bool>().as("triangle")) corner[3] = corner[2];
        const Vec3 bead = vector_within(15);
        const auto at = project(corner, bead);
        double sum = 0;
        for (const double h : at.weight)
            sum += h;
        const double largest = std::max({1.0, std::abs(at.xi), std::abs(at.eta), std::abs(at.xi * at.eta)});
        RC_ASSERT(std::abs(sum - 1) <= 1e-15 * 4 * largest);
        const Foot foot = closest_point(corner, bead);
        const auto h = bilinear_weights(foot.xi, foot.eta);
        RC_ASSERT(std::abs(h[0] + h[1] + h[2] + h[3] - 1) <= 1e-15);
        for (const double weight : h)
            RC_ASSERT(weight >= 0);
        RC_ASSERT(norm(patch_point(corner, foot.xi, foot.eta) - foot.point) <= 1e-6);
    }));
}

TEST_CASE("one node, manual law: a step in two parts of the same direction") {
    CHECK(rc::check([] {
        BeadLaw<double> law{0, 0, between(1, 100), 0, 5};
        ManualContact<double> at;
        at.normal = {0, 0, 1};
        at.stiffness = between(1, 1e5);
        ManualInput<double> in;
        in.half_chord = {0, 4, 0};
        in.tributary = 4;
        double whole = 4 * law.ft_first * between(-1, 1), parts = whole;
        const double a = between(0, 0.02), b = between(0, 0.02), sign = *rc::gen::element(-1.0, 1.0);
        const auto step = [&](double way, double& q) {
            in.displacement = {sign * way, 0, 0};
            manual_node_force<double, Effects{Restraint::incremental, true, true}>(law, at, in, q);
        };
        step(a + b, whole);
        step(a, parts);
        step(b, parts);
        RC_ASSERT(std::abs(whole - parts) <= 1e-12 * (400 + at.stiffness * 0.04));
    }));
}
