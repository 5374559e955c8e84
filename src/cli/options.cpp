// The only file that includes CLI11: it takes the compiler many seconds.
#include "cli/options.h"

#include "base/nearest.h"
#include "cli/commands.h"
#include "report/text.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <deque>
#include <sstream>
#include <tuple>

namespace drawbead {

namespace {

using Words = std::vector<std::string>;

std::string joined(const Words& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : ", ") + word;
    return text;
}

/// As Format.
const Words report_formats{"full", "concise", "json", "jsonl", "csv", "sarif", "junit", "github", "gitlab"};

std::optional<Format> format_from(const std::string& word) {
    const auto at = std::find(report_formats.begin(), report_formats.end(), word);
    if (at == report_formats.end()) return std::nullopt;
    return static_cast<Format>(at - report_formats.begin());
}

/// "sarif=a.sarif" as a format and a file; empty when there is no format in front.
std::optional<OutputTarget> named_target(const std::string& word) {
    const std::size_t sign = word.find('=');
    const std::optional<Format> format =
        sign == std::string::npos ? std::nullopt : format_from(word.substr(0, sign));
    if (!format) return std::nullopt;
    const std::string file = word.substr(sign + 1);
    return OutputTarget{*format, file == "-" ? "" : file};
}

/// What is wrong with a word that is no FORMAT=FILE; empty when it can be a file.
std::optional<Error> wrong_target(const std::string& word) {
    if (format_from(word))
        return Error{"--output " + word + " names a format and no file", "", 0, 0,
                     "write " + word + "=FILE, or ./" + word + " for a file of this name"};
    if (const std::size_t sign = word.find('='); sign != std::string::npos)
        if (const std::string help = did_you_mean(word.substr(0, sign), report_formats); !help.empty())
            return Error{"--output knows no format '" + word.substr(0, sign) + "'", "", 0, 0,
                         help + " (./" + word + " for a file of this name)"};
    return std::nullopt;
}

/// Where results go: each FORMAT=FILE, and one place for `format` when it was asked for or there is nothing
/// else.
Result<std::vector<OutputTarget>> targets(const Words& outputs, Format format, bool asked_for) {
    std::vector<OutputTarget> all;
    bool placed = false;
    for (const std::string& word : outputs) {
        std::optional<OutputTarget> target = named_target(word);
        if (target && target->file.empty() && word.back() == '=')
            return Error{"--output " + word + " names no file", "", 0, 0, "- stands for standard output"};
        if (!target)
            if (std::optional<Error> wrong = wrong_target(word)) return *std::move(wrong);
        if (!target) {
            if (placed)
                return Error{"--output '" + word + "' is a second file for one format", "", 0, 0,
                             "write FORMAT=FILE, with one of " + joined(report_formats)};
            placed = true;
            target = OutputTarget{format, word == "-" ? "" : word};
        }
        all.push_back(std::move(*target));
    }
    if (!placed && (all.empty() || asked_for)) all.push_back({format, ""});
    for (auto one = all.begin(); one != all.end(); ++one)
        if (std::any_of(all.begin(), one, [&](const OutputTarget& other) {
                return plain_path(other.file) == plain_path(one->file);
            }))
            return Error{one->file.empty() ? "two formats want standard output"
                                           : "two formats want the file '" + one->file + "'",
                         "", 0, 0, "give each a file of its own: --output FORMAT=FILE"};
    return all;
}

/// The command line, and where its values go. Options whose value is one of a few words, or a list or number
/// of our own making, are taken as text and read in `finish`, so that their messages are ours.
class Parser {
public:
    Parser();
    std::variant<Command, UsageError> parse(int argc, const char* const* argv);
    std::vector<CommandSketch> describe();

private:
    struct Choice {
        CLI::Option* option;
        std::string value;
        Words words;
    };

    Choice& choice(CLI::App* command, const std::string& name, const Words& words, const std::string& help);
    void reading_options(CLI::App* command, ReadArguments& reading);
    void config_options(CLI::App* command, ConfigArguments& config);
    void scene_options(CLI::App* command, EvaluateCommand& values);
    void accuracy_options();
    static void output_option(CLI::App* command, Words& outputs);
    std::optional<UsageError> finish();
    std::optional<UsageError> finish_accuracy();
    std::optional<UsageError> finish_reports();
    UsageError explain(const CLI::ParseError& error, const CLI::App& command) const;
    Words option_names(const CLI::App& command) const;

