#include "cli/evaluation_input.h"

#include "base/nearest.h"
#include "cli/commands.h"
#include "cli/reading.h"
#include "cli/scene_file.h"
#include "cli/scene_times.h"

#include "base/parallel.h"
#include "deck/engine_deck.h"
#include "force/evaluator.h"
#include "report/evaluation.h"
#include "rules/text.h"
#include "scene/holding_force.h"
#include "study/stepped_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <unistd.h>

namespace drawbead {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

bool is_scene_file(const std::string& path) {
    const auto ends = [&](std::string_view ending) {
        return path.size() > ending.size() &&
               path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
    };
    return ends(".yaml") || ends(".yml");
}

namespace {

/// The scene of a command line that names a deck.
Scene scene_of_deck(const EvaluateCommand& command) {
    Scene scene;
    scene.deck = command.path;
    scene.time.trace = command.trace;
    if (!command.trace.empty()) return scene;
    scene.time.end = command.end;
    if (!scene.time.end) {
        DiskReader disk;
        if (const auto engine = read_engine_deck(command.path, disk)) scene.time.end = engine->end;
    }
    scene.time.step = command.step;
    scene.time.steps = command.steps;
    if (!scene.time.step && !scene.time.steps) scene.time.steps = 1000;
    return scene;
}

} // namespace

namespace {

const char* name_of(MotionTarget::Kind kind) {
    switch (kind) {
    case MotionTarget::Kind::surface:
        return "surface";
    case MotionTarget::Kind::part:
        return "part";
    case MotionTarget::Kind::node_group:
        return "node group";
    case MotionTarget::Kind::bead:
        return "bead";
    case MotionTarget::Kind::main_surface:
        break;
    }
    return "main surface of bead";
}

} // namespace

Result<Loaded> load_scene(const EvaluateCommand& command) {
    Loaded out;
    if (is_scene_file(command.path) &&
        (command.end || command.step || command.steps || !command.trace.empty()))
        return Error{"--end, --step, --steps and --trace are for decks, and this is a scene", command.path, 0,
                     0, "write them under time: in the scene"};
    out.threads = thread_count(command.reading);
    Result<Scene> scene =
        is_scene_file(command.path) ? read_scene(command.path) : Result<Scene>(scene_of_deck(command));
    if (!scene) return scene.error();
    out.scene = std::move(*scene);
    Scene& s = out.scene;
    if (command.law) {
        s.solver = *command.law != "manual";
        s.manual = *command.law != "solver";
    }
    if (!command.csv.empty()) s.output.csv = command.csv;
    if (!command.vtu.empty()) s.output.vtu = command.vtu;
    if (command.every) s.output.every = *command.every;

    const Result<DeckSource> source = deck_source(s.deck, command.reading);
    if (!source) return source.error();
    Result<Deck> deck = Deck::read(source->name, *source->reader, read_options(command.reading, out.threads));
    if (!deck) {
        Error error = deck.error();
        if (error.path.empty()) error.path = source->name;
        return error;
    }
    out.deck = std::make_unique<Deck>(std::move(*deck));
    if (s.time.trace.empty() && !s.time.end)
        return Error{"the end of the run is not known", s.deck, 0, 0,
                     "please give --end, --trace or a scene"};
    if (s.deck_motion) {
        out.model = Model::build(*out.deck, needs_evaluation, out.threads);
    } else {
        out.model = Model::build(*out.deck, needs_evaluation, out.threads, targets_of(s));
        for (std::size_t i = 0; i < s.moves.size() && !out.model.motion().classes.empty(); ++i) {
            const auto& held = out.model.motion().target_nodes[i];
            const ScenePlace& at = s.moves[i].place;
            const std::string id = std::to_string(s.moves[i].target.id);
            if (!held)
                return Error{std::string(name_of(s.moves[i].target.kind)) + " " + id +
                                 " does not exist in the deck",
                             s.path, at.line, at.column, "correct the id, or leave the move out"};
            if (*held == 0)
                out.notes.push_back("line " + std::to_string(at.line) + " of the scene: " + id +
                                    " holds no node of a drawbead or of a main surface");
        }
    }

    Result<SceneTimes> times = times_of(s);
    if (!times) return times.error();
    out.time = std::move(times->time);
    out.dt = std::move(times->dt);
    if (!times->note.empty()) out.notes.push_back(times->note);
    return out;
}

namespace {

/// Whether the deck has the interfaces and bead nodes that the scene names.
Result<void> ids_exist(const Loaded& loaded) {
    const Scene& s = loaded.scene;
    const std::vector<Drawbead>& beads = loaded.model.drawbeads();
    std::string known;
    for (const Drawbead& bead : beads)
        known += (known.empty() ? "" : ", ") + std::to_string(bead.id);
    for (const int64_t id : s.interfaces)
        if (std::none_of(beads.begin(), beads.end(), [&](const Drawbead& b) { return b.id == id; }))
            return Error{"no /INTER/TYPE8 with id " + std::to_string(id), s.path, s.interfaces_place.line,
                         s.interfaces_place.column, "the deck has " + known};
    for (const int64_t id : s.output.nodes) {
        const auto has = [&](const Drawbead& bead) {
            if (!bead.group) return false;
            const std::vector<NodeRow>& rows = loaded.model.groups()[*bead.group].nodes;
            return std::any_of(rows.begin(), rows.end(),
                               [&](NodeRow row) { return value(loaded.model.nodes().user_id(row)) == id; });
        };
        if (std::none_of(beads.begin(), beads.end(), has))
            return Error{"node " + std::to_string(id) + " is no node of a bead", s.path,
                         s.output.nodes_place.line, s.output.nodes_place.column,
                         "name nodes of the lists of the beads, or leave nodes out: all are written then"};
    }
    return {};
}

} // namespace

Result<Prepared> prepare_scene(const Loaded& loaded, double travel) {
    Prepared out;
    EvaluationRequest request;
    request.interfaces = loaded.scene.interfaces;
    request.prescribed = prescribed_by(loaded.scene);
    request.time = loaded.time;
    request.dt = loaded.dt;
    request.threads = loaded.threads;
    request.travel = travel;
    if (auto known = ids_exist(loaded); !known) return known.error();
    Result<DeckEvaluation> evaluation = evaluation_of(loaded.model, request);
    if (!evaluation) return evaluation.error();
    out.evaluation = std::move(*evaluation);
    const EvaluationScene& scene = out.evaluation.scene;
    if (scene.beads.empty()) {
        const LeftOut& first = out.evaluation.left_out.front();
        return Error{"interface " + std::to_string(first.id) + " cannot be evaluated: " + first.why,
                     loaded.scene.path.empty() ? loaded.scene.deck : loaded.scene.path, 0, 0,
                     loaded.scene.deck_motion ? "give a scene that lists under motion: how things move" : ""};
    }
    for (const Motion& motion : scene.motions)
        out.steps.push_back(integrate(motion, scene.time, scene.dt));
    if (loaded.scene.solver) out.laws.push_back(Law::solver);
    if (loaded.scene.manual) out.laws.push_back(Law::manual);
    if (loaded.scene.manual && loaded.scene.accuracy) {
        out.stepped = scene;
        set_steps(*out.stepped, scene.time.front(), scene.time.back(), loaded.scene.accuracy->steps);
    }
    const UnitSystem& units = loaded.deck->work_units();
    PlanOptions options;
    options.node_output = !loaded.scene.output.csv.empty() || !loaded.scene.output.vtu.empty();
    options.units = {unit_name(units, length_dimension), unit_name(units, time_dimension),
                     unit_name(units, force_per_length_dimension)};
    for (const Law law : out.laws) {
        out.plans.emplace_back();
        for (std::size_t b = 0; b < scene.beads.size(); ++b)
            out.plans.back().push_back(plan(scene, out.steps, b, law, options));
    }
    return out;
}

double next_travel(const DeckEvaluation& evaluation) {
    double size = 0;
    for (const EvaluationSurface& surface : evaluation.scene.surfaces)
        size = std::max(size, surface.mesh.reach);
    const double travel = evaluation.travel;
    return travel + size < 1e3 * size ? 2 * (travel + size) : infinity;
}

namespace {

std::array<double, 3> components(Vec3 v) {
    return {v.x, v.y, v.z};
}

/// Files of samples, filled in order of steps.
class SampleFiles {
public:
    SampleFiles(const Loaded& loaded, const Prepared& prepared) : loaded_(loaded), prepared_(prepared) {}

