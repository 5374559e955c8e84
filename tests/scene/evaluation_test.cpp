// The motion of the deck under the solver's law, at the recorded times: every recorded row comes out, with
// its segment and its forces.
#include "force/evaluator.h"
#include "force/trace.h"
#include "force/trace_times.h"
#include "scene/deck_evaluation.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <random>

using namespace drawbead;
using C = TraceColumn;

namespace {

/// A scene of tests/truth with its recorded times.
struct Recorded {
    std::unique_ptr<Deck> deck;
    Model model;
    Trace trace;
    DeckEvaluation evaluation;
    std::vector<MotionSteps> steps;
};

std::string folder_of(const std::string& name) {
    return DRAWBEAD_TESTS_DIR "/truth/" + name + "/";
}

std::vector<std::string> recorded_scenes() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(DRAWBEAD_TESTS_DIR "/truth"))
        if (std::filesystem::exists(entry.path() / "trace.csv.gz"))
            names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

Recorded read(const std::string& name) {
    Recorded r;
    DiskReader reader;
    auto deck = Deck::read(folder_of(name) + name + "_0000.rad", reader);
    REQUIRE(deck);
    r.deck = std::make_unique<Deck>(std::move(*deck));
    r.model = Model::build(*r.deck, needs_evaluation, 1);
    auto trace = read_trace(folder_of(name) + "trace.csv.gz");
    REQUIRE(trace);
    r.trace = std::move(*trace);
    const TraceTimes times = times_of(r.trace);
    EvaluationRequest request;
    request.time = times.time;
    request.dt = times.dt;
    auto evaluation = evaluation_of(r.model, request);
    REQUIRE(evaluation);
    r.evaluation = std::move(*evaluation);
    REQUIRE(r.evaluation.left_out.empty());
    const EvaluationScene& scene = r.evaluation.scene;
    for (const Motion& motion : scene.motions)
        r.steps.push_back(integrate(motion, scene.time, scene.dt));
    return r;
}

std::unique_ptr<BeadRun> run(const Recorded& r, std::size_t bead, Law law, EffectSet stages) {
    auto one = make_run(r.evaluation.scene, r.steps, bead, law, stages);
    one->keep_samples(1);
    one->advance(0, r.evaluation.scene.time.size());
    one->finish();
    REQUIRE_FALSE(one->at_rim());
    return one;
}

double number(const TraceRow& row, C column, std::size_t offset = 0) {
    return row.value[static_cast<std::size_t>(column) + offset];
}

} // namespace

TEST_CASE("evaluation: every recorded row under the solver's law") {
    for (const std::string& name : recorded_scenes()) {
        // Adaptive meshing made the segments that this run met.
        if (name == "l2_admesh_idt0") continue;
        INFO(name);
        const Recorded r = read(name);
        const EvaluationScene& scene = r.evaluation.scene;
        double scale = 0;
        for (const TraceRow& row : r.trace.rows)
            for (std::size_t k = 0; k < 3; ++k)
                scale = std::max({scale, std::abs(number(row, C::fnx, k)), std::abs(number(row, C::ftx, k))});
        std::size_t compared = 0, same = 0;
        double largest = 0;
        for (std::size_t b = 0; b < scene.beads.size(); ++b) {
            PlanOptions options;
            options.node_output = true;
            const BeadPlan planned = plan(scene, r.steps, b, Law::solver, options);
            const auto one = run(r, b, Law::solver, planned.needed());
            const auto samples = one->take_samples();
            const NearMesh& mesh = scene.surfaces[scene.beads[b].surface].mesh;
            for (const TraceRow& row : r.trace.rows) {
                if (row.integer(C::nin) != r.evaluation.rank[b]) continue;
                const auto& sampled = samples.at(static_cast<std::size_t>(row.integer(C::ncycle)));
                REQUIRE(sampled.step == static_cast<std::size_t>(row.integer(C::ncycle)));
                const NodeSample& ours = sampled.nodes.at(static_cast<std::size_t>(row.integer(C::inod) - 1));
                ++compared;
                bool equal = ours.found;
                for (std::size_t k = 0; k < 4 && equal; ++k)
                    equal = mesh.node_id[mesh.segment[ours.segment][k]] == number(row, C::seg_n1, k);
                same += equal;
                const Vec3 normal{row[C::fnx], row[C::fny], row[C::fnz]},
                    restraint{row[C::ftx], row[C::fty], row[C::ftz]};
                // Slopes past the end of the solver's table are not the deck's.
                const auto i = static_cast<std::size_t>(row.integer(C::inod) - 1);
                if (!scene.beads[b].slope_read[i]) continue;
                largest = std::max({largest, norm(ours.normal - normal), norm(ours.restraint - restraint)});
            }
        }
        CHECK(compared == r.trace.rows.size());
        CHECK(same == compared);
        CHECK(largest <= 1e-9 * scale);
    }
}

TEST_CASE("evaluation: what the plan leaves out changes no bit") {
    std::mt19937 random(7);
    for (const std::string& name : recorded_scenes()) {
        INFO(name);
        const Recorded r = read(name);
        const EvaluationScene& scene = r.evaluation.scene;
        for (std::size_t b = 0; b < scene.beads.size(); ++b)
            for (const Law law : {Law::solver, Law::manual}) {
                const BeadPlan planned = plan(scene, r.steps, b, law, {});
                const auto few = run(r, b, law, planned.needed());
                for (std::size_t i = 0; i < effect_count; ++i)
                    if (planned.effect[i].verdict == Verdict::off) CHECK(few->counts()[i] == 0);
                for (int trial = 0; trial < 4; ++trial) {
                    EffectSet forced = EffectSet::all();
                    for (std::size_t i = 0; i < effect_count && trial > 0; ++i)
                        if (random() % 2) forced.remove(static_cast<Effect>(i));
                    const auto more = run(r, b, law, planned.needed() | forced);
                    CHECK_FALSE(first_difference(few->history(), more->history()));
                }
            }
    }
}

TEST_CASE("evaluation: no effect is idle: leaving out a needed one shows somewhere") {
    // Of the solver's law, where every stage can be seen.
    EffectSet seen;
    for (const std::string& name : recorded_scenes()) {
        const Recorded r = read(name);
        const EvaluationScene& scene = r.evaluation.scene;
        for (std::size_t b = 0; b < scene.beads.size(); ++b) {
            const EffectSet needed = plan(scene, r.steps, b, Law::solver, {}).needed();
            const auto whole = run(r, b, Law::solver, needed);
            for (std::size_t i = 0; i < effect_count; ++i) {
                const auto e = static_cast<Effect>(i);
                if (!needed.has(e) || seen.has(e)) continue;
                const auto less = run(r, b, Law::solver, EffectSet(needed).remove(e));
                if (first_difference(whole->history(), less->history())) seen.add(e);
            }
        }
    }
    for (const Effect e : {Effect::window, Effect::search, Effect::normal, Effect::ramp, Effect::thickness,
                           Effect::reset, Effect::ft_ramp, Effect::variation, Effect::viscous,
                           Effect::incremental, Effect::moving, Effect::energy}) {
        INFO(name(e));
        CHECK(seen.has(e));
    }
}
