#pragma once
// The command line as plain structs: whatever parses it stays in options.cpp.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace drawbead {

enum class Format { full, concise, json, jsonl, csv, sarif, junit, github, gitlab };
enum class ColourMode { automatic, always, never };
enum class FailOn { error, warning, info, never };

/// How decks are found and read; the same for every command that reads one.
struct ReadArguments {
    std::vector<std::string> include_path;
    std::string include_root;
    std::string stdin_filename; ///< what `-` is called; empty: "<stdin>"
    unsigned threads = 0;       ///< 0: all cores
};

/// Which configuration holds.
struct ConfigArguments {
    std::string file;      ///< for all decks; empty: looked for from each deck upward
    bool isolated = false; ///< none
    bool show = false;     ///< print it and do nothing else
};

/// Where results go and what stands around them.
struct OutputArguments {
    std::string file; ///< empty: standard output
    ColourMode colour = ColourMode::automatic;
    bool quiet = false; ///< no summary, no progress
};

/// One of the results of a run: its format, and the file that it goes to.
struct OutputTarget {
    Format format = Format::full;
    std::string file; ///< empty: standard output
};

/// One of `of` equal parts of the decks, from 1.
struct ShardArgument {
    uint64_t number = 1, of = 1;
};

struct CheckCommand {
    std::vector<std::string> paths;          ///< none with a scene
    std::string scene;                       ///< names the deck, and how things move; empty: none
    std::vector<std::string> select, ignore; ///< single entries, as typed
    FailOn fail_on = FailOn::error;
    bool fail_on_given = false;           ///< on the command line
    std::string baseline, write_baseline; ///< empty: none
    ConfigArguments config;
    std::vector<OutputTarget> outputs; ///< at least one, all different
    std::optional<ShardArgument> shard;
    bool statistics = false;
    ReadArguments reading;
    OutputArguments output; ///< `file` is not used
};

/// Reports of `check` in JSON become one, in any format.
struct MergeCommand {
    std::vector<std::string> reports;
    std::optional<FailOn> fail_on; ///< empty: as each deck's run had it
    std::vector<OutputTarget> outputs;
    OutputArguments output; ///< `file` is not used
};

struct FixCommand {
    enum class Normals { surfaces, elements };

    std::vector<std::string> paths;
    std::vector<std::string> select, ignore; ///< single entries, as typed
    bool diff = false, in_place = false, dry_run = false;
    bool unsafe = false;
    Normals normals = Normals::surfaces;
    bool json = false;
    std::vector<OutputTarget> findings; ///< the findings and what would be done about them, in these formats
    FailOn fail_on = FailOn::error;
    bool fail_on_given = false; ///< on the command line
    ConfigArguments config;
    ReadArguments reading;
    OutputArguments output; ///< file: where the repaired deck goes, or a folder; "-" standard output
};

enum class TableFormat { text, csv, json };

struct TableCommand {
    std::string path;
    std::optional<int64_t> interface_id; ///< of the only one wanted
    TableFormat format = TableFormat::text;
    std::string file; ///< empty: standard output
    ReadArguments reading;
};

struct InfoCommand {
    std::string path;
    bool json = false;
    ReadArguments reading;
};

enum class AuditLaw { solver, manual };

struct AuditCommand {
    std::string deck, trace;
    double tolerance = 1e-12;
    AuditLaw law = AuditLaw::solver;
    bool json = false;
    std::string file; ///< empty: standard output
    ReadArguments reading;
};

/// `evaluate`, and `plan`, which stops before the first step.
struct EvaluateCommand {
    std::string path;                ///< a scene (.yaml, .yml) or a deck
    std::optional<std::string> law;  ///< instead of the scene's
    std::string trace;               ///< of a deck: times of a recorded run
    std::optional<double> end, step; ///< of a deck
    std::optional<uint64_t> steps;   ///< of a deck
    std::string csv, vtu;            ///< instead of the scene's
    std::optional<uint64_t> every;   ///< likewise
    std::vector<std::string> force_effects;
    bool prove = false, plan_only = false, json = false, quiet = false;
    bool statistics = false; ///< say how long the steps took
    std::string file;        ///< empty: standard output
    ReadArguments reading;
};

/// `accuracy`.
struct AccuracyCommand {
    enum class Format { text, json, csv };
    enum class Reference { line, nodes, arc };

    bool hard_cases = false;      ///< the built-in scenes instead of the user's
    std::string path;             ///< a scene
    std::optional<double> within; ///< tolerance asked for, a share
    Reference reference = Reference::line;
    bool all = false;   ///< every setting in the text, not only those on the front
    bool times = true;  ///< measure them
    bool quiet = false; ///< no progress
    Format format = Format::text;
    std::string svg;  ///< empty: none
    std::string file; ///< empty: standard output
    ReadArguments reading;
};

struct RulesCommand {
    bool json = false;
};

struct ExplainCommand {
    std::string rule; ///< code or name as typed
};

struct SchemaCommand {
    std::string name;
};

struct CompletionCommand {
    std::string shell; ///< bash, zsh or fish
};

/// Text to print instead of doing anything: --help, --version.
struct PrintCommand {
    std::string text;
};

using Command = std::variant<CheckCommand, MergeCommand, FixCommand, TableCommand, InfoCommand, AuditCommand,
                             EvaluateCommand, AccuracyCommand, RulesCommand, ExplainCommand, SchemaCommand,
                             CompletionCommand, PrintCommand>;

/// A command line that cannot be understood.
struct UsageError {
    std::string message;
    std::string help;
};

std::variant<Command, UsageError> parse_command_line(int argc, const char* const* argv);

/// The command line as data, for completion scripts.
struct OptionSketch {
    enum class Value { none, any, file, folder, choice };
    std::string long_name, short_name; ///< with dashes; empty when there is none
    std::string help;
    Value value = Value::none;
    std::vector<std::string> choices;
};
struct CommandSketch {
    std::string name, help;
    std::vector<OptionSketch> options;
    std::optional<OptionSketch> positional;
};
std::vector<CommandSketch> describe_command_line();

} // namespace drawbead