    Result<void> open() {
        if (loaded_.scene.output.csv.empty()) return {};
        Result<std::unique_ptr<FileSink>> file = FileSink::replace(loaded_.scene.output.csv);
        if (!file) return file.error();
        csv_ = std::move(*file);
        write_samples_header(*csv_);
        return {};
    }

    /// What the runs of one law took since the last call, by bead.
    Result<void> take(Law law, std::vector<std::vector<BeadRun::Sampled>> beads) {
        if (beads.empty()) return {};
        for (std::size_t k = 0; k < beads.front().size(); ++k) {
            std::vector<SampledBead> step;
            for (std::size_t b = 0; b < beads.size(); ++b)
                step.push_back(resolve(law, b, beads[b][k]));
            if (csv_)
                for (const SampledBead& bead : step)
                    write_samples(*csv_, bead);
            if (!loaded_.scene.output.vtu.empty())
                if (auto written = write_step(law, step); !written) return written;
        }
        return {};
    }

    Result<void> finish() {
        if (csv_)
            if (auto done = csv_->finish(); !done) return done;
        for (const auto& [law, steps] : series_) {
            Result<std::unique_ptr<FileSink>> file =
                FileSink::replace(loaded_.scene.output.vtu + "_" + std::string(name(law)) + ".pvd");
            if (!file) return file.error();
            write_pvd(**file, steps);
            if (auto done = (*file)->finish(); !done) return done;
        }
        return {};
    }

private:
    SampledBead resolve(Law law, std::size_t b, const BeadRun::Sampled& sampled) const {
        const EvaluationScene& scene = prepared_.scene_of(law);
        const EvaluationBead& bead = scene.beads[b];
        const NearMesh& mesh = scene.surfaces[bead.surface].mesh;
        const std::vector<int64_t>& only = loaded_.scene.output.nodes;
        SampledBead out;
        out.law = name(law);
        out.step = sampled.step;
        out.time = scene.time[sampled.step];
        out.rank = static_cast<uint64_t>(prepared_.evaluation.rank[b]);
        out.interface_id = bead.id;
        for (const NodeSample& node : sampled.nodes) {
            const int64_t id = bead.nodes[node.node];
            if (!only.empty() && std::find(only.begin(), only.end(), id) == only.end()) continue;
            SampledNode one;
            one.id = id;
            one.place = node.node + 1;
            one.found = node.found;
            for (std::size_t k = 0; k < 4 && node.found; ++k)
                one.segment[k] = mesh.node_id[mesh.segment[node.segment][k]];
            one.inside = node.inside;
            one.xi = node.xi;
            one.eta = node.eta;
            one.distance = node.distance;
            one.penetration = node.penetration;
            one.x = components(node.x);
            one.normal = components(node.normal);
            one.restraint = components(node.restraint);
            out.nodes.push_back(one);
        }
        return out;
    }