    CLI::App app_{"Checks drawbeads (/INTER/TYPE8) of Radioss and OpenRadioss starter decks.", "drawbead"};
    CLI::App *check_, *merge_, *fix_, *table_, *info_, *audit_, *evaluate_, *plan_, *accuracy_, *rules_,
        *explain_, *schema_, *completion_;
    CheckCommand check_values_;
    MergeCommand merge_values_;
    FixCommand fix_values_;
    TableCommand table_values_;
    InfoCommand info_values_;
    AuditCommand audit_values_;
    EvaluateCommand evaluate_values_, plan_values_;
    AccuracyCommand accuracy_values_;
    RulesCommand rules_values_;
    ExplainCommand explain_values_;
    SchemaCommand schema_values_;
    CompletionCommand completion_values_;
    std::deque<Choice> choices_;
    Choice *check_format_, *fail_on_, *colour_, *merge_format_, *merge_fail_on_, *merge_colour_, *fix_format_,
        *fix_fail_on_, *fix_colour_, *normals_, *table_format_, *info_format_, *audit_law_, *audit_format_,
        *rules_format_, *evaluate_law_, *plan_law_, *evaluate_format_, *plan_format_, *accuracy_reference_,
        *accuracy_format_;
    Words select_, ignore_, fix_select_, fix_ignore_;
    Words check_outputs_, merge_outputs_, fix_outputs_;
    std::string shard_;
    Words force_effects_;
    std::string within_, threads_, interface_, tolerance_, end_, step_, steps_, every_;
    std::map<const CLI::Option*, Words>
        suggestions_; ///< for completion, of options that take other words too
};

Parser::Parser() {
    app_.set_version_flag("--version", "drawbead " + std::string(tool_version()),
                          "Print the version and leave");
    app_.set_help_flag("-h,--help", "Print this help and leave");
    app_.require_subcommand(1);
    app_.footer("Results go to standard output; errors, the summary and progress to standard error.\n"
                "Exit status: 0 clean, 1 findings (of fix: left after it), 2 could not do the work, 3 a bug "
                "of drawbead,\n130 interrupted.");

    check_ = app_.add_subcommand("check", "Check the drawbeads of decks");
    CLI::Option* paths =
        check_
            ->add_option("PATH", check_values_.paths,
                         "Decks, folders (all *_0000.rad below), patterns, - for standard input")
            ->type_name("");
    suggestions_[paths] = {};
    check_
        ->add_option("--scene", check_values_.scene,
                     "A scene as evaluate reads it: its deck, with its motion instead of the deck's own")
        ->type_name("FILE");
    Words with_names = rule_words(true);
    suggestions_[check_
                     ->add_option(
                         "--select", select_,
                         "Rules to run: codes, families or names, separated by commas (default: all)")
                     ->type_name("RULE")
                     ->allow_extra_args(false)] = with_names;
    suggestions_[check_
                     ->add_option("--ignore", ignore_,
                                  "Rules not to run; wins over --select where it is as precise or more")
                     ->type_name("RULE")
                     ->allow_extra_args(false)] = with_names;
    fail_on_ = &choice(check_, "--fail-on", {"error", "warning", "info", "never"},
                       "Least severity that gives exit status 1");
    check_format_ = &choice(check_, "--format", report_formats, "How findings are printed");
    output_option(check_, check_outputs_);
    check_
        ->add_option("--shard", shard_,
                     "Check only part K of N of the decks: every Nth; 'drawbead merge' joins the reports")
        ->type_name("K/N");
    check_->add_flag("--statistics", check_values_.statistics,
                     "Say at the end, on standard error, what each rule found and how long it took");
    colour_ = &choice(check_, "--color", {"auto", "always", "never"},
                      "When to colour text, NO_COLOR and CLICOLOR_FORCE heeded");
    check_->add_flag("-q,--quiet", check_values_.output.quiet, "No summary and no progress");
    check_->add_option("--baseline", check_values_.baseline, "Findings that are known and do not count")
        ->type_name("FILE");
    check_
        ->add_option("--write-baseline", check_values_.write_baseline,
                     "Make all findings known: write them to this file")
        ->type_name("FILE");
    config_options(check_, check_values_.config);
    check_->add_flag("--show-config", check_values_.config.show,
                     "Print what holds for each deck, with where it comes from, and check nothing");
    reading_options(check_, check_values_.reading);

    merge_ = app_.add_subcommand("merge", "Join JSON reports of check, into any of its formats");
    merge_->add_option("REPORT", merge_values_.reports, "Reports, of all shards of a run or of several runs")
        ->required()
        ->type_name("");
    merge_fail_on_ = &choice(merge_, "--fail-on", {"error", "warning", "info", "never"},
                             "Least severity that gives exit status 1");
    Words merged_formats = report_formats;
    std::rotate(merged_formats.begin(), std::find(merged_formats.begin(), merged_formats.end(), "json"),
                merged_formats.end());
    merge_format_ = &choice(merge_, "--format", merged_formats, "How the report is printed");
    output_option(merge_, merge_outputs_);
    merge_colour_ = &choice(merge_, "--color", {"auto", "always", "never"},
                            "When to colour text, NO_COLOR and CLICOLOR_FORCE heeded");
    merge_->add_flag("-q,--quiet", merge_values_.output.quiet, "No summary");

    fix_ = app_.add_subcommand("fix", "Repair the drawbeads of decks");
    suggestions_[fix_->add_option("PATH", fix_values_.paths,
                                  "Decks, folders (all *_0000.rad below), patterns, - for standard input")
                     ->required()
                     ->type_name("")] = {};
    fix_->add_flag("--diff", fix_values_.diff, "Print the changes for 'patch -p1' and write nothing");
    fix_->add_option("-o,--output", fix_outputs_,
                     "Write the repaired deck to a file; into a folder when includes change too; - for "
                     "standard output. With --dry-run: FORMAT=FILE, may be repeated")
        ->type_name("FILE")
        ->allow_extra_args(false);
    fix_->add_flag("--in-place", fix_values_.in_place,
                   "Replace the files that change, all of a deck or none");
    fix_->add_flag("--dry-run", fix_values_.dry_run, "Say what would be done and write nothing");
    suggestions_[fix_->add_option("--select", fix_select_,
                                  "Rules whose findings are repaired (default: all that can)")
                     ->type_name("RULE")
                     ->allow_extra_args(false)] = with_names;
    suggestions_[fix_->add_option("--ignore", fix_ignore_, "Rules whose findings are left alone")
                     ->type_name("RULE")
                     ->allow_extra_args(false)] = with_names;
    fix_->add_flag("--unsafe", fix_values_.unsafe, "Repairs that change the physics or make a choice, too");
    normals_ = &choice(fix_, "--normals", {"surfaces", "elements"},
                       "Turn normals in the surfaces alone, or in the elements");
    fix_format_ =
        &choice(fix_, "--format", {"text", "json", "jsonl", "csv", "sarif", "junit", "github", "gitlab"},
                "How the report is printed; from jsonl on: the findings, when nothing is written");
    fix_fail_on_ = &choice(fix_, "--fail-on", {"error", "warning", "info", "never"},
                           "Least severity of what is left that gives exit status 1");
    fix_colour_ = &choice(fix_, "--color", {"auto", "always", "never"},
                          "When to colour text, NO_COLOR and CLICOLOR_FORCE heeded");
    fix_->add_flag("-q,--quiet", fix_values_.output.quiet, "No report");
    config_options(fix_, fix_values_.config);
    reading_options(fix_, fix_values_.reading);

    table_ =
        app_.add_subcommand("table", "Say what every bead node meets: limits, segment, stiffness; and sums");
    table_->add_option("DECK", table_values_.path, "The deck, - for standard input")
        ->required()
        ->type_name("");
    table_->add_option("--interface", interface_, "Only the /INTER/TYPE8 with this id")->type_name("ID");
    table_format_ = &choice(table_, "--format", {"text", "csv", "json"}, "How it is printed");
    table_->add_option("-o,--output", table_values_.file, "Write to a file, all at once when complete")
        ->type_name("FILE");
    reading_options(table_, table_values_.reading);

    info_ = app_.add_subcommand("info", "Say what was read of a deck");
    info_->add_option("DECK", info_values_.path, "The deck, - for standard input")->required()->type_name("");
    info_format_ = &choice(info_, "--format", {"text", "json"}, "How it is printed");
    reading_options(info_, info_values_.reading);

    audit_ = app_.add_subcommand("audit", "Recompute a solver run from its recorded kinematics");
    audit_->add_option("DECK", audit_values_.deck, "The deck, - for standard input")
        ->required()
        ->type_name("");
    audit_
        ->add_option("TRACE", audit_values_.trace,
                     "The record: a CSV file, plain or gzip-compressed, one row per cycle and bead node")
        ->required()
        ->type_name("");
    audit_
        ->add_option("--tolerance", tolerance_,
                     "Largest deviation, as a share of each quantity's scale (default 1e-12)")
        ->type_name("N");
    audit_law_ = &choice(audit_, "--law", {"solver", "manual"},
                         "manual: say too how far the run was from the manual's law");
    audit_format_ = &choice(audit_, "--format", {"text", "json"}, "How it is printed");
    audit_
        ->add_option("-o,--output", audit_values_.file,
                     "Write the result to a file, all at once when complete")
        ->type_name("FILE");
    reading_options(audit_, audit_values_.reading);

    evaluate_ = app_.add_subcommand("evaluate", "Forces of the beads over a prescribed motion");
    scene_options(evaluate_, evaluate_values_);
    evaluate_->add_option("--csv", evaluate_values_.csv, "Write a line per step and bead node")
        ->type_name("FILE");
    evaluate_
        ->add_option("--vtu", evaluate_values_.vtu,
                     "Write a series for ParaView; the names of its files begin with this")
        ->type_name("FILE");
    evaluate_->add_option("--every", every_, "Of the steps, write every Nth (default 1)")->type_name("N");
    evaluate_
        ->add_option("--force-effects", force_effects_,
                     "Compute these effects though not needed: names, separated by commas, or all")
        ->type_name("EFFECT")
        ->allow_extra_args(false);
    evaluate_->add_flag("--prove", evaluate_values_.prove,
                        "Compute everything with all effects too: the same bits, or exit status 3");
    evaluate_->add_flag("--statistics", evaluate_values_.statistics,
                        "Say on standard error how long the steps took");
    evaluate_->add_flag("-q,--quiet", evaluate_values_.quiet, "No progress");
    evaluate_law_ =
        &choice(evaluate_, "--law", {"scene", "solver", "manual", "both"}, "Instead of the scene's law");
    evaluate_format_ = &choice(evaluate_, "--format", {"text", "json"}, "How it is printed");
    reading_options(evaluate_, evaluate_values_.reading);

    plan_ = app_.add_subcommand("plan", "Which effects a scene needs, and why not the others");
    scene_options(plan_, plan_values_);
    plan_law_ = &choice(plan_, "--law", {"scene", "solver", "manual", "both"}, "Instead of the scene's law");
    plan_format_ = &choice(plan_, "--format", {"text", "json"}, "How it is printed");
    reading_options(plan_, plan_values_.reading);

    accuracy_options();

    rules_ = app_.add_subcommand("rules", "List all rules");
    rules_format_ = &choice(rules_, "--format", {"text", "json"}, "How they are printed");

    explain_ = app_.add_subcommand("explain", "Print the page of a rule");
    suggestions_[explain_->add_option("RULE", explain_values_.rule, "Its code or name; or configuration")
                     ->required()
                     ->type_name("")] = with_names;

    schema_ = app_.add_subcommand("schema", "Print the JSON Schema of a document");
    suggestions_[schema_
                     ->add_option(
                         "NAME", schema_values_.name,
                         "report: what check --format json writes; lines: with --format jsonl, each\n"
                         "line; accuracy, audit, evaluation, fix, hard-cases, plan, table: what\n"
                         "these do; scene: what evaluate reads; config: .drawbead.yaml; baseline")
                     ->required()
                     ->type_name("")] = {"accuracy",   "audit", "baseline", "config", "evaluation", "fix",
                                         "hard-cases", "lines", "plan",     "report", "scene",      "table"};

    completion_ = app_.add_subcommand("completion", "Print a completion script for a shell");
    suggestions_[completion_->add_option("SHELL", completion_values_.shell, "bash, zsh or fish")
                     ->required()
                     ->type_name("")] = {"bash", "zsh", "fish"};
}

void Parser::output_option(CLI::App* command, Words& outputs) {
    command
        ->add_option("-o,--output", outputs,
                     "Write results to a file, all at once when complete; FORMAT=FILE for a format of its "
                     "own, may be repeated; - for standard output")
        ->type_name("FILE")
        ->allow_extra_args(false);
}

/// The first of `words` is the default.
Parser::Choice& Parser::choice(CLI::App* command, const std::string& name, const Words& words,
                               const std::string& help) {
    Choice& made = choices_.emplace_back(Choice{nullptr, words.front(), words});
    made.option = command->add_option(name, made.value, help + ": " + joined(words))
                      ->type_name("")
                      ->option_text("WORD");
    suggestions_[made.option] = words;
    return made;
}

void Parser::reading_options(CLI::App* command, ReadArguments& reading) {
    command
        ->add_option("--include-path", reading.include_path,
                     "Further folder to look for includes in; may be repeated")
        ->type_name("FOLDER")
        ->allow_extra_args(false);
    command->add_option("--include-root", reading.include_root, "Folder that no include may lie outside of")
        ->type_name("FOLDER");
    command
        ->add_option("--stdin-filename", reading.stdin_filename,
                     "What standard input is called; its includes are looked up beside it")
        ->type_name("FILE");
    command->add_option("-j,--threads", threads_, "Threads; 0, the default, for all cores")->type_name("N");
}

void Parser::config_options(CLI::App* command, ConfigArguments& config) {
    command
        ->add_option("--config", config.file,
                     "Configuration for all decks (default: .drawbead.yaml, looked for from each upward)")
        ->type_name("FILE");
    command->add_flag("--isolated", config.isolated, "Read no configuration");
}

/// Times for a deck alone, and where the result goes.
void Parser::scene_options(CLI::App* command, EvaluateCommand& values) {
    command->add_option("SCENE", values.path, "A scene (.yaml), or a deck that moves as it says")
        ->required()
        ->type_name("");
    command->add_option("--trace", values.trace, "For a deck: take the times of this recorded run")
        ->type_name("FILE");
    command
        ->add_option("--end", end_,
                     "For a deck: end of the run (default: the /RUN of the engine deck beside it)")
        ->type_name("T");
    command->add_option("--step", step_, "For a deck: length of a step")->type_name("T");
    command->add_option("--steps", steps_, "For a deck: number of equal steps (default 1000)")
        ->type_name("N");
    command->add_option("-o,--output", values.file, "Write the result to a file, all at once when complete")
        ->type_name("FILE");
}

void Parser::accuracy_options() {
    accuracy_ = app_.add_subcommand("accuracy",
                                    "What accuracy costs on a scene, and the cheapest settings within one");
    CLI::Option* scene = accuracy_->add_option("SCENE", accuracy_values_.path, "A scene (.yaml)");
    scene->type_name("");
    accuracy_
        ->add_flag("--hard-cases", accuracy_values_.hard_cases,
                   "Instead of a scene: the built-in hard cases, what must hold in them, and what each law "
                   "breaks")
        ->excludes(scene);
    accuracy_
        ->add_option("--within", within_,
                     "Print the cheapest settings with no error above this, such as 0.1% or 0.001")
        ->type_name("TOLERANCE");
    accuracy_reference_ =
        &choice(accuracy_, "--reference", {"line", "nodes", "arc"},
                "What counts as true: the integral along the line, or the sum over nodes with "
                "chords or half hops as lengths");
    accuracy_->add_flag("--all", accuracy_values_.all, "Show every setting, not only those on the front");
    accuracy_->add_flag("!--no-times", accuracy_values_.times, "Measure no times: the same bytes every run");
    accuracy_->add_option("--svg", accuracy_values_.svg, "Draw error over cost")->type_name("FILE");
    accuracy_format_ = &choice(accuracy_, "--format", {"text", "json", "csv"}, "How it is printed");
    accuracy_
        ->add_option("-o,--output", accuracy_values_.file,
                     "Write the result to a file, all at once when complete")
        ->type_name("FILE");
    accuracy_->add_flag("-q,--quiet", accuracy_values_.quiet, "No progress");
    reading_options(accuracy_, accuracy_values_.reading);
}

std::optional<UsageError> Parser::finish_accuracy() {
    const auto index = [](const Choice& one) {
        return std::find(one.words.begin(), one.words.end(), one.value) - one.words.begin();
    };
    accuracy_values_.reference = static_cast<AccuracyCommand::Reference>(index(*accuracy_reference_));
    accuracy_values_.format = static_cast<AccuracyCommand::Format>(index(*accuracy_format_));
    if (accuracy_values_.file == "-") accuracy_values_.file.clear();
    if (accuracy_->parsed() && accuracy_values_.path.empty() && !accuracy_values_.hard_cases)
        return UsageError{"accuracy needs a scene or --hard-cases", "see 'drawbead accuracy --help'"};
    if (accuracy_values_.hard_cases && accuracy_values_.format == AccuracyCommand::Format::csv)
        return UsageError{"--hard-cases prints no csv", "please give --format text or json"};
    if (within_.empty()) return std::nullopt;
    const bool percent = within_.back() == '%';
    double number = 0;
    const char* end = within_.data() + within_.size() - (percent ? 1 : 0);
    const auto [stop, error] = std::from_chars(within_.data(), end, number);
    if (percent) number /= 100;
    if (error != std::errc() || stop != end || !(number > 0) || !(number < 1))
        return UsageError{"--within needs a tolerance, not '" + within_ + "'",
                          "please give one above 0 and below 100%, such as 0.1% or 0.001"};
    accuracy_values_.within = number;
    return std::nullopt;
}

/// Reads what was taken as text.
std::optional<UsageError> Parser::finish() {
    for (const Choice& one : choices_) {
        if (std::find(one.words.begin(), one.words.end(), one.value) != one.words.end()) continue;
        std::string help = did_you_mean(one.value, one.words);
        if (help.empty()) help = "please give one of " + joined(one.words);
        return UsageError{one.option->get_name() + " knows no '" + one.value + "'", help};
    }
    const auto index = [](const Choice& one) {
        return std::find(one.words.begin(), one.words.end(), one.value) - one.words.begin();
    };
    if (check_->parsed() && check_values_.paths.empty() && check_values_.scene.empty())
        return UsageError{"check needs an argument: PATH is required", "see 'drawbead check --help'"};
    if (!check_values_.paths.empty() && !check_values_.scene.empty())
        return UsageError{"--scene names its deck itself", "please leave out PATH or --scene"};
    if (std::optional<UsageError> error = finish_reports()) return error;
    check_values_.fail_on = static_cast<FailOn>(index(*fail_on_));
    check_values_.fail_on_given = fail_on_->option->count() > 0;
    check_values_.output.colour = static_cast<ColourMode>(index(*colour_));
    table_values_.format = static_cast<TableFormat>(index(*table_format_));
    info_values_.json = index(*info_format_) == 1;
    audit_values_.json = index(*audit_format_) == 1;
    audit_values_.law = static_cast<AuditLaw>(index(*audit_law_));
    if (audit_values_.file == "-") audit_values_.file.clear();
    rules_values_.json = index(*rules_format_) == 1;
    if (table_values_.file == "-") table_values_.file.clear();

    const auto law = [](const Choice& one) {
        return one.value == one.words.front() ? std::nullopt : std::optional(one.value);
    };
    evaluate_values_.law = law(*evaluate_law_);
    plan_values_.law = law(*plan_law_);
    evaluate_values_.json = index(*evaluate_format_) == 1;
    plan_values_.json = index(*plan_format_) == 1;
    plan_values_.plan_only = true;
    for (EvaluateCommand* one : {&evaluate_values_, &plan_values_}) {
        if (one->file == "-") one->file.clear();
        for (const auto& [name, text, value] :
             {std::tuple{"--end", &end_, &one->end}, std::tuple{"--step", &step_, &one->step}}) {
            if (text->empty()) continue;
            double number = 0;
            const char* end = text->data() + text->size();
            const auto [stop, error] = std::from_chars(text->data(), end, number);
            if (error != std::errc() || stop != end || !(number > 0) || !(number < 1e30))
                return UsageError{std::string(name) + " needs a time, not '" + *text + "'",
                                  "please give a number above 0"};
            *value = number;
        }
        for (const auto& [name, text, value] :
             {std::tuple{"--steps", &steps_, &one->steps}, std::tuple{"--every", &every_, &one->every}}) {
            if (text->empty()) continue;
            constexpr uint64_t most = 100'000'000;
            uint64_t number = 0;
            const char* end = text->data() + text->size();
            const auto [stop, error] = std::from_chars(text->data(), end, number);
            if (error != std::errc() || stop != end || number == 0 || number > most)
                return UsageError{std::string(name) + " needs a number, not '" + *text + "'",
                                  "please give 1 to 100000000"};
            *value = number;
        }
        if (one->step && one->steps)
            return UsageError{"--step and --steps exclude each other", "please give one of them"};
    }

    if (auto wrong = finish_accuracy()) return wrong;

    const auto split = [](const Words& lists, Words& entries) {
        for (const std::string& list : lists) {
            std::istringstream stream(list + ',');
            for (std::string entry; std::getline(stream, entry, ',');) {
                entry.erase(0, entry.find_first_not_of(' '));
                entry.erase(entry.find_last_not_of(' ') + 1);
                entries.push_back(entry);
            }
        }
    };
    split(select_, check_values_.select);
    split(ignore_, check_values_.ignore);
    split(fix_select_, fix_values_.select);
    split(fix_ignore_, fix_values_.ignore);
    fix_values_.normals = static_cast<FixCommand::Normals>(index(*normals_));
    fix_values_.json = fix_format_->value == "json";
    fix_values_.fail_on = static_cast<FailOn>(index(*fix_fail_on_));
    fix_values_.fail_on_given = fix_fail_on_->option->count() > 0;
    for (const ConfigArguments* config : {&check_values_.config, &fix_values_.config})
        if (config->isolated && !config->file.empty())
            return UsageError{"--config and --isolated exclude each other", "give one of them"};
    fix_values_.output.colour = static_cast<ColourMode>(index(*fix_colour_));
    if (const int ways = int{fix_values_.diff} + int{fix_values_.in_place} + int{fix_values_.dry_run} +
                         int{!fix_values_.output.file.empty()};
        ways > 1)
        return UsageError{"--diff, --output, --in-place and --dry-run exclude each other",
                          "see 'drawbead fix --help'"};
    if (fix_values_.diff && fix_values_.json)
        return UsageError{"--diff and --format json both want standard output",
                          "the JSON report of --dry-run has all edits"};
    split(force_effects_, evaluate_values_.force_effects);

    if (!interface_.empty()) {
        int64_t id = 0;
        const char* end = interface_.data() + interface_.size();
        const auto [stop, error] = std::from_chars(interface_.data(), end, id);
        if (error != std::errc() || stop != end)
            return UsageError{"--interface needs the id of a /INTER/TYPE8, not '" + interface_ + "'",
                              "see 'drawbead table --help'"};
        table_values_.interface_id = id;
    }
    if (!tolerance_.empty()) {
        const char* end = tolerance_.data() + tolerance_.size();
        const auto [stop, error] = std::from_chars(tolerance_.data(), end, audit_values_.tolerance);
        if (error != std::errc() || stop != end || !(audit_values_.tolerance >= 0) ||
            !(audit_values_.tolerance < 1))
            return UsageError{"--tolerance needs a number, not '" + tolerance_ + "'",
                              "please give 0 to below 1, such as 1e-12"};
    }
    if (!threads_.empty()) {
        constexpr unsigned most = 1024;
        unsigned threads = 0;
        const char* end = threads_.data() + threads_.size();
        const auto [stop, error] = std::from_chars(threads_.data(), end, threads);
        if (error != std::errc() || stop != end || threads > most)
            return UsageError{"-j needs a number of threads, not '" + threads_ + "'",
                              "please give 0 (all cores) to 1024"};
        check_values_.reading.threads = fix_values_.reading.threads = table_values_.reading.threads =
            info_values_.reading.threads = audit_values_.reading.threads = evaluate_values_.reading.threads =
                plan_values_.reading.threads = accuracy_values_.reading.threads = threads;
    }
    return std::nullopt;
}

/// The formats and files of the commands that write findings.
std::optional<UsageError> Parser::finish_reports() {
    const auto read = [](const Words& outputs, std::optional<Format> format, bool asked_for,
                         std::vector<OutputTarget>& into) -> std::optional<UsageError> {
        auto all = targets(outputs, format.value_or(Format::full), asked_for);
        if (!all) return UsageError{all.error().message, all.error().help};
        into = std::move(*all);
        return std::nullopt;
    };
    for (const auto& [command, outputs, choice, into] :
         {std::tuple{check_, &check_outputs_, check_format_, &check_values_.outputs},
          std::tuple{merge_, &merge_outputs_, merge_format_, &merge_values_.outputs}})
        if (command->parsed())
            if (auto error = read(*outputs, format_from(choice->value), choice->option->count() > 0, *into))
                return error;
    const auto index = [](const Choice& one) {
        return std::find(one.words.begin(), one.words.end(), one.value) - one.words.begin();
    };
    if (merge_fail_on_->option->count() > 0)
        merge_values_.fail_on = static_cast<FailOn>(index(*merge_fail_on_));
    merge_values_.output.colour = static_cast<ColourMode>(index(*merge_colour_));

    // Of fix, a name without a format is where the repaired deck goes.
    Words reports;
    for (const std::string& word : fix_outputs_) {
        if (named_target(word)) {
            reports.push_back(word);
        } else if (fix_values_.output.file.empty()) {
            fix_values_.output.file = word;
        } else {
            return UsageError{"-o takes one file or folder for the repaired deck",
                              "two were given: '" + fix_values_.output.file + "' and '" + word + "'"};
        }
    }
    if (fix_format_->value != "text" && fix_format_->value != "json")
        reports.push_back(fix_format_->value + "=-");
    if (!reports.empty()) {
        if (auto error = read(reports, {}, false, fix_values_.findings)) return error;
        if (fix_format_->value == "json" &&
            std::any_of(fix_values_.findings.begin(), fix_values_.findings.end(),
                        [](const OutputTarget& one) { return one.file.empty(); }))
            return UsageError{"two formats want standard output", "give each a file of its own"};
        if (fix_values_.diff || fix_values_.in_place || !fix_values_.output.file.empty())
            return UsageError{"findings in other formats are for a run that writes nothing",
                              "please give --dry-run instead"};
    }

    if (shard_.empty()) return std::nullopt;
    ShardArgument shard;
    const char* const end = shard_.data() + shard_.size();
    const auto [slash, error] = std::from_chars(shard_.data(), end, shard.number);
    constexpr uint64_t most = 100'000;
    bool good = error == std::errc() && slash != end && *slash == '/';
    if (good) {
        const auto [stop, wrong] = std::from_chars(slash + 1, end, shard.of);
        good = wrong == std::errc() && stop == end;
    }
    if (!good || shard.number < 1 || shard.number > shard.of || shard.of > most)
        return UsageError{"--shard needs a part and a number of parts, not '" + shard_ + "'",
                          "such as 2/7: the second of seven"};
    check_values_.shard = shard;
    return std::nullopt;
}

Words Parser::option_names(const CLI::App& command) const {
    Words names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    return names;
}

/// What is wrong, in our words where we know.
UsageError Parser::explain(const CLI::ParseError& error, const CLI::App& command) const {
    const std::string see =
        "see 'drawbead" + (&command == &app_ ? "" : " " + command.get_name()) + " --help'";
    const Words extras = app_.remaining(true);
    const auto option = std::find_if(extras.begin(), extras.end(), [](const std::string& word) {
        return word.size() > 1 && word[0] == '-';
    });
    if (option != extras.end()) {
        const std::string name = option->substr(0, option->find('='));
        const std::string help = did_you_mean(name, option_names(command));
        return {"unknown option '" + name + "'", help.empty() ? see : help};
    }
    if (!extras.empty()) return {"unexpected argument '" + extras.front() + "'", see};
    std::string message = error.what();
    if (dynamic_cast<const CLI::RequiredError*>(&error))
        message = &command == &app_ ? "a command is missing"
                                    : command.get_name() + " needs an argument: " + message;
    return {message, see};
}

std::variant<Command, UsageError> Parser::parse(int argc, const char* const* argv) {
    Words commands;
    for (const CLI::App* command : app_.get_subcommands([](const CLI::App*) { return true; }))
        commands.push_back(command->get_name());
    if (argc > 1 && argv[1][0] != '-' &&
        std::find(commands.begin(), commands.end(), argv[1]) == commands.end()) {
        const std::string help = did_you_mean(argv[1], commands);
        return UsageError{"unknown command '" + std::string(argv[1]) + "'",
                          help.empty() ? "please give one of " + joined(commands) : help};
    }
    // A pattern in brackets would be taken for a list in CLI11's own notation.
    Words arguments(argv, argv + argc);
    for (std::string& word : arguments)
        if (!word.empty() && word.front() == '[' && word.back() == ']') word.insert(0, "./");
    std::vector<const char*> pointers;
    for (const std::string& word : arguments)
        pointers.push_back(word.c_str());
    try {
        app_.parse(argc, pointers.data());
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            std::ostringstream text;
            app_.exit(error, text, text);
            return Command{PrintCommand{text.str()}};
        }
        const std::vector<CLI::App*> chosen = app_.get_subcommands();
        return explain(error, chosen.empty() ? app_ : *chosen.front());
    }
    if (std::optional<UsageError> error = finish()) return *error;
    if (check_->parsed()) return Command{check_values_};
    if (merge_->parsed()) return Command{merge_values_};
    if (fix_->parsed()) return Command{fix_values_};
    if (table_->parsed()) return Command{table_values_};
    if (info_->parsed()) return Command{info_values_};
    if (audit_->parsed()) return Command{audit_values_};
    if (evaluate_->parsed()) return Command{evaluate_values_};
    if (plan_->parsed()) return Command{plan_values_};
    if (accuracy_->parsed()) return Command{accuracy_values_};
    if (rules_->parsed()) return Command{rules_values_};
    if (explain_->parsed()) return Command{explain_values_};
    if (schema_->parsed()) return Command{schema_values_};
    return Command{completion_values_};
}

