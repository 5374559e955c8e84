// Work, what is stored, what is lost and what comes from nowhere, against closed forms.
#include "force/energy_book.h"
#include "force/manual_law.h"
#include "force/solver_law.h"

#include <catch2/catch.hpp>

using namespace drawbead;

namespace {

bool close(double value, double expected, double scale) {
    return std::abs(value - expected) <= 1e-13 * scale;
}

/// A slider of stiffness 1 and limit 0.4 taken along `path`, a hundred steps a leg.
BeadEnergy slider(const std::vector<double>& path) {
    EnergyBook book(1);
    ManualContact<double> at;
    at.normal = {0, 0, 1};
    at.stiffness = 1;
    ManualInput<double> in;
    in.half_chord = {0, -1, 0}; // across the bead is x
    in.tributary = 1;
    double q = 0;
    for (std::size_t leg = 1; leg < path.size(); ++leg)
        for (int i = 0; i < 100; ++i) {
            in.displacement = {(path[leg] - path[leg - 1]) / 100, 0, 0};
            const ManualForce<double> f =
                manual_node_force<double, Effects{Restraint::incremental, false, false}>({0, 0, 0.4, 0, 1},
                                                                                         at, in, q);
            book.step(0, {{}, f.total, q * q / 2}, in.displacement);
        }
    return book.energy();
}

} // namespace

TEST_CASE("a slider stores up to its limit, gives that back, and loses the rest") {
    const BeadEnergy stuck = slider({0, 0.3});
    CHECK(close(stuck.restraint_work, -0.045, 1));
    CHECK(close(stuck.stored, 0.045, 1));
    CHECK(close(stuck.dissipated, 0, 1));
    const BeadEnergy back = slider({0, 0.3, -0.3, 0});
    CHECK(close(back.restraint_work, 0, 1));
    CHECK(close(back.stored, 0, 1));
    const BeadEnergy pulled = slider({0, 1});
    CHECK(close(pulled.stored, 0.08, 1));
    CHECK(close(pulled.dissipated, 0.4 * 0.6, 1));
    const BeadEnergy cycle = slider({0, 1, -1, 0});
    CHECK(close(cycle.restraint_work, -0.88, 1));
    CHECK(close(cycle.dissipated + cycle.stored, 0.88, 1));
    for (const BeadEnergy& e : {stuck, back, pulled, cycle}) {
        CHECK(close(e.created, 0, 1));
        CHECK(e.normal_work == 0);
        CHECK(close(e.restraint_work + e.stored + e.dissipated - e.created, 0, 1));
    }
}

TEST_CASE("the solver's viscous bead loses what it brakes; with a negative limit it creates energy") {
    for (const double limit : {50.0, -50.0}) {
        EnergyBook book(1);
        SegmentState<double> segment;
        segment.x = {{{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {0, 5, 0}}};
        segment.mass.fill(2e-7);
        segment.stiffness = 42000;
        segment.v.fill({2000, 0, 0}); // fast enough for the limit
        NodeInput<double> node;
        node.x = {2, 2, -0.1}; // on the plateau
        node.half_chord = {0, 4, 0};
        NodeState<double> none;
        const Vec3 step{0.01, 0, 0};
        for (int i = 0; i <= 50; ++i) {
            const NodeForce<double> f = solver_node_force<double, Effects{Restraint::viscous, true, false}>(
                {100, 0, limit, 0, 5}, segment, node, none);
            book.step(0, {f.normal, f.tangential, 0}, i == 0 ? Vec3{} : step);
        }
        const BeadEnergy e = book.energy();
        const double work = limit * 4 * 0.5; // over 0.5 mm on a tributary length of 4
        CHECK(close(e.restraint_work, -work, 100));
        CHECK(close(e.dissipated, std::max(work, 0.0), 100));
        CHECK(close(e.created, std::max(-work, 0.0), 100));
        CHECK(e.normal_work == 0);
    }
}

TEST_CASE("the work of a force that grows along the way, summed over nodes") {
    EnergyBook book(2);
    for (int i = 1; i <= 10; ++i)
        for (std::size_t node = 0; node < 2; ++node)
            book.step(node, {{0, 0, -3.0 * i}, {}, 0}, {0, 0, 0.1});
    CHECK(close(book.energy().normal_work, -2 * 0.5 * 30 * 1, 30));
    CHECK(book.energy().restraint_work == 0);
}