    Result<void> write_step(Law law, const std::vector<SampledBead>& step) {
        char number[24];
        std::snprintf(number, sizeof number, "%06llu", static_cast<unsigned long long>(step.front().step));
        const std::string path =
            loaded_.scene.output.vtu + "_" + std::string(name(law)) + "_" + number + ".vtu";
        Result<std::unique_ptr<FileSink>> file = FileSink::replace(path);
        if (!file) return file.error();
        write_vtu(**file, step);
        series_[law].push_back({step.front().time, path.substr(path.rfind('/') + 1)});
        return (*file)->finish();
    }

    const Loaded& loaded_;
    const Prepared& prepared_;
    std::unique_ptr<FileSink> csv_;
    std::map<Law, std::vector<VtuStep>> series_;
};

/// Runs of all beads under all laws.
struct Runs {
    std::vector<std::vector<std::unique_ptr<BeadRun>>> of_law; ///< [law][bead]
    std::vector<std::vector<double>> seconds;                  ///< that their steps took, likewise

    bool at_rim() const {
        for (const auto& runs : of_law)
            for (const auto& run : runs)
                if (run->at_rim()) return true;
        return false;
    }
};

Runs make_runs(const Loaded& loaded, const Prepared& prepared, EffectSet forced) {
    Runs runs;
    for (std::size_t l = 0; l < prepared.laws.size(); ++l) {
        runs.of_law.emplace_back();
        const Law law = prepared.laws[l];
        const EvaluationScene& scene = prepared.scene_of(law);
        runs.seconds.emplace_back(scene.beads.size(), 0.0);
        for (std::size_t b = 0; b < scene.beads.size(); ++b) {
            if (law == Law::manual && prepared.stepped)
                runs.of_law.back().push_back(make_stepped_run(scene, b, *loaded.scene.accuracy));
            else
                runs.of_law.back().push_back(
                    make_run(scene, prepared.steps, b, law, prepared.plans[l][b].needed() | forced));
        }
    }
    return runs;
}

/// All steps, in blocks that are written out as they are done.
Result<void> advance(const Loaded& loaded, const Prepared& prepared, Runs& runs, SampleFiles* files,
                     bool progress) {
    const EvaluationScene& scene = prepared.evaluation.scene;
    std::size_t nodes = 0;
    for (const EvaluationBead& bead : scene.beads)
        nodes += bead.x.size() * prepared.laws.size();
    const std::size_t every = loaded.scene.output.every;
    if (files)
        for (auto& of_law : runs.of_law)
            for (auto& run : of_law)
                run->keep_samples(every);
    std::size_t count = 0;
    for (const Law law : prepared.laws)
        count = std::max(count, prepared.scene_of(law).time.size());
    const std::size_t beads = scene.beads.size();
    std::size_t block = std::max<std::size_t>(1, 2'000'000 / std::max<std::size_t>(nodes, 1));
    if (files) block = std::max<std::size_t>(1, 100'000 / std::max<std::size_t>(nodes, 1)) * every;
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    Progress bar(progress, count);
    for (std::size_t begin = 0; begin < count; begin += block) {
        const std::size_t end = std::min(begin + block, count);
        parallel_for(loaded.threads, beads * prepared.laws.size(), [&](std::size_t piece) {
            const std::size_t own = prepared.scene_of(prepared.laws[piece / beads]).time.size();
            const auto began = Clock::now();
            runs.of_law[piece / beads][piece % beads]->advance(std::min(begin, own), std::min(end, own));
            runs.seconds[piece / beads][piece % beads] +=
                std::chrono::duration<double>(Clock::now() - began).count();
        });
        if (runs.at_rim()) return {};
        if (files)
            for (std::size_t l = 0; l < prepared.laws.size(); ++l) {
                std::vector<std::vector<BeadRun::Sampled>> sampled;
                for (auto& run : runs.of_law[l])
                    sampled.push_back(run->take_samples());
                if (auto taken = files->take(prepared.laws[l], std::move(sampled)); !taken) return taken;
            }
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        const double done = static_cast<double>(end), rate = seconds > 0 ? done / seconds : 0;
        bar.show(end, number(rate, 3) + " steps/s, " +
                          number(rate > 0 ? (static_cast<double>(count) - done) / rate : 0, 2) + " s left");
    }
    for (auto& of_law : runs.of_law)
        for (auto& run : of_law)
            run->finish();
    return {};
}

/// How long the steps took, by law.
void say_times(const Prepared& prepared, const Runs& runs) {
    for (std::size_t l = 0; l < prepared.laws.size(); ++l) {
        const EvaluationScene& scene = prepared.scene_of(prepared.laws[l]);
        double count = 0, seconds = 0;
        for (std::size_t b = 0; b < scene.beads.size(); ++b) {
            count += static_cast<double>(scene.beads[b].x.size() * scene.time.size());
            seconds += runs.seconds[l][b];
        }
        say("law " + std::string(name(prepared.laws[l])) + ": " + number(count, 12) +
            " steps of bead nodes in " + number(seconds, 3) + " s, " +
            number(count > 0 ? 1e9 * seconds / count : 0, 3) + " ns each");
    }
}

/// Magnitudes far from what forming knows can leave the range of numbers; what is not a number is no result.
Result<void> all_finite(const Loaded& loaded, const Prepared& prepared, const Runs& runs) {
    const EvaluationScene& scene = prepared.evaluation.scene;
    for (std::size_t l = 0; l < prepared.laws.size(); ++l)
        for (std::size_t b = 0; b < scene.beads.size(); ++b) {
            const auto step = first_not_finite(runs.of_law[l][b]->history());
            if (!step) continue;
            const std::string when =
                *step < scene.time.size() ? " at t = " + number(scene.time[*step], 6) : " in the energies";
            return Error{"interface " + std::to_string(scene.beads[b].id) + ", law " +
                             std::string(name(prepared.laws[l])) + ": numbers leave the range of a double" +
                             when,
                         loaded.scene.path.empty() ? loaded.scene.deck : loaded.scene.path, 0, 0,
                         "look for a limit, stiffness, mass or motion that is far too large"};
        }
    return {};
}

/// The largest value and the earliest time that comes within rounding of it.
template <class Value>
Peak peak_of(const EvaluationScene& scene, const Value& value) {
    Peak peak;
    for (std::size_t n = 0; n < scene.time.size(); ++n)
        peak.value = std::max(peak.value, value(n));
    for (std::size_t n = 0; n < scene.time.size(); ++n)
        if (value(n) >= peak.value * (1 - 1e-12)) {
            peak.time = scene.time[n];
            break;
        }
    return peak;
}

EvaluatedLaw totals_of(const EvaluationScene& scene, std::size_t b, const BeadHistory& h) {
    EvaluatedLaw out;
    const auto& steps = h.steps;
    out.force = peak_of(scene, [&](std::size_t n) { return norm(steps[n].total()); });
    const auto at = static_cast<std::size_t>(std::find(scene.time.begin(), scene.time.end(), out.force.time) -
                                             scene.time.begin());
    out.force_vector = components(steps[at].total());
    out.couple = components(steps[at].couple);
    out.couple_norm = peak_of(scene, [&](std::size_t n) { return norm(steps[n].couple); });
    out.normal = peak_of(scene, [&](std::size_t n) { return norm(steps[n].normal); });
    out.restraint = peak_of(scene, [&](std::size_t n) { return norm(steps[n].restraint); });
    out.normal_sum = peak_of(scene, [&](std::size_t n) { return steps[n].normal_sum; });
    out.restraint_sum = peak_of(scene, [&](std::size_t n) { return steps[n].restraint_sum; });
    out.impulse = components(h.impulse);
    out.normal_work = h.energy.normal_work;
    out.restraint_work = h.energy.restraint_work;
    out.tool_work = h.energy.tool_work;
    out.stored = h.energy.stored;
    out.dissipated = h.energy.dissipated;
    out.created = h.energy.created;
    out.first_contact = h.first_contact;
    out.first_plateau = h.first_plateau;
    out.first_slip = h.first_slip;
    for (const StepTotals& step : steps) {
        out.in_contact = std::max<uint64_t>(out.in_contact, step.in_contact);
        out.on_plateau = std::max<uint64_t>(out.on_plateau, step.on_plateau);
    }
    out.ever_in_contact = h.ever_in_contact;
    out.normal_capacity = h.normal_capacity;
    out.restraint_capacity = h.restraint_capacity;
    out.worst_node = scene.beads[b].nodes[h.worst_node];
    out.worst = {h.worst_restraint, h.worst_time};
    return out;
}

std::vector<PlannedEffect> effects_of(const BeadPlan& plan, EffectSet forced, const EffectCounts* counts) {
    std::vector<PlannedEffect> out;
    for (std::size_t i = 0; i < effect_count; ++i) {
        const auto e = static_cast<Effect>(i);
        PlannedEffect one;
        one.name = name(e);
        one.what = what(e);
        one.verdict = name(plan[e].verdict);
        one.reason = plan[e].reason;
        one.forced = plan[e].verdict == Verdict::off && forced.has(e);
        one.estimated = plan[e].estimated;
        if (counts) one.actual = (*counts)[i];
        out.push_back(std::move(one));
    }
    return out;
}

LawDifference apart(const EvaluationScene& scene, const BeadHistory& solver, const BeadHistory& manual,
                    Vec3 StepTotals::*what) {
    LawDifference d;
    double of_solver = 0;
    for (std::size_t n = 0; n < scene.time.size(); ++n) {
        const Vec3 s = solver.steps[n].*what, m = manual.steps[n].*what;
        d.mean += norm(s - m);
        d.scale = std::max(d.scale, norm(m));
        of_solver = std::max(of_solver, norm(s));
    }
    if (d.scale == 0) d.scale = of_solver;
    d.mean /= static_cast<double>(scene.time.size());
    d.largest =
        peak_of(scene, [&](std::size_t n) { return norm(solver.steps[n].*what - manual.steps[n].*what); });
    return d;
}

/// What the manual's law cost under the scene's settings.
std::string cost_of(const Loaded& loaded, const Prepared& prepared, const Runs& runs) {
    StudyCounts cost;
    for (std::size_t l = 0; l < prepared.laws.size(); ++l)
        for (const auto& run : runs.of_law[l])
            if (const auto* stepped = dynamic_cast<const SteppedRun*>(run.get())) cost += stepped->cost();
    std::string out = "the manual's law as accuracy: " + yaml(*loaded.scene.accuracy) +
                      " says: " + std::to_string(cost.evaluations) + " evaluations";
    if (prepared.laws.size() == 2 && prepared.stepped->time != prepared.evaluation.scene.time)
        out += "; the solver's at the steps of time:, so that the laws are not compared";
    return out;
}

EvaluationReport report_of(const Loaded& loaded, const Prepared& prepared, EffectSet forced,
                           const Runs* runs) {
    const EvaluationScene& scene = prepared.evaluation.scene;
    const UnitSystem& units = loaded.deck->work_units();
    EvaluationReport out;
    out.deck = loaded.scene.deck;
    out.scene = loaded.scene.path;
    out.force_unit = unit_name(units, force_dimension);
    out.length_unit = unit_name(units, length_dimension);
    out.time_unit = unit_name(units, time_dimension);
    const auto product = [](const std::string& a, const std::string& b) {
        return a.empty() || b.empty() ? std::string() : a + ' ' + b;
    };
    out.energy_unit = product(out.force_unit, out.length_unit);
    out.impulse_unit = product(out.force_unit, out.time_unit);
    out.steps = scene.time.size() - 1;
    out.begin = scene.time.front();
    out.end = scene.time.back();
    for (std::size_t b = 0; b < scene.beads.size(); ++b) {
        EvaluatedBead bead;
        bead.id = scene.beads[b].id;
        bead.title = scene.beads[b].title;
        bead.iform = scene.beads[b].iform;
        bead.nodes = scene.beads[b].nodes.size();
        bead.tool = prepared.evaluation.tool[b];
        for (std::size_t l = 0; l < prepared.laws.size(); ++l) {
            const BeadRun* run = runs ? runs->of_law[l][b].get() : nullptr;
            EvaluatedLaw law =
                run ? totals_of(prepared.scene_of(prepared.laws[l]), b, run->history()) : EvaluatedLaw{};
            law.law = name(prepared.laws[l]);
            // Under settings everything is computed.
            if (!runs || prepared.laws[l] != Law::manual || !prepared.stepped)
                law.effects = effects_of(prepared.plans[l][b], forced, run ? &run->counts() : nullptr);
            bead.laws.push_back(std::move(law));
        }
        if (runs && prepared.laws.size() == 2 &&
            (!prepared.stepped || prepared.stepped->time == scene.time)) {
            const BeadHistory &solver = runs->of_law[0][b]->history(),
                              &manual = runs->of_law[1][b]->history();
            bead.restraint_difference = apart(scene, solver, manual, &StepTotals::restraint);
            bead.normal_difference = apart(scene, solver, manual, &StepTotals::normal);
        }
        out.beads.push_back(std::move(bead));
    }
    if (runs) {
        std::map<std::optional<int64_t>, std::vector<std::size_t>> tools;
        for (std::size_t b = 0; b < scene.beads.size(); ++b)
            tools[prepared.evaluation.tool[b]].push_back(b);
        for (const auto& [id, beads] : tools) {
            EvaluatedTool tool;
            tool.id = id;
            const auto held = id ? holding_force(loaded.model, *id) : std::nullopt;
            if (held && !held->unknown.empty()) out.notes.push_back(held->unknown);
            for (const std::size_t b : beads)
                tool.interfaces.push_back(scene.beads[b].id);
            for (std::size_t l = 0; l < prepared.laws.size(); ++l) {
                const EvaluationScene& own = prepared.scene_of(prepared.laws[l]);
                const auto sum = [&](std::size_t n, Vec3 StepTotals::*part) {
                    Vec3 total;
                    for (const std::size_t b : beads)
                        total += runs->of_law[l][b]->history().steps[n].*part;
                    return total;
                };
                EvaluatedTool::Sum one;
                one.law = name(prepared.laws[l]);
                one.normal = peak_of(own, [&](std::size_t n) { return norm(sum(n, &StepTotals::normal)); });
                one.restraint =
                    peak_of(own, [&](std::size_t n) { return norm(sum(n, &StepTotals::restraint)); });
                const auto at = std::find(own.time.begin(), own.time.end(), one.normal.time);
                const Vec3 normal = sum(static_cast<std::size_t>(at - own.time.begin()), &StepTotals::normal);
                one.normal_vector = components(normal);
                // The tool is pushed the other way, and a force that holds it goes with that on the blank.
                if (held && held->unknown.empty() && one.normal.value > 0)
                    one.holding = dot(held->at(one.normal.time), normal) / one.normal.value;
                tool.sums.push_back(std::move(one));
            }
            out.tools.push_back(std::move(tool));
        }
    }
    for (const LeftOut& left : prepared.evaluation.left_out)
        out.left_out.emplace_back(left.id, left.why);
    out.notes.insert(out.notes.begin(), loaded.notes.begin(), loaded.notes.end());
    if (runs && prepared.stepped) out.notes.push_back(cost_of(loaded, prepared, *runs));
    out.notes.insert(out.notes.end(), prepared.evaluation.notes.begin(), prepared.evaluation.notes.end());
    return out;
}

/// The effects that were left out although they change the outcome of one bead.
std::string culprits(const Prepared& prepared, std::size_t l, std::size_t b, const BeadHistory& planned) {
    const EvaluationScene& scene = prepared.evaluation.scene;
    const EffectSet needed = prepared.plans[l][b].needed();
    std::string out;
    for (std::size_t i = 0; i < effect_count; ++i) {
        const auto e = static_cast<Effect>(i);
        if (needed.has(e)) continue;
        const auto run = make_run(scene, prepared.steps, b, prepared.laws[l], EffectSet(needed).add(e));
        run->advance(0, scene.time.size());
        run->finish();
        if (first_difference(planned, run->history()))
            out += (out.empty() ? "" : ", ") + std::string(name(e));
    }
    return out.empty() ? "several together" : out;
}

/// Runs everything with all effects too and compares; what it found as text, and whether all is equal.
bool prove(const Loaded& loaded, const Prepared& prepared, const Runs& planned, std::string& text) {
    Runs all = make_runs(loaded, prepared, EffectSet::all());
    if (auto done = advance(loaded, prepared, all, nullptr, false); !done) return false;
    const EvaluationScene& scene = prepared.evaluation.scene;
    bool equal = true;
    for (std::size_t l = 0; l < prepared.laws.size(); ++l)
        for (std::size_t b = 0; b < scene.beads.size(); ++b) {
            const BeadRun &few = *planned.of_law[l][b], &full = *all.of_law[l][b];
            const std::string head = "interface " + std::to_string(scene.beads[b].id) + ", law " +
                                     std::string(name(prepared.laws[l]));
            const auto step = first_difference(few.history(), full.history());
            text += head + (step ? ": DIFFERENT" : ": the same bits with all effects") + '\n';
            for (std::size_t i = 0; i < effect_count; ++i)
                if (few.counts()[i] != full.counts()[i])
                    text += "  " + std::string(name(static_cast<Effect>(i))) + ": " +
                            std::to_string(few.counts()[i]) + " planned, " +
                            std::to_string(full.counts()[i]) + " with all\n";
            if (!step) continue;
            equal = false;
            const std::size_t last = std::min(*step, scene.time.size() - 1);
            text += "  left out though needed: " + culprits(prepared, l, b, few.history()) +
                    "\n  the smallest scene that shows it:\n    deck: " + loaded.scene.deck +
                    "\n    interfaces: [" + std::to_string(scene.beads[b].id) +
                    "]\n    law: " + std::string(name(prepared.laws[l])) + "\n    time: " +
                    (loaded.scene.time.trace.empty()
                         ? "{end: " + number(scene.time[std::max<std::size_t>(last, 1)], 17) +
                               ", steps: " + std::to_string(std::max<std::size_t>(last, 1)) + "}"
                         : "{trace: " + loaded.scene.time.trace + "}") +
                    "\n    motion: " +
                    (loaded.scene.deck_motion ? std::string("deck") : "as in " + loaded.scene.path) + '\n';
        }
    return equal;
}

Result<EffectSet> forced_effects(const std::vector<std::string>& names) {
    EffectSet set;
    std::vector<std::string> known{"all"};
    for (std::size_t i = 0; i < effect_count; ++i)
        known.emplace_back(name(static_cast<Effect>(i)));
    for (const std::string& one : names) {
        const auto at = std::find(known.begin(), known.end(), one);
        if (at == known.end()) {
            std::string help = did_you_mean(one, known);
            if (help.empty()) help = "'drawbead plan' names them";
            return Error{"--force-effects knows no '" + one + "'", "", 0, 0, help};
        }
        if (at == known.begin())
            set = EffectSet::all();
        else
            set.add(static_cast<Effect>(at - known.begin() - 1));
    }
    return set;
}

} // namespace

int run(const EvaluateCommand& command) {
    const auto fail = [](const Error& error) {
        say_error(error);
        return exit_failed;
    };
    const Result<EffectSet> forced = forced_effects(command.force_effects);
    if (!forced) return fail(forced.error());
    const Result<Loaded> loaded = load_scene(command);
    if (!loaded) return fail(loaded.error());

    Result<Prepared> prepared = prepare_scene(*loaded, 0);
    if (!prepared) return fail(prepared.error());
    Runs runs;
    const bool samples = !loaded->scene.output.csv.empty() || !loaded->scene.output.vtu.empty();
    while (!command.plan_only) {
        SampleFiles files(*loaded, *prepared);
        if (samples)
            if (auto opened = files.open(); !opened) return fail(opened.error());
        runs = make_runs(*loaded, *prepared, *forced);
        if (auto done = advance(*loaded, *prepared, runs, samples ? &files : nullptr, !command.quiet); !done)
            return fail(done.error());
        if (!runs.at_rim()) {
            if (auto numbers = all_finite(*loaded, *prepared, runs); !numbers) return fail(numbers.error());
            if (auto written = files.finish(); !written) return fail(written.error());
            break;
        }
        // The part of a surface that was cut out is too small: take more, at last all of it.
        const double travel = prepared->evaluation.travel;
        if (travel == infinity) break;
        runs = {};
        prepared = prepare_scene(*loaded, next_travel(prepared->evaluation));
        if (!prepared) return fail(prepared.error());
    }

    std::unique_ptr<FileSink> out = std::make_unique<FileSink>(STDOUT_FILENO, "standard output");
    if (!command.file.empty()) {
        Result<std::unique_ptr<FileSink>> file = FileSink::replace(command.file);
        if (!file) return fail(file.error());
        out = std::move(*file);
    }
    const EvaluationReport report =
        report_of(*loaded, *prepared, *forced, command.plan_only ? nullptr : &runs);
    if (command.plan_only)
        command.json ? write_plan_json(*out, report, tool_version()) : write_plan_text(*out, report);
    else
        command.json ? write_evaluation_json(*out, report, tool_version())
                     : write_evaluation_text(*out, report);
    int status = exit_clean;
    if (command.prove && !command.plan_only) {
        std::string text;
        if (!prove(*loaded, *prepared, runs, text)) status = exit_bug;
        if (command.json || !command.file.empty())
            say(text);
        else
            out->write("\nproof\n" + text);
    }
    if (const int written = finish(*out); written != exit_clean) return written;
    if (command.statistics && !command.plan_only) say_times(*prepared, runs);
    return status;
}

} // namespace drawbead
