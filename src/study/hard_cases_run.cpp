// Hard cases of whole runs: motion, windows, energies, and the frames, units and orders that forces must not
// depend on.
#include "study/hard_case_table.h"
#include "study/hard_scene.h"

#include <algorithm>
#include <numbers>

namespace drawbead {

namespace {

constexpr double k = 42000, length = 32; ///< stiffness and Σ L of the sheet as it is
constexpr double full_normal = 100 * length, full_restraint = 50 * length;

SheetSpec pulled(double velocity = 1) {
    SheetSpec spec;
    spec.blank.terms = {speed(0, TimeTable::constant(velocity))};
    spec.blank.initial_velocity = {velocity, 0, 0};
    return spec;
}

template <Law law>
HardCaseResult empty_window() {
    SheetSpec spec = pulled();
    spec.t_start = spec.t_stop = 0.5;
    const SheetOutcome out = evaluate(spec, law);
    double steps = 0;
    for (const StepTotals& step : out.history.steps)
        steps += step.in_contact > 0;
    return within(std::abs(steps - (law == Law::solver ? 1 : 0)), 0);
}

HardCaseResult windows_add_up() {
    SheetSpec spec = pulled();
    spec.iform = 1;
    const Vec3 whole = evaluate(spec, Law::manual).history.impulse;
    spec.t_stop = 0.5;
    Vec3 sum = evaluate(spec, Law::manual).history.impulse;
    spec.t_start = 0.5;
    spec.t_stop = 1e30;
    sum += evaluate(spec, Law::manual).history.impulse;
    return within(norm(sum - whole) / norm(whole), 32 * eps<double>);
}

/// Times of which some stand two or three times.
std::vector<double> repeated_times(bool repeated) {
    std::vector<double> t;
    for (int n = 0; n <= 100; ++n)
        for (int again = 0; again <= (repeated && n % 10 == 5 ? 2 : 0); ++again)
            t.push_back(0.01 * n);
    return t;
}
template <Law law>
HardCaseResult repeated(bool displacement) {
    SheetSpec spec;
    spec.node_mass = 0; // the solver's damper needs a step
    if (displacement)
        spec.blank.terms = {way(0, TimeTable({0, 0.5, 1}, {0, 1, -0.5}))};
    else
        spec.blank.terms = {speed(0, TimeTable({0, 0.5, 0.5 + 1e-9, 1}, {2, 2, -3, -3}))};
    spec.time = repeated_times(false);
    const SheetOutcome once = evaluate(spec, law);
    spec.time = repeated_times(true);
    const SheetOutcome often = evaluate(spec, law);
    const double error = norm(once.end().restraint - often.end().restraint) / full_restraint +
                         std::abs(once.history.energy.dissipated / often.history.energy.dissipated - 1);
    return within(often.is_finite() ? error : HUGE_VAL, 1e-9);
}
template <Law law>
HardCaseResult repeated_velocity() {
    return repeated<law>(false);
}
template <Law law>
HardCaseResult repeated_displacement() {
    return repeated<law>(true);
}

SheetOutcome one_place(Law law) {
    SheetSpec spec = pulled();
    spec.law = {100, 300, 50, 10, 5};
    spec.bead.assign(9, Vec3{52.25, 40, 0.25});
    return evaluate(spec, law);
}
HardCaseResult one_place_manual() {
    const SheetOutcome out = one_place(Law::manual);
    return within(out.is_finite() ? norm(out.end().total()) : HUGE_VAL, 0);
}
HardCaseResult one_place_solver() {
    const StepTotals end = one_place(Law::solver).end();
    const double size = norm(end.total());
    return within(std::isfinite(size) ? std::max(size - 9 * 400e-10, 0.0) : HUGE_VAL, 0);
}
HardCaseResult one_place_capacity() {
    return within(one_place(Law::solver).history.restraint_capacity, 0);
}

HardCaseResult solid_face() {
    SheetSpec spec;
    spec.solid = true;
    const SheetOutcome out = evaluate(spec, Law::manual);
    return within(out.is_finite() ? std::abs(out.end().normal_sum - 0.95 * full_normal) : HUGE_VAL,
                  full_normal * 8 * eps<double>);
}

/// A blank without stiffness, lifted off in the end; Ft alone.
SheetOutcome void_blank(Law law, bool lifted) {
    SheetSpec spec = pulled();
    spec.young = 0;
    spec.law = {0, 0, 50, 0, 5};
    if (lifted) spec.tool.terms = {way(2, TimeTable({0, 0.5, 1}, {0, 0, 50}))};
    return evaluate(spec, law);
}
HardCaseResult void_dissipation() {
    return within(std::abs(void_blank(Law::manual, false).history.energy.dissipated), 0);
}
HardCaseResult void_work() {
    return within(std::abs(void_blank(Law::manual, false).history.energy.restraint_work), 0);
}
template <Law law>
HardCaseResult void_stored() {
    return within(std::abs(void_blank(law, false).history.energy.stored), 0);
}
HardCaseResult void_lift_off() {
    return within(std::abs(void_blank(Law::manual, true).history.energy.dissipated), 0);
}

HardCaseResult triangle_masses() {
    SheetSpec spec = pulled(1e-3);
    spec.iform = 1;
    spec.triangles = true;
    const auto mass = [](double x, double y) { return 1e-7 * (1 + x + 3 * y); };
    spec.mass = [&](Vec3 x) { return mass(x.x, x.y); };
    const StepTotals end = evaluate(spec, Law::manual).end();
    double expected = 0;
    for (const Vec3& node : spec.bead) {
        const double x = node.x - 1e-3; // the blank has gone on
        const double i = std::floor(x / 5), j = std::floor(node.y / 5);
        const bool lower = x - 5 * i > node.y - 5 * j;
        // A linear field has its mean over the corners at the centroid.
        const double mean =
            lower ? mass(5 * i + 10.0 / 3, 5 * j + 5.0 / 3) : mass(5 * i + 5.0 / 3, 5 * j + 10.0 / 3);
        expected += std::sqrt(k * mean) * 1e-3;
    }
    return within(std::abs(end.restraint_sum / expected - 1), 64 * eps<double>);
}

HardCaseResult pressing_only() {
    SheetSpec spec;
    spec.straight(52.25, 8);
    spec.tool.terms = {speed(2, TimeTable::constant(-9))};
    const SheetOutcome out = evaluate(spec, Law::manual);
    return within(out.is_finite() ? std::abs(out.history.energy.restraint_work) : HUGE_VAL, 0);
}

HardCaseResult moved_together_manual() {
    SheetSpec spec = pulled(20);
    spec.tool = spec.blank;
    return within(evaluate(spec, Law::manual).end().restraint_sum, 1e-9);
}
HardCaseResult moved_together_solver() {
    SheetSpec spec = pulled(20);
    spec.tool = spec.blank;
    return broken_by(norm(evaluate(spec, Law::solver).end().restraint), full_restraint, 1e-12);
}

/// Slips, stops, and is lifted off and set down.
SheetSpec lifted() {
    SheetSpec spec;
    spec.steps = 400;
    spec.node_mass = 0;
    spec.blank.terms = {speed(0, TimeTable({0, 0.25, 0.2500001, 1}, {0.4, 0.4, 0, 0}))};
    spec.tool.terms = {way(2, TimeTable({0, 0.3, 0.5, 0.7, 1}, {0, 0, 20, 0, 0}))};
    return spec;
}
HardCaseResult set_down_manual() {
    return within(evaluate(lifted(), Law::manual).end().restraint_sum, 1e-9);
}
HardCaseResult set_down_solver() {
    return broken_by(norm(evaluate(lifted(), Law::solver).end().restraint), full_restraint, 1e-9);
}

/// Turned, moved and drawn aslant: what a rigid motion of the whole scene leaves of the forces.
SheetSpec aslant() {
    SheetSpec spec;
    spec.law = {100, 300, 50, 10, 5};
    spec.straight(52.25, 2.25);
    spec.blank.terms = {speed(0, TimeTable({0, 1}, {2, -1})), speed(1, TimeTable::constant(1))};
    return spec;
}
template <Law law>
HardCaseResult rotated() {
    SheetSpec spec = aslant();
    const StepTotals here = evaluate(spec, law).end();
    // A turn whose matrix is of thirds: columns of length 1 to rounding.
    const auto turn = [](Vec3 v) {
        return Vec3{(2 * v.x - v.y + 2 * v.z) / 3, (2 * v.x + 2 * v.y - v.z) / 3,
                    (-v.x + 2 * v.y + 2 * v.z) / 3};
    };
    spec.place = [&](Vec3 x) { return turn(x) + Vec3{100, 200, -300}; };
    const std::vector<Motion::Term> terms = spec.blank.terms;
    spec.blank.terms.clear();
    for (const Motion::Term& term : terms)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Vec3 from{term.axis == 0 ? 1.0 : 0, term.axis == 1 ? 1.0 : 0, 0};
            const Vec3 to = turn(from);
            Motion::Term one = term;
            one.axis = axis;
            one.scale = axis == 0 ? to.x : axis == 1 ? to.y : to.z;
            spec.blank.terms.push_back(one);
        }
    const StepTotals there = evaluate(spec, law).end();
    return within((norm(turn(here.normal) - there.normal) + norm(turn(here.restraint) - there.restraint)) /
                      full_normal,
                  1e-10);
}

template <Law law>
HardCaseResult mirrored() {
    SheetSpec spec = aslant();
    const StepTotals here = evaluate(spec, law).end();
    spec.place = [](Vec3 x) { return Vec3{-x.x, x.y, x.z}; };
    spec.flipped = true; // the order of its nodes: normals look up again
    spec.blank.terms[0].scale = -1;
    const StepTotals there = evaluate(spec, law).end();
    const auto mirror = [](Vec3 v) { return Vec3{-v.x, v.y, v.z}; };
    return within(
        (norm(mirror(here.normal) - there.normal) + norm(mirror(here.restraint) - there.restraint)) /
            full_normal,
        1e-12);
}

template <Law law>
HardCaseResult translated() {
    SheetSpec spec = aslant();
    const StepTotals here = evaluate(spec, law).end();
    Largest error; // in ulp of the place over the segment's size and DEPTH
    for (const double offset : {1e6, 1e9}) {
        spec.place = [offset](Vec3 x) { return x + Vec3{offset, -offset, offset}; };
        const SheetOutcome out = evaluate(spec, law);
        const double apart =
            norm(here.normal - out.end().normal) + norm(here.restraint - out.end().restraint);
        error.add(out.is_finite() ? apart / full_normal / (eps<double> * offset / 5) : HUGE_VAL);
    }
    return within(error.value(), law == Law::manual ? 64 : 6400); // the solver adds up increments
}

/// The sheet and its numbers in metres, kilograms and newtons.
SheetSpec in_metres(SheetSpec spec) {
    spec.size *= 1e-3;
    spec.thickness *= 1e-3;
    spec.young *= 1e6;
    spec.node_mass *= 1e3;
    spec.law.depth *= 1e-3;
    for (double* limit : {&spec.law.fn_first, &spec.law.fn_last, &spec.law.ft_first, &spec.law.ft_last})
        *limit *= 1e3;
    for (Vec3& x : spec.bead)
        x = 1e-3 * x;
    for (Motion* motion : {&spec.tool, &spec.blank})
        for (Motion::Term& term : motion->terms)
            term.scale *= 1e-3;
    return spec;
}
HardCaseResult units_manual() {
    Largest error;
    for (const int iform : {1, 2}) {
        SheetSpec spec = aslant();
        spec.iform = iform;
        const StepTotals mm = evaluate(spec, Law::manual).end(),
                         m = evaluate(in_metres(spec), Law::manual).end();
        error.add((norm(mm.normal - m.normal) + norm(mm.restraint - m.restraint)) / full_normal);
    }
    // Fn/DEPTH of 100 N/mm² against k = 42 000 N/mm: the solver's test differs, this one does not.
    SheetSpec steep = aslant();
    steep.law.depth = 1;
    steep.straight(52.25, 1);
    const StepTotals mm = evaluate(steep, Law::manual).end(),
                     m = evaluate(in_metres(steep), Law::manual).end();
    error.add(norm(mm.normal - m.normal) / full_normal);
    return within(error.value(), 1e-10);
}
HardCaseResult units_solver() {
    SheetSpec spec = pulled();
    spec.iform = 1;
    const double mm = norm(evaluate(spec, Law::solver).end().restraint),
                 m = norm(evaluate(in_metres(spec), Law::solver).end().restraint);
    return broken_by(mm / m, 1000, 1e-9);
}
HardCaseResult reset_in_metres() {
    SheetSpec spec;
    spec.law = {100, 0, 50, 0, 1};
    spec.straight(52.25, 1); // half of the ramp
    const double mm = norm(evaluate(spec, Law::solver).end().normal),
                 m = norm(evaluate(in_metres(spec), Law::solver).end().normal);
    // With the slope reset: k δ L, at k = 4.2e7 N/m.
    return broken_by(m / mm, (4.2e7 * 0.5e-3 * 0.032) / (100 * 0.5 * 32), 1e-9);
}

HardCaseResult any_number_of_steps() {
    SheetSpec spec;
    spec.blank.terms = {speed(0, TimeTable({0, 0.3, 0.7, 1}, {1, -2, 1.5, 0}))};
    spec.steps = 128;
    const SheetOutcome fine = evaluate(spec, Law::manual);
    Largest error;
    for (const std::size_t steps : {1u, 7u, 64u}) {
        spec.steps = steps;
        const SheetOutcome coarse = evaluate(spec, Law::manual);
        error.add(norm(coarse.end().restraint - fine.end().restraint) / full_restraint);
        error.add(std::abs(coarse.history.energy.dissipated / fine.history.energy.dissipated - 1));
    }
    return within(error.value(), 1e-9);
}

/// Force while stuck, 10 µm / 1000 drawn.
double stuck_force(Law law, std::size_t nodes) {
    SheetSpec spec;
    spec.node_mass = 0;
    spec.straight(52.25, 0.25, 31.7, 32.0 / double(nodes - 1), nodes);
    spec.blank.terms = {way(0, TimeTable({0, 1}, {0, 1e-5}))};
    return norm(evaluate(spec, law).end().restraint);
}
template <Law law>
HardCaseResult stick_per_node() {
    return broken_by(stuck_force(law, 33) / stuck_force(law, 9), 33.0 / 9, 1e-6);
}
template <Law law>
HardCaseResult slip_of_refined() {
    SheetSpec spec = pulled();
    spec.node_mass = 0;
    const double coarse = norm(evaluate(spec, law).end().restraint);
    spec.straight(52.25, 0.25, 31.7, 1, 33);
    return within(std::abs(norm(evaluate(spec, law).end().restraint) / coarse - 1), 1e-12);
}

template <Law law>
HardCaseResult cut_in_two() {
    SheetSpec spec = pulled();
    spec.node_mass = 0;
    const std::vector<Vec3> whole = spec.bead;
    const Vec3 together = evaluate(spec, law).end().total();
    spec.bead.assign(whole.begin(), whole.begin() + 5);
    Vec3 sum = evaluate(spec, law).end().total();
    spec.bead.assign(whole.begin() + 4, whole.end());
    sum += evaluate(spec, law).end().total();
    return within(norm(sum - together) / full_normal, 1e-12);
}

template <Law law>
HardCaseResult reversed_list() {
    SheetSpec spec = aslant();
    const StepTotals forth = evaluate(spec, law).end();
    std::reverse(spec.bead.begin(), spec.bead.end());
    std::swap(spec.law.fn_first, spec.law.fn_last);
    std::swap(spec.law.ft_first, spec.law.ft_last);
    const StepTotals back = evaluate(spec, law).end();
    return within((norm(forth.normal - back.normal) + norm(forth.restraint - back.restraint)) / full_normal,
                  1e-12);
}
HardCaseResult reversed_list_solver() {
    // The ramp's slope is Fn_first/DEPTH for every node: which end is first matters.
    SheetSpec spec;
    spec.law = {100, 300, 0, 0, 5};
    spec.straight(52.25, 3);
    const double forth = evaluate(spec, Law::solver).end().normal_sum;
    std::reverse(spec.bead.begin(), spec.bead.end());
    std::swap(spec.law.fn_first, spec.law.fn_last);
    const double back = evaluate(spec, Law::solver).end().normal_sum;
    return broken_by(back / forth, 3, 1e-12);
}

template <Law law>
HardCaseResult renumbered() {
    SheetSpec spec = aslant();
    const StepTotals plain = evaluate(spec, law).end();
    Largest error;
    for (const unsigned seed : {1u, 2u, 3u}) {
        spec.shuffle = seed;
        const StepTotals other = evaluate(spec, law).end();
        error.add((norm(plain.normal - other.normal) + norm(plain.restraint - other.restraint)) /
                  full_normal);
    }
    return within(error.value(), 1e-12);
}

/// The bead goes 40 mm in one step.
double after_jump(Law law, std::size_t steps) {
    SheetSpec spec;
    spec.steps = steps;
    spec.tool.terms = {way(0, TimeTable({0, 1}, {0, -40}))};
    return evaluate(spec, law).end().normal_sum;
}
HardCaseResult jump_manual() {
    return within(std::abs(after_jump(Law::manual, 1) - full_normal), full_normal * 8 * eps<double>);
}
HardCaseResult jump_solver() {
    return broken_by(after_jump(Law::solver, 400) - after_jump(Law::solver, 1), full_normal, 1e-12);
}

template <Law law>
HardCaseResult reversed_normals() {
    SheetSpec spec;
    spec.flipped = true;
    spec.straight(52.25, 30); // out of reach
    return broken_by(evaluate(spec, law).end().normal_sum, full_normal, 1e-12);
}

HardCaseResult energy_from_nowhere() {
    SheetSpec spec = pulled();
    spec.iform = 1;
    spec.law.ft_first = -50;
    return broken_by(evaluate(spec, Law::solver).history.energy.created, full_restraint * 1, 1e-9);
}
HardCaseResult negative_limit_manual() {
    SheetSpec spec = pulled();
    spec.iform = 1;
    spec.law.ft_first = -50;
    const BeadEnergy e = evaluate(spec, Law::manual).history.energy;
    return within(std::abs(e.created) + std::abs(e.restraint_work), 0);
}

HardCaseResult last_normal_limit_alone() {
    SheetSpec spec;
    spec.law = {0, 300, 50, 10, 5};
    spec.all_stages = 1;
    return within(evaluate(spec, Law::solver).end().normal_sum, 0);
}

HardCaseResult time_grows_with_nodes() {
    const auto searches = [](std::size_t nodes) {
        SheetSpec spec = pulled();
        spec.steps = 20;
        spec.straight(52.25, 0.25, 20, 60.0 / double(nodes), nodes);
        return double(evaluate(spec, Law::manual).counts[std::size_t(Effect::search)]);
    };
    return within(searches(2000) / searches(1000) - 2, 0.02);
}

template <Law law>
HardCaseResult one_node() {
    SheetSpec spec = pulled();
    spec.bead.resize(1);
    const SheetOutcome out = evaluate(spec, law);
    const double least = law == Law::solver ? 150e-10 * (1 + 1e-9) : 0; // L² ≥ 1e-20
    return within(out.is_finite() ? std::max(norm(out.end().total()) - least, 0.0) : HUGE_VAL, 0);
}

template <Law law>
HardCaseResult two_nodes() {
    SheetSpec spec;
    spec.bead = {{52.25, 40, 0.25}, {52.25, 52, 0.25}};
    return within(std::abs(evaluate(spec, law).end().normal_sum - 1200), 0);
}

template <Law law>
HardCaseResult breakneck() {
    SheetSpec spec = pulled(1e9);
    spec.end = 1e-9;
    Largest over;
    for (const int iform : {1, 2}) {
        spec.iform = iform;
        for (const StepTotals& step : evaluate(spec, law).history.steps)
            over.add(step.restraint_sum / full_restraint - 1);
    }
    return within(over.value(), 8 * eps<double>);
}

HardCaseResult never_creates() {
    Largest error;
    for (unsigned seed = 1; seed <= 12; ++seed) {
        SheetSpec spec;
        const double s = seed;
        spec.iform = seed % 2 == 0 ? 1 : 2;
        spec.law = {100, 20 * s, 50, 5 * s, seed % 3 == 0 ? 0.0 : 2.0};
        spec.blank.terms = {
            speed(0, TimeTable({0, 0.3, 0.6, 1}, {std::sin(s), -std::cos(3 * s), 0.5, std::sin(7 * s)}))};
        spec.tool.terms = {way(2, TimeTable({0, 0.4, 0.8, 1}, {0, 2 + std::sin(s), -1, 6}))};
        const BeadEnergy e = evaluate(spec, Law::manual).history.energy;
        error.add(e.created);
        error.add(-e.dissipated);
        error.add(-e.stored);
    }
    return within(error.value(), 0);
}

template <Law law>
HardCaseResult couple() {
    SheetSpec spec = aslant();
    const SheetOutcome out = evaluate(spec, law);
    Vec3 force, moment;
    for (const NodeSample& node : out.last) {
        const Vec3 foot = node.x - node.distance * Vec3{0, 0, 1}; // over a flat sheet
        moment += cross(foot - node.x, node.normal + node.restraint);
        force += node.normal + node.restraint;
    }
    return within(
        norm(force - out.end().total()) / full_normal + norm(moment - out.end().couple) / full_normal, 1e-12);
}

template <Law law>
HardCaseResult over_mesh_nodes() {
    // Over nodes and edges of the mesh, as the blank is drawn over whole segments.
    SheetSpec spec;
    spec.straight(50, 0.25, 30, 5);
    spec.steps = 20;
    spec.blank.terms = {way(0, TimeTable({0, 1}, {0, 10}))};
    Largest error;
    for (const StepTotals& step : evaluate(spec, law).history.steps) {
        error.add(std::abs(step.normal_sum - 4000) / 4000);
        error.add(std::abs(double(step.in_contact) - 9));
    }
    return within(error.value(), 8 * eps<double>);
}

HardCaseResult out_and_in() {
    // Over the free edge by 0.5 mm and back: the same on both ways.
    SheetSpec spec;
    spec.straight(99.9375, 0.25);
    spec.tool.terms = {way(0, TimeTable({0, 0.5, 1}, {0, 0.5, 0}))};
    spec.steps = 512;
    const BeadHistory h = evaluate(spec, Law::manual).history;
    Largest error;
    for (std::size_t n = 0; n <= 512; ++n)
        error.add(std::abs(double(h.steps[n].in_contact) - h.steps[512 - n].in_contact));
    error.add(h.steps[256].in_contact); // it was out
    error.add(9.0 - h.steps[0].in_contact);
    return within(error.value(), 0);
}

HardCaseResult beyond_the_edge() {
    // Beside the free edge by 4 % and by 6 % of a segment of 5 mm.
    SheetSpec spec;
    spec.straight(100.2, 0.25);
    const double before = evaluate(spec, Law::manual).end().normal_sum;
    spec.straight(100.3, 0.25);
    return broken_by(before - evaluate(spec, Law::manual).end().normal_sum, full_normal, 1e-12);
}

template <Law law>
HardCaseResult out_of_this_world() {
    SheetSpec spec = pulled();
    Largest error;
    for (const double height : {1e10, 1e100, 1e160, 1e300}) {
        spec.straight(52.25, 0.25);
        spec.tool.terms = {way(2, TimeTable({0, 1}, {0, height}))};
        const SheetOutcome out = evaluate(spec, law);
        error.add(out.is_finite() ? norm(out.end().total()) : HUGE_VAL);
    }
    return within(error.value(), 0);
}

HardCaseResult huge_limits() {
    SheetSpec spec = pulled();
    Largest error;
    for (const double limit : {1e-300, 1e-30, 1e30, 1e150}) {
        spec.law = {limit, 0, limit, 0, 5};
        const SheetOutcome out = evaluate(spec, Law::manual);
        error.add(out.is_finite() ? 0 : HUGE_VAL);
        error.add(out.end().restraint_sum / (limit * length) - 1);
    }
    return within(error.value(), 16 * eps<double>);
}

} // namespace

