#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/report_reader.h"
#include "cli/selection.h"

#include <algorithm>

namespace drawbead {

namespace {

/// All reports, shards by number; or why they are not the parts of one run.
Result<std::vector<ReadReport>> read_all(const std::vector<std::string>& paths) {
    std::vector<ReadReport> all;
    for (const std::string& path : paths) {
        Result<ReadReport> report = read_report(path);
        if (!report) return report.error();
        all.push_back(std::move(*report));
    }
    const ReadReport& first = all.front();
    for (const ReadReport& one : all) {
        if (one.tool_version != first.tool_version)
            return Error{"written by drawbead " + one.tool_version + ", but '" + first.path + "' by " +
                             first.tool_version,
                         one.path, 0, 0, "merge reports of one version"};
        if (one.shard.has_value() != first.shard.has_value() ||
            (one.shard && one.shard->of != first.shard->of))
            return Error{"not a part of the same run as '" + first.path + "'", one.path, 0, 0,
                         "merge all shards of one run, or whole runs"};
    }
    if (!first.shard) return all;
    std::stable_sort(all.begin(), all.end(), [](const ReadReport& a, const ReadReport& b) {
        return a.shard->number < b.shard->number;
    });
    const uint64_t of = all.front().shard->of;
    std::string missing;
    uint64_t expected = 1;
    for (const ReadReport& one : all) {
        if (one.shard->number < expected)
            return Error{"shard " + std::to_string(one.shard->number) + " of " + std::to_string(of) +
                             " is given twice",
                         one.path, 0, 0, ""};
        for (; expected < one.shard->number; ++expected)
            missing += (missing.empty() ? "" : ", ") + std::to_string(expected);
        ++expected;
    }
    for (; expected <= of; ++expected)
        missing += (missing.empty() ? "" : ", ") + std::to_string(expected);
    if (!missing.empty())
        return Error{"of " + std::to_string(of) + " shards, these are missing: " + missing, "", 0, 0,
                     "give the reports of all of them"};
    return all;
}

/// In the order of the whole run: a shard has every `of`th deck of it.
std::vector<const DeckResult*> in_order(const std::vector<ReadReport>& reports) {
    std::vector<const DeckResult*> decks;
    if (!reports.front().shard) {
        for (const ReadReport& report : reports)
            for (const DeckResult& deck : report.decks)
                decks.push_back(&deck);
        return decks;
    }
    std::size_t longest = 0;
    for (const ReadReport& report : reports)
        longest = std::max(longest, report.decks.size());
    for (std::size_t i = 0; i < longest; ++i)
        for (const ReadReport& report : reports)
            if (i < report.decks.size()) decks.push_back(&report.decks[i]);
    return decks;
}

} // namespace

int run(const MergeCommand& command) {
    const Result<std::vector<ReadReport>> reports = read_all(command.reports);
    if (!reports) {
        say_error(reports.error());
        return exit_failed;
    }
    const std::vector<RuleInfo> rules = rule_catalogue();
    WriterOptions options;
    options.tool_version = reports->front().tool_version;
    options.rules = rules;
    if (command.fail_on) options.fail_on = least_failing(*command.fail_on);
    Result<std::unique_ptr<Outputs>> outputs =
        Outputs::open(command.outputs, command.output.colour, options, command.reports);
    if (!outputs) {
        say_error(outputs.error());
        return exit_failed;
    }
    Summary summary;
    bool failing = false;
    for (const ReadReport& report : *reports) {
        summary.asked += report.asked;
        summary.interrupted = summary.interrupted || report.interrupted;
    }
    for (const DeckResult* deck : in_order(*reports)) {
        std::vector<DeckResult> one;
        one.push_back(*deck);
        const Summary of_deck = summarise(one);
        failing = failing || fails(of_deck, options.least_failing(*deck));
        add(summary, of_deck);
        (*outputs)->deck(*deck);
    }
    summary.exit_status = exit_status_of(summary, failing, 0);
    (*outputs)->end(summary);
    if (const int status = (*outputs)->finish(); status != exit_clean) return status;
    if (!command.output.quiet) say(counts_sentence(summary));
    return summary.exit_status;
}

} // namespace drawbead
