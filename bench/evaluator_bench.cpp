// Cost of one bead node and step under the solver's law: all effects on, the blank moves as one, the search
// follows. Items are node steps; the second argument is how far a step goes, in µm.
#include "contact/bead_contact.h"
#include "force/evaluator.h"

#include <benchmark/benchmark.h>

#include <cmath>

using namespace drawbead;

namespace {

constexpr std::size_t bead_nodes = 1000, step_count = 200;

/// A bead along the middle of a sheet of `segments` shells of 5 mm.
struct Sheet {
    explicit Sheet(std::size_t segments, double speed) {
        // As long as the bead needs it, and as wide as the rest of the segments makes it.
        const auto length = static_cast<uint32_t>(segments < 10000 ? 500 : 1010);
        const auto width = static_cast<uint32_t>(segments / length);
        std::vector<Vec3> x;
        std::vector<uint32_t> id;
        for (uint32_t j = 0; j <= width; ++j)
            for (uint32_t i = 0; i <= length; ++i) {
                x.push_back({5.0 * j, 5.0 * i, 0});
                id.push_back(static_cast<uint32_t>(id.size()) + 1);
            }
        std::vector<SegmentNodes> segment;
        for (uint32_t j = 0; j < width; ++j)
            for (uint32_t i = 0; i < length; ++i) {
                const uint32_t n = j * (length + 1) + i;
                segment.push_back({n, n + length + 1, n + length + 2, n + 1});
            }
        SegmentMesh mesh;
        mesh.segment = segment;
        mesh.x = x;
        mesh.node_id = id;

        EvaluationBead bead;
        bead.law = {100, 200, 50, 80, 5};
        const double hop = 5.0 * (length - 2) / bead_nodes;
        for (std::size_t i = 0; i < bead_nodes; ++i) {
            bead.nodes.push_back(static_cast<int64_t>(10'000'000 + i));
            bead.x.push_back({2.5 * width + 0.3, 5.1 + hop * static_cast<double>(i), 2});
        }
        const BeadInput input{bead.x, bead.law.fn_first, bead.law.depth, 0};
        ContactOptions options;
        options.layer_ratio = 0;
        options.travel = speed * step_count;
        const SegmentStiffness stiffness = of_shell(210000, 1);
        SurfaceContact contact = surface_contact(
            mesh, std::span(&input, 1), [&](uint32_t) { return stiffness; }, stiffness.k, {}, options);
        bead.track = contact.track[0];
        bead.slope = contact.bead[0].slope;
        bead.slope_read.assign(bead_nodes, bead.slope.ramp);
        bead.motion.assign(bead_nodes, 0);
        EvaluationSurface surface;
        surface.mesh = std::move(contact.mesh);
        surface.motion.assign(surface.mesh.x.size(), 1);
        surface.mass.assign(surface.mesh.x.size(), 2e-7);
        surface.stiffness.assign(surface.mesh.segment.size(), stiffness);
        surface.thickness.assign(surface.mesh.segment.size(), 1);
        scene.motions.resize(2);
        scene.motions[0].terms.push_back({true, 2, -0.1 * speed, 1, TimeTable::constant(1)});
        scene.motions[1].terms.push_back({true, 0, speed, 1, TimeTable::constant(1)});
        scene.surfaces.push_back(std::move(surface));
        scene.beads.push_back(std::move(bead));
        for (std::size_t n = 0; n < step_count; ++n) {
            scene.time.push_back(static_cast<double>(n));
            scene.dt.push_back(n > 0 ? 1 : 0);
        }
        for (const Motion& motion : scene.motions)
            steps.push_back(integrate(motion, scene.time, scene.dt));
    }

    EvaluationScene scene;
    std::vector<MotionSteps> steps;
};

void run_steps(benchmark::State& state, Law law, EffectSet stages) {
    const Sheet sheet(static_cast<std::size_t>(state.range(0)), 1e-3 * static_cast<double>(state.range(1)));
    for (auto _ : state) {
        state.PauseTiming();
        const auto run = make_run(sheet.scene, sheet.steps, 0, law, stages);
        state.ResumeTiming();
        run->advance(0, step_count);
        if (run->at_rim()) state.SkipWithError("came to the rim of the mesh");
        benchmark::DoNotOptimize(run->history().impulse);
    }
    state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * bead_nodes * step_count));
}

/// Everything that such a scene can ask for; the blank does not deform.
EffectSet full() {
    return EffectSet::all().remove(Effect::deforming_blank);
}

void solver_full(benchmark::State& state) {
    run_steps(state, Law::solver, full());
}
void solver_deforming(benchmark::State& state) {
    run_steps(state, Law::solver, EffectSet::all());
}
void solver_out_of_reach(benchmark::State& state) {
    run_steps(state, Law::solver, full().remove(Effect::search));
}
void manual_full(benchmark::State& state) {
    run_steps(state, Law::manual, full());
}

BENCHMARK(solver_full)->ArgsProduct({{1000, 100'000, 2'000'000}, {1, 20, 500}});
BENCHMARK(solver_deforming)->Args({100'000, 20});
BENCHMARK(solver_out_of_reach)->Args({100'000, 20});
BENCHMARK(manual_full)->Args({100'000, 20});

} // namespace
