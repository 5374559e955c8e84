#include "cli/commands.h"
#include "cli/evaluation_input.h"

#include "deck/units.h"
#include "report/accuracy.h"
#include "study/study.h"

#include <algorithm>
#include <limits>
#include <unistd.h>

namespace drawbead {

namespace {

/// The reference keeps its state at the end of every step of the scene's own settings.
constexpr uint64_t most_own_steps = 100'000;

AccuracyErrors list(const Errors& e) {
    return {e.begin(), e.end()};
}

AccuracyValues values(const BeadValues& v, const EvaluationBead& bead) {
    return {v.largest_restraint,      v.normal,    v.work, v.dissipated, v.worst,
            bead.nodes[v.worst_node], v.first_slip};
}

std::string key_of(std::string name) {
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

AccuracyRow row_of(const StudyRow& row, const EvaluationScene& scene) {
    AccuracyRow out;
    const ManualSettings& s = row.settings;
    out.settings = {{"steps", std::to_string(s.steps)},
                    {"line", text(s.line)},
                    {"kinks", std::string(name(s.kinks))},
                    {"tributary", std::string(name(s.tributary))},
                    {"projection", std::string(name(s.projection))},
                    {"search", std::string(name(s.search))},
                    {"sum", std::string(name(s.sum))},
                    {"number", std::string(name(s.number))}};
    out.brief = brief(s);
    out.yaml = yaml(s);
    for (std::size_t b = 0; b < row.values.size(); ++b) {
        out.values.push_back(values(row.values[b], scene.beads[b]));
        out.errors.push_back(list(row.errors[b]));
    }
    out.worst = list(row.worst);
    out.error = row.error();
    out.evaluations = row.cost.evaluations;
    out.searches = row.cost.searches;
    out.follows = row.cost.follows;
    out.projections = row.cost.projections;
    out.instants = row.cost.instants;
    out.at_floor = row.at_floor;
    out.on_front = row.on_front;
    out.median = row.median;
    out.least = row.least;
    return out;
}

AccuracyReport report_of(const Loaded& loaded, const Prepared& prepared, const Study& study,
                         const StudyOptions& options, const AccuracyCommand& command) {
    const EvaluationScene& scene = prepared.evaluation.scene;
    const UnitSystem& units = loaded.deck->work_units();
    AccuracyReport out;
    out.deck = loaded.scene.deck;
    out.scene = loaded.scene.path;
    out.force_unit = unit_name(units, force_dimension);
    out.length_unit = unit_name(units, length_dimension);
    out.time_unit = unit_name(units, time_dimension);
    if (!out.force_unit.empty() && !out.length_unit.empty())
        out.energy_unit = out.force_unit + ' ' + out.length_unit;
    out.begin = scene.time.front();
    out.end = scene.time.back();
    out.scene_steps = scene.time.size() - 1;
    out.reading = name(options.truth);
    for (std::size_t i = 0; i < quantity_count; ++i) {
        out.quantities.emplace_back(name(static_cast<Quantity>(i)));
        out.keys.push_back(key_of(out.quantities.back()));
    }
    for (std::size_t b = 0; b < scene.beads.size(); ++b) {
        const ReferenceBead& truth = study.reference[b];
        AccuracyBead bead;
        bead.id = scene.beads[b].id;
        bead.title = scene.beads[b].title;
        bead.nodes = scene.beads[b].nodes.size();
        bead.reference = {
            truth.restraint_largest, truth.normal_largest, truth.absorbed,
            truth.dissipated(),      truth.worst,          scene.beads[b].nodes[truth.worst_node],
            truth.first_slip};
        bead.first_contact = truth.first_contact;
        bead.solver = list(study.solver_of_bead[b]);
        bead.evaluate = list(study.evaluate_of_bead[b]);
        out.beads.push_back(std::move(bead));
        out.reference_evaluations += truth.evaluations;
        out.largest_restraint = std::max(out.largest_restraint, truth.restraint_largest);
    }
    out.reference_error = study.reference_error;
    for (const auto& [truth, errors] : study.readings)
        out.readings.emplace_back(name(truth), list(errors));
    for (const StudyRow& row : study.rows)
        out.rows.push_back(row_of(row, scene));
    for (const StudyPick& pick : study.picks)
        out.picks.push_back(
            {pick.tolerance, command.within && *command.within == pick.tolerance, pick.row, pick.best});
    for (const StudyOrder& o : study.orders)
        out.orders.push_back(
            {o.knob, o.quantity, o.expected, o.observed.order, std::string(name(o.observed.verdict)),
             o.observed.verdict == OrderVerdict::below, o.observed.first, o.observed.count, o.size, o.error});
    out.solver = list(study.solver);
    out.evaluate = list(study.evaluate);
    out.kinked = study.kinked;
    out.repeats = options.repeats;
    for (const LeftOut& left : prepared.evaluation.left_out)
        out.left_out.emplace_back(left.id, left.why);
    out.notes = loaded.notes;
    if (study.stride > 1)
        out.notes.push_back("difference of laws: restraint over time is compared after every " +
                            std::to_string(study.stride) + " of the scene's " +
                            std::to_string(out.scene_steps) + " steps");
    out.notes.insert(out.notes.end(), prepared.evaluation.notes.begin(), prepared.evaluation.notes.end());
    return out;
}

} // namespace

int run(const AccuracyCommand& command) {
    const auto fail = [](const Error& error) {
        say_error(error);
        return exit_failed;
    };
    if (command.hard_cases)
        return run_hard_cases(command.format == AccuracyCommand::Format::json, command.file);
    if (!is_scene_file(command.path))
        return fail({"accuracy needs a scene, a file NAME.yaml", command.path, 0, 0,
                     "docs/evaluate.md and 'drawbead schema scene' say what stands in it"});
    EvaluateCommand reading;
    reading.path = command.path;
    reading.law = "both";
    reading.reading = command.reading;
    Result<Loaded> loaded = load_scene(reading);
    if (!loaded) return fail(loaded.error());
    loaded->scene.output = {}; // nothing is written but the study
    const std::optional<ManualSettings> own = loaded->scene.accuracy;
    loaded->scene.accuracy.reset();
    if (own && own->steps > most_own_steps) {
        const ScenePlace at = loaded->scene.accuracy_steps;
        return fail(
            {"accuracy compares at most " + std::to_string(most_own_steps) + " steps with its reference",
             loaded->scene.path, at.line, at.column,
             "give fewer steps, or leave 'accuracy' out: 'drawbead evaluate' takes up to 1e8"});
    }

    StudyOptions options;
    options.truth = static_cast<Truth>(command.reference);
    options.threads = loaded->threads;
    options.own = own;
    if (!command.times) options.repeats = 0;
    if (command.within) {
        options.tolerances.push_back(*command.within);
        std::sort(options.tolerances.rbegin(), options.tolerances.rend());
        options.tolerances.erase(std::unique(options.tolerances.begin(), options.tolerances.end()),
                                 options.tolerances.end());
    }
    Study study;
    Result<Prepared> prepared = prepare_scene(*loaded, 0);
    while (true) {
        if (!prepared) return fail(prepared.error());
        Progress bar(!command.quiet, 100);
        options.progress = [&](std::size_t done, std::size_t all, const std::string& what) {
            bar.show(100 * done / std::max<std::size_t>(all, 1), what);
        };
        study = accuracy_study(prepared->evaluation.scene, prepared->steps, options);
        if (!study.rim || prepared->evaluation.travel == std::numeric_limits<double>::infinity()) break;
        prepared = prepare_scene(*loaded, next_travel(prepared->evaluation));
    }

    const AccuracyReport report = report_of(*loaded, *prepared, study, options, command);
    std::unique_ptr<FileSink> svg;
    if (!command.svg.empty()) {
        Result<std::unique_ptr<FileSink>> file = FileSink::replace(command.svg);
        if (!file) return fail(file.error());
        svg = std::move(*file);
        write_accuracy_svg(*svg, report);
    }
    std::unique_ptr<FileSink> out = std::make_unique<FileSink>(STDOUT_FILENO, "standard output");
    if (!command.file.empty()) {
        Result<std::unique_ptr<FileSink>> file = FileSink::replace(command.file);
        if (!file) return fail(file.error());
        out = std::move(*file);
    }
    switch (command.format) {
    case AccuracyCommand::Format::text:
        write_accuracy_text(*out, report, command.all);
        break;
    case AccuracyCommand::Format::json:
        write_accuracy_json(*out, report, tool_version());
        break;
    case AccuracyCommand::Format::csv:
        write_accuracy_csv(*out, report);
        break;
    }
    if (svg)
        if (const int written = finish(*svg); written != exit_clean) return written;
    if (const int written = finish(*out); written != exit_clean) return written;
    bool within = true;
    for (const AccuracyPick& pick : report.picks)
        if (pick.asked) within = pick.row.has_value();
    return within && report.orders_hold() ? exit_clean : exit_findings;
}

} // namespace drawbead
