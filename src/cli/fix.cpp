#include "rules/fix.h"

#include "cli/commands.h"
#include "cli/deck_settings.h"
#include "cli/interrupt.h"
#include "cli/outputs.h"
#include "cli/paths.h"
#include "cli/reading.h"
#include "cli/selection.h"
#include "fix/write_files.h"
#include "report/fix_report.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <unistd.h>

namespace drawbead {

namespace {

namespace fs = std::filesystem;

/// How a diff names a file: from the current folder where the file is in it, else without its first slash.
std::string name_in_diff(const std::string& path) {
    std::error_code failure;
    const fs::path normal = fs::path(path).lexically_normal();
    if (normal.is_relative()) return normal.string();
    const std::string from_here = normal.lexically_relative(fs::current_path(failure)).string();
    if (!failure && !from_here.empty() && from_here.substr(0, 2) != "..") return from_here;
    return normal.relative_path().string();
}

std::string_view main_text(const FixOutcome& outcome) {
    return outcome.result->deck->files().front()->bytes();
}

/// Where each file of the deck goes in a folder: as it stands below the folder of the main file.
Result<std::vector<std::pair<const SourceFile*, std::string>>> places_in(const fs::path& folder,
                                                                         const Deck& deck) {
    std::vector<std::pair<const SourceFile*, std::string>> places;
    const fs::path base = fs::path(deck.path()).parent_path();
    for (const auto& file : deck.files()) {
        const fs::path below = fs::path(file->path()).lexically_relative(base.empty() ? "." : base);
        if (below.empty() || below.is_absolute() || *below.begin() == "..")
            return Error{"the include '" + file->path() + "' is not below the folder of the deck",
                         deck.path(), 0, 0, "use --in-place or --diff"};
        places.emplace_back(file.get(), (folder / below).string());
    }
    return places;
}

/// With -o the files of the deck stay as they are.
Result<void> spare_the_deck(const std::string& target, const Deck& deck) {
    std::error_code failure;
    for (const auto& file : deck.files())
        if (fs::equivalent(target, file->path(), failure))
            return Error{"-o would write over a file of the deck", target, 0, 0,
                         "give -o another place, or use --in-place"};
    return {};
}

Result<void> write_to(const std::string& target, const FixOutcome& outcome, FixReport& report) {
    std::error_code failure;
    const Deck& deck = *outcome.result->deck;
    if (target.back() != '/' && !fs::is_directory(target, failure)) {
        const FixedFile& first = outcome.files.front();
        if (outcome.files.size() > 1 || first.path != deck.files().front()->path())
            return Error{"the repair changes included files, too", first.path, 0, 0,
                         "give -o a folder, or use --in-place or --diff"};
        if (auto spared = spare_the_deck(target, deck); !spared) return spared;
        if (auto written = write_file(target, main_text(outcome), deck.path()); !written) return written;
        report.written.push_back(target);
        return {};
    }
    const auto places = places_in(target, deck);
    if (!places) return places.error();
    for (const auto& place : *places)
        if (auto spared = spare_the_deck(place.second, deck); !spared) return spared;
    for (const auto& [file, path] : *places) {
        fs::create_directories(fs::path(path).parent_path(), failure);
        if (auto written = write_file(path, file->bytes(), file->path()); !written) return written;
        report.written.push_back(path);
    }
    return {};
}

Result<void> write_in_place(const FixOutcome& outcome, FileReader& reader, FixReport& report) {
    std::vector<FileToWrite> files;
    for (const FixedFile& file : outcome.files)
        files.push_back({file.path, file.original, file.text});
    auto written =
        replace_files(files, [&](const std::string& path) { return reader.changed_since_read(path); });
    if (!written) return written;
    for (const FileToWrite& file : files)
        report.written.push_back(file.path);
    return {};
}

FixReport failed_report(const std::string& path, const std::string& failure, const std::string& help) {
    FixReport report;
    report.path = path;
    report.failure = failure;
    report.failure_help = help;
    return report;
}

/// The findings before the repair, each with a note on what would become of it.
DeckResult with_verdicts(const FixOutcome& outcome) {
    DeckResult result = outcome.before;
    for (Finding& finding : result.findings) {
        const auto is_its = [&](const auto& one) {
            return one.code == finding.code && one.interface_id == finding.interface_id;
        };
        const auto same_message = [&](const AppliedFix& one) {
            return is_its(one) && one.message == finding.message;
        };
        const auto& applied = outcome.applied;
        auto made = std::find_if(applied.begin(), applied.end(), same_message);
        const auto declined = std::find_if(outcome.declined.begin(), outcome.declined.end(), is_its);
        // In later rounds a finding may count differently.
        if (made == applied.end() && declined == outcome.declined.end())
            made = std::find_if(applied.begin(), applied.end(), is_its);
        if (made != applied.end())
            finding.notes.push_back("'drawbead fix' would repair it: " + made->title);
        else if (declined != outcome.declined.end())
            finding.notes.push_back("'drawbead fix' would leave it: " + declined->why);
    }
    return result;
}

/// Repairs one deck and puts the result where the command says. `findings`: takes them when they are asked
/// for.
FixReport fix_one(const DeckPath& deck, const FixCommand& command, const Settings& settings,
                  const Selection& counted, FixOptions options, OutputSink& out,
                  std::optional<DeckResult>& findings) {
    if (deck.failed()) return failed_report(deck.path, deck.failure, deck.help);
    if (deck.path == "-" && command.in_place)
        return failed_report(deck.path, "standard input cannot be repaired in place", "use -o");
    const Result<DeckSource> source = deck_source(deck.path, command.reading);
    if (!source) return failed_report(deck.path, source.error().message, source.error().help);
    ReadOptions reading = read_options(command.reading, options.threads);
    reading.include_path = settings.include_path.value;
    options.selection = settings.selection();
    options.counted = counted;
    options.limits = settings.rule_limits();
    options.severity = settings.severities();
    const FixOutcome outcome = run_fixes(source->name, *source->reader, reading, options);
    if (options.with_changes) findings = with_verdicts(outcome);
    if (outcome.before.failed()) {
        say_failure(outcome.before);
        return report_of(outcome, command.json);
    }
    FixReport report = report_of(outcome, command.json);
    report.proposed = !command.in_place && command.output.file.empty();
    Result<void> written;
    if (command.diff) {
        for (const FixedFile& file : outcome.files)
            out.write(unified_diff(name_in_diff(file.path), file.original, file.edits));
    } else if (command.output.file == "-") {
        if (outcome.files.size() > 1 ||
            (outcome.changed() &&
             outcome.files.front().path != outcome.result->deck->files().front()->path()))
            written = Error{"the repair changes included files, too", source->name, 0, 0,
                            "give -o a folder, or use --in-place or --diff"};
        else
            out.write(main_text(outcome));
    } else if (outcome.changed() && command.in_place) {
        written = write_in_place(outcome, *source->reader, report);
    } else if (outcome.changed() && !command.output.file.empty()) {
        written = write_to(command.output.file, outcome, report);
    }
    if (!written) {
        say_error(written.error());
        report.failure = written.error().message;
        report.failure_help = written.error().help;
    }
    return report;
}

} // namespace

int run(const FixCommand& command) {
    note_interrupts();
    const std::vector<DeckPath> decks = find_decks(command.paths);
    const Result<DeckSettings> settings =
        DeckSettings::of(decks, command.config, command.reading,
                         {command.select, command.ignore, command.fail_on_given, command.fail_on});
    if (!settings) {
        say_error(settings.error());
        return exit_failed;
    }
    if (decks.size() != 1 && !command.output.file.empty()) {
        say_error({"-o takes the repair of one deck, and there are " + std::to_string(decks.size()), "", 0, 0,
                   "use --in-place or --diff"});
        return exit_failed;
    }
    FixOptions options;
    options.choices.unsafe = command.unsafe;
    options.choices.normals =
        command.normals == FixCommand::Normals::elements ? NormalsMode::elements : NormalsMode::surfaces;
    options.threads = thread_count(command.reading);
    options.with_changes = !command.findings.empty();

    const std::vector<RuleInfo> rules = rule_catalogue();
    WriterOptions writing;
    writing.tool_version = tool_version();
    writing.rules = rules;
    if (command.fail_on_given) writing.fail_on = least_failing(command.fail_on);
    std::vector<std::string> inputs = settings->files();
    for (const DeckPath& deck : decks)
        inputs.push_back(deck.path);
    Result<std::unique_ptr<Outputs>> outputs =
        Outputs::open(command.findings, command.output.colour, writing, inputs);
    if (!outputs) {
        say_error(outputs.error());
        return exit_failed;
    }
    const bool findings_on_stdout =
        std::any_of(command.findings.begin(), command.findings.end(),
                    [](const OutputTarget& target) { return target.file.empty(); });

    // The report gives way where standard output carries a diff or a deck.
    FileSink out(STDOUT_FILENO, "standard output");
    const bool aside = command.diff || command.output.file == "-";
    FileSink errors(STDERR_FILENO, "standard error");
    OutputSink& report_sink = aside ? static_cast<OutputSink&>(errors) : out;
    const bool colour = wants_colour(command.output.colour, aside ? STDERR_FILENO : STDOUT_FILENO);

    Summary found;
    bool failed = false, failing = false;
    std::vector<FixReport> reports;
    std::size_t done = 0;
    for (std::size_t i = 0; i < decks.size() && interrupt_signal() == 0; ++i, ++done) {
        const DeckPath& deck = decks[i];
        const Settings holds = settings->of(i);
        FixReport report;
        std::optional<DeckResult> findings;
        try {
            report = fix_one(deck, command, holds, settings->of_files(i).selection(), options, out, findings);
        } catch (const std::bad_alloc&) {
            report = failed_report(deck.path, "out of memory", "");
        }
        if (report.failed() && report.applied.empty() && (deck.failed() || deck.path == "-"))
            say_error({report.failure, report.path, 0, 0, report.failure_help});
        failed = failed || report.failed();
        failing = failing || fails(report.remaining, least_failing(fail_on_from(holds.fail_on.value)));
        if (options.with_changes) {
            if (!findings) findings = failed_deck(report.path, report.failure, report.failure_help);
            findings->fail_on = least_failing(fail_on_from(settings->of_files(i).fail_on.value));
            std::vector<DeckResult> one;
            one.push_back(std::move(*findings));
            add(found, summarise(one));
            (*outputs)->deck(one.front());
        }
        if (!command.json && !findings_on_stdout && !command.output.quiet && !report.failed())
            write_fix_text(report_sink, report, colour);
        if (command.json) reports.push_back(std::move(report));
    }
    if (command.json) write_fix_json(report_sink, reports, tool_version());
    errors.flush();
    found.asked = decks.size();
    found.interrupted = done < decks.size();
    const int status = found.interrupted ? 128 + interrupt_signal()
                       : failed          ? exit_failed
                       : failing         ? exit_findings
                                         : exit_clean;
    if (found.interrupted)
        say("interrupted: " + std::to_string(done) + " of " + std::to_string(decks.size()) +
            " decks are done");
    found.exit_status = status;
    (*outputs)->end(found);
    if (const int unwritten = (*outputs)->finish(); unwritten != exit_clean) return unwritten;
    if (const int unwritten = finish(out); unwritten != exit_clean) return unwritten;
    return status;
}

} // namespace drawbead