std::vector<HardCaseRow> run_cases() {
    constexpr Law manual = Law::manual, solver = Law::solver;
    return {
        {"window-empty", manual, must_hold, "Tstart = Tstop.", "The window is half open: never any contact.",
         "force/manual_run.cpp: t < Tstop", empty_window<manual>},
        {"window-empty", solver, must_hold, "Tstart = Tstop at the time of a cycle.",
         "Both ends belong to it: contact in that cycle alone.", "force/solver_run.cpp: window",
         empty_window<solver>},
        {"window-split", manual, must_hold, "One window, and two that make it up.", "The impulses add up.",
         "", windows_add_up},
        {"repeated-times", manual, must_hold, "Times that stand three times, velocity given.",
         "The same forces and energies.", "", repeated_velocity<manual>},
        {"repeated-times", solver, must_hold, "Times that stand three times, velocity given, massless.",
         "The same forces and energies.", "force/motion.cpp: spread > 0", repeated_velocity<solver>},
        {"repeated-times-displacement", manual, must_hold,
         "Times that stand three times, displacement given.", "The same forces and energies.", "",
         repeated_displacement<manual>},
        {"repeated-times-displacement", solver, must_hold,
         "Times that stand three times, displacement given, massless.", "The same forces and energies.",
         "force/motion.cpp: dt > 0", repeated_displacement<solver>},
        {"one-place", manual, must_hold, "Nine nodes in one place, linear limits.", "Total 0, no 0/0.",
         "force/manual_run.cpp: length > 0", one_place_manual},
        {"one-place", solver, must_hold, "Nine nodes in one place, linear limits.",
         "Finite, no more than L = 1e-10 each gives.", "force/solver_run.cpp: s > 0", one_place_solver},
        {"one-place-capacity", solver, must_hold, "Nine nodes in one place, linear limits.",
         "ΣFt·L is 0, no 0/0.", "force/solver_run.cpp: length > 0", one_place_capacity},
        {"solid-faces", manual, must_hold, "The blank is of solids: no thickness.", "Fn by DEPTH alone.",
         "force/manual_run.cpp: half_thickness > 0", solid_face},
        {"void-dissipation", manual, must_hold, "A blank without stiffness, drawn.", "Nothing is dissipated.",
         "force/manual_run.cpp: slip without k", void_dissipation},
        {"void-work", manual, must_hold, "A blank without stiffness, drawn.", "No work is done.",
         "force/manual_run.cpp: spring without k", void_work},
        {"void-stored", manual, must_hold, "A blank without stiffness, drawn.", "Nothing is stored.",
         "force/manual_run.cpp: stored without k", void_stored<manual>},
        {"void-stored", solver, must_hold, "A blank without stiffness, drawn.", "Nothing is stored.",
         "force/solver_run.cpp: k > 0", void_stored<solver>},
        {"void-lift-off", manual, must_hold, "A blank without stiffness, drawn and left.",
         "Nothing is lost at lift-off.", "force/manual_run.cpp: released without k", void_lift_off},
        {"triangle-masses", manual, must_hold, "Iform 1 over triangles whose corners differ in mass.",
         "The mean of the three corners.", "force/manual_run.cpp: three corners", triangle_masses},
        {"pressing-only", manual, must_hold, "The bead closes without any sliding.",
         "No work of a restraint.", "force/manual_run.cpp: way != 0", pressing_only},
        {"moved-together", manual, must_hold, "Blank and bead move together.", "No restraint.", "",
         moved_together_manual},
        {"moved-together", solver, is_broken, "Blank and bead move together.", "No restraint.", "",
         moved_together_solver},
        {"set-down-again", manual, must_hold, "A slipping bead lifts off, and returns over a blank at rest.",
         "No restraint.", "", set_down_manual},
        {"set-down-again", solver, is_broken, "A slipping bead lifts off, and returns over a blank at rest.",
         "No restraint.", "", set_down_solver},
        {"rotated", manual, must_hold, "The whole scene turned and moved.", "Forces turn with it.", "",
         rotated<manual>},
        {"rotated", solver, must_hold, "The whole scene turned and moved.", "Forces turn with it.", "",
         rotated<solver>},
        {"mirrored", manual, must_hold, "The whole scene mirrored.", "Forces are mirrored.", "",
         mirrored<manual>},
        {"mirrored", solver, must_hold, "The whole scene mirrored.", "Forces are mirrored.", "",
         mirrored<solver>},
        {"scene-translated", manual, must_hold, "The whole scene 1e6 and 1e9 mm away.",
         "The same forces; in ulp of that place over 5 mm.", "", translated<manual>},
        {"scene-translated", solver, must_hold, "The whole scene 1e6 and 1e9 mm away.",
         "The same forces; in ulp of that place over 5 mm.", "", translated<solver>},
        {"units", manual, must_hold, "The scene in millimetres and in metres, both Iform, and a steep ramp.",
         "The same forces.", "", units_manual},
        {"units-viscous", solver, is_broken, "Iform 1 in millimetres and in metres.",
         "The same forces; measured: their ratio.", "", units_solver},
        {"units-reset", solver, is_broken, "A ramp of 100 N/mm² in millimetres and in metres.",
         "The same forces; measured: their ratio.", "", reset_in_metres},
        {"any-steps", manual, must_hold, "Two reversals in 1, 7, 64 and 128 steps.",
         "The same force and dissipation.", "", any_number_of_steps},
        {"stick-per-node", manual, is_broken, "The same bead with 9 and with 33 nodes, stuck.",
         "The same force; measured: their ratio.", "", stick_per_node<manual>},
        {"stick-per-node", solver, is_broken, "The same bead with 9 and with 33 nodes, stuck.",
         "The same force; measured: their ratio.", "", stick_per_node<solver>},
        {"slip-of-refined", manual, must_hold, "The same bead with 9 and with 33 nodes, slipping.",
         "The same force.", "", slip_of_refined<manual>},
        {"slip-of-refined", solver, must_hold, "The same bead with 9 and with 33 nodes, slipping.",
         "The same force.", "", slip_of_refined<solver>},
        {"cut-in-two", manual, must_hold, "A bead cut into two interfaces at a node, slipping.",
         "The sum of the two is the whole.", "", cut_in_two<manual>},
        {"cut-in-two", solver, must_hold, "A bead cut into two interfaces at a node, slipping.",
         "The sum of the two is the whole.", "", cut_in_two<solver>},
        {"list-reversed", manual, must_hold, "The list from its other end, first and last values swapped.",
         "The same forces.", "", reversed_list<manual>},
        {"list-reversed", solver, is_broken,
         "The list from its other end, Fn_first and Fn_last swapped, on the ramp.",
         "The same forces; measured: their ratio.", "", reversed_list_solver},
        {"renumbered", manual, must_hold, "Nodes renumbered and segments in any order.", "The same forces.",
         "", renumbered<manual>},
        {"renumbered", solver, must_hold, "Nodes renumbered and segments in any order.", "The same forces.",
         "", renumbered<solver>},
        {"jump", manual, must_hold, "The bead goes over eight segments in one step.",
         "The force of the new place.", "", jump_manual},
        {"jump", solver, is_broken, "The bead goes over eight segments in one step.",
         "The force of the new place; measured: what is missing.", "", jump_solver},
        {"reversed-normals", manual, is_broken, "Normals away from the bead, which is out of reach.",
         "No force.", "", reversed_normals<manual>},
        {"reversed-normals", solver, is_broken, "Normals away from the bead, which is out of reach.",
         "No force.", "", reversed_normals<solver>},
        {"negative-Ft-energy", manual, must_hold, "Ft = −50, Iform 1, drawn by 1 mm.",
         "No energy from nowhere.", "", negative_limit_manual},
        {"negative-Ft-energy", solver, is_broken, "Ft = −50, Iform 1, drawn by 1 mm.",
         "No energy from nowhere.", "", energy_from_nowhere},
        {"Fn-last-alone", solver, must_hold, "Fn_first = 0 with Fn_last = 300.", "No normal force.",
         "force/solver_run.cpp: fn_last = 0", last_normal_limit_alone},
        {"work-per-node", manual, must_hold, "Beads of 1000 and 2000 nodes.",
         "Twice the searches; measured: their ratio less 2.", "", time_grows_with_nodes},
        {"one-node", manual, must_hold, "A bead of one node.", "No force, no NaN.", "", one_node<manual>},
        {"one-node", solver, must_hold, "A bead of one node.", "No more than L = 1e-10 gives, no NaN.", "",
         one_node<solver>},
        {"two-nodes", manual, must_hold, "A bead of two nodes, 12 mm.", "Fn of its length.", "",
         two_nodes<manual>},
        {"two-nodes", solver, must_hold, "A bead of two nodes, 12 mm.", "Fn of its length.", "",
         two_nodes<solver>},
        {"breakneck", manual, must_hold, "The blank at 1e9 mm/s, both Iform.", "|restraint| ≤ ΣFt·L.", "",
         breakneck<manual>},
        {"breakneck", solver, must_hold, "The blank at 1e9 mm/s, both Iform.", "|restraint| ≤ ΣFt·L.", "",
         breakneck<solver>},
        {"no-energy-created", manual, must_hold, "Twelve motions with reversals and lift-off, both Iform.",
         "Nothing is created; dissipated and stored energy are not negative.", "", never_creates},
        {"couple", manual, must_hold, "Forces at the feet and their reactions on the bead.",
         "Totals and couple are sums over the nodes.", "", couple<manual>},
        {"couple", solver, must_hold, "Forces at the feet and their reactions on the bead.",
         "Totals and couple are sums over the nodes.", "", couple<solver>},
        {"over-mesh-nodes", manual, must_hold, "The bead over nodes and edges of the mesh.",
         "Each node counts once, at every step.", "", over_mesh_nodes<manual>},
        {"over-mesh-nodes", solver, must_hold, "The bead over nodes and edges of the mesh.",
         "Each node counts once, at every step.", "", over_mesh_nodes<solver>},
        {"out-and-in", manual, must_hold, "The bead goes over the free edge and comes back.",
         "Contact ends and begins at the same place.", "", out_and_in},
        {"beyond-the-edge", manual, is_broken,
         "The bead beside the free edge by 4 % and by 6 % of a segment.",
         "Fn is continuous; measured: its jump.", "", beyond_the_edge},
        {"out-of-this-world", manual, must_hold, "The bead rises to 1e10 … 1e300 mm.", "No force, no NaN.",
         "", out_of_this_world<manual>},
        {"out-of-this-world", solver, must_hold, "The bead rises to 1e10 … 1e300 mm.", "No force, no NaN.",
         "", out_of_this_world<solver>},
        {"any-limit", manual, must_hold, "Fn = Ft = 1e-300 … 1e150.", "Finite, within the limit.", "",
         huge_limits},
    };
}

} // namespace drawbead