std::vector<CommandSketch> Parser::describe() {
    std::vector<CommandSketch> commands;
    for (const CLI::App* command : app_.get_subcommands([](const CLI::App*) { return true; })) {
        CommandSketch sketch{command->get_name(), command->get_description(), {}, std::nullopt};
        for (const CLI::Option* option : command->get_options()) {
            OptionSketch one;
            if (!option->get_lnames().empty()) one.long_name = "--" + option->get_lnames().front();
            if (!option->get_snames().empty()) one.short_name = "-" + option->get_snames().front();
            one.help = option->get_description();
            const auto words = suggestions_.find(option);
            if (words != suggestions_.end()) one.choices = words->second;
            using Value = OptionSketch::Value;
            if (option->get_items_expected_max() == 0)
                one.value = Value::none;
            else if (!one.choices.empty())
                one.value = Value::choice;
            else if (option->get_type_name() == "FOLDER")
                one.value = Value::folder;
            else if (option->get_type_name() == "FILE" || option->get_positional())
                one.value = Value::file;
            else
                one.value = Value::any;
            if (option->get_positional())
                sketch.positional = one;
            else
                sketch.options.push_back(one);
        }
        commands.push_back(std::move(sketch));
    }
    return commands;
}

} // namespace

std::variant<Command, UsageError> parse_command_line(int argc, const char* const* argv) {
    return Parser().parse(argc, argv);
}

std::vector<CommandSketch> describe_command_line() {
    return Parser().describe();
}

} // namespace drawbead
