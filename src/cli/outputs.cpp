#include "cli/outputs.h"

#include "cli/commands.h"
#include "cli/selection.h"
#include "rules/rule.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace drawbead {

namespace {

std::unique_ptr<ReportWriter> make_writer(Format format, OutputSink& out, bool colour,
                                          const WriterOptions& options) {
    switch (format) {
    case Format::full:
        return full_writer(out, colour);
    case Format::concise:
        return concise_writer(out, colour);
    case Format::json:
        return json_writer(out, options);
    case Format::jsonl:
        return lines_writer(out, options);
    case Format::csv:
        return csv_writer(out);
    case Format::sarif:
        return sarif_writer(out, options);
    case Format::junit:
        return junit_writer(out, options);
    case Format::github:
        return github_writer(out);
    case Format::gitlab:
        break;
    }
    return gitlab_writer(out);
}

bool is_one_of(const std::string& file, const std::vector<std::string>& inputs) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return false;
    return std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
        std::error_code ignored;
        return std::filesystem::equivalent(file, input, ignored);
    });
}

/// Where a file is, or would be, with links resolved.
std::filesystem::path place_of(const std::string& file) {
    namespace fs = std::filesystem;
    std::error_code failure;
    if (const fs::path whole = fs::canonical(file, failure); !failure) return whole;
    const fs::path path(file);
    const fs::path folder = fs::canonical(path.has_parent_path() ? path.parent_path() : ".", failure);
    return failure ? path.lexically_normal() : folder / path.filename();
}

std::optional<std::pair<uint64_t, uint64_t>> identity_of(const std::string& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return std::pair<uint64_t, uint64_t>(status.st_dev, status.st_ino);
}

} // namespace

Result<std::unique_ptr<Outputs>> Outputs::open(const std::vector<OutputTarget>& targets, ColourMode mode,
                                               const WriterOptions& options,
                                               const std::vector<std::string>& inputs,
                                               const std::string& aside) {
    auto outputs = std::make_unique<Outputs>();
    std::set<std::filesystem::path> taken;
    if (!aside.empty()) taken.insert(place_of(aside));
    for (const OutputTarget& target : targets) {
        // Pipes and devices take what comes from several.
        std::error_code ignored;
        const bool is_file = !target.file.empty() && (identity_of(target.file).has_value() ||
                                                      !std::filesystem::exists(target.file, ignored));
        if (is_file && !taken.insert(place_of(target.file)).second)
            return Error{"two results of this run want this file", target.file, 0, 0,
                         "give each a file of its own"};
        One one;
        bool colour = mode == ColourMode::always;
        if (target.file.empty()) {
            one.standard_output = true;
            one.sink = std::make_unique<FileSink>(STDOUT_FILENO, "standard output");
            colour = wants_colour(mode, STDOUT_FILENO);
            outputs->on_terminal_ = ::isatty(STDOUT_FILENO) == 1;
        } else if (is_one_of(target.file, inputs)) {
            return Error{"results would take the place of a file that is read", target.file, 0, 0,
                         "give --output another file"};
        } else {
            one.file = target.file;
            one.replaces = identity_of(target.file);
            Result<std::unique_ptr<FileSink>> file = FileSink::replace(target.file);
            if (!file) return file.error();
            one.sink = std::move(*file);
        }
        one.writer = make_writer(target.format, *one.sink, colour, options);
        outputs->all_.push_back(std::move(one));
    }
    return outputs;
}

// Which files a deck includes is known only when it has been read.
void Outputs::spare_files_of(const DeckResult& result) {
    if (std::none_of(all_.begin(), all_.end(), [](const One& one) { return one.replaces.has_value(); }))
        return;
    for (const std::string& file : result.info.files)
        if (const auto identity = identity_of(file))
            for (const One& one : all_)
                if (one.replaces == identity)
                    one.sink->fail({"results would take the place of a file that is read", one.file, 0, 0,
                                    "give --output another file"});
}

void Outputs::deck(const DeckResult& result) {
    spare_files_of(result);
    for (const One& one : all_)
        if (!one.sink->failed()) one.writer->deck(result);
}

void Outputs::end(const Summary& summary) {
    for (const One& one : all_)
        if (!one.sink->failed()) one.writer->end(summary);
}

void Outputs::flush_standard_output() {
    for (const One& one : all_)
        if (one.standard_output) one.sink->flush();
}

bool Outputs::failed() const {
    return std::all_of(all_.begin(), all_.end(), [](const One& one) { return one.sink->failed(); });
}

int Outputs::finish() {
    int status = exit_clean;
    for (const One& one : all_)
        status = std::max(status, drawbead::finish(*one.sink));
    return status;
}

bool holds_changes(Format format) {
    return format == Format::json || format == Format::jsonl || format == Format::sarif;
}

std::vector<RuleInfo> rule_catalogue() {
    std::vector<RuleInfo> rules;
    for (const Rule& rule : registry())
        rules.push_back(rule.info);
    return rules;
}

std::optional<Severity> least_failing(FailOn fail_on) {
    switch (fail_on) {
    case FailOn::error:
        return Severity::error;
    case FailOn::warning:
        return Severity::warning;
    case FailOn::info:
        return Severity::info;
    case FailOn::never:
        break;
    }
    return std::nullopt;
}

int exit_status_of(const Summary& summary, bool failing, int signal) {
    if (signal) return 128 + signal;
    if (summary.interrupted || summary.failed > 0) return exit_failed;
    return failing ? exit_findings : exit_clean;
}

} // namespace drawbead
