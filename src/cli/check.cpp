#include "rules/check.h"

#include "base/parallel.h"
#include "cli/commands.h"
#include "cli/deck_settings.h"
#include "cli/paths.h"
#include "cli/reading.h"
#include "cli/selection.h"
#include "config/baseline.h"
#include "report/writer.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <new>
#include <unistd.h>

namespace drawbead {

namespace {

/// Decks that may be finished ahead of one that is still being checked: results wait in memory.
constexpr std::size_t finished_ahead = 64;

DeckResult check_one(const DeckPath& deck, const CheckCommand& command, const Settings& settings,
                     unsigned threads) {
    if (deck.failed()) return failed_deck(deck.path, deck.failure, deck.help);
    try {
        const Result<DeckSource> source = deck_source(deck.path, command.reading);
        if (!source) return failed_deck(deck.path, source.error().message);
        ReadOptions reading = read_options(command.reading, threads);
        reading.include_path = settings.include_path.value;
        CheckOptions options{settings.selection(), threads};
        options.limits = settings.rule_limits();
        options.severity = settings.severities();
        return check_deck(source->name, *source->reader, reading, options);
    } catch (const std::bad_alloc&) {
        return failed_deck(deck.path, "out of memory", "check fewer decks at a time with -j");
    }
}

/// Takes results in any order and passes them on in deck order. Whoever is too far ahead waits, so that
/// memory stays flat however long one deck takes.
class InOrder {
public:
    explicit InOrder(std::function<void(DeckResult)> sink) : sink_(std::move(sink)) {}

    void wait_for_turn(std::size_t index) {
        std::unique_lock lock(mutex_);
        turn_.wait(lock, [&] { return index < next_ + finished_ahead; });
    }
    void add(std::size_t index, DeckResult result) {
        const std::lock_guard lock(mutex_);
        waiting_.emplace(index, std::move(result));
        for (auto it = waiting_.begin(); it != waiting_.end() && it->first == next_;
             it = waiting_.erase(it), ++next_)
            sink_(std::move(it->second));
        turn_.notify_all();
    }

private:
    std::function<void(DeckResult)> sink_;
    std::mutex mutex_;
    std::condition_variable turn_;
    std::map<std::size_t, DeckResult> waiting_;
    std::size_t next_ = 0;
};

std::unique_ptr<ReportWriter> make_writer(const CheckCommand& command, OutputSink& out) {
    const bool colour = command.output.file.empty() ? wants_colour(command.output.colour, STDOUT_FILENO)
                                                    : command.output.colour == ColourMode::always;
    switch (command.format) {
    case Format::full:
        return full_writer(out, colour);
    case Format::concise:
        return concise_writer(out, colour);
    case Format::json:
        break;
    }
    return json_writer(out, tool_version());
}

} // namespace

int run(const CheckCommand& command) {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<DeckPath> decks = find_decks(command.paths);
    const Result<DeckSettings> settings =
        DeckSettings::of(decks, command.config, command.reading,
                         {command.select, command.ignore, command.fail_on_given, command.fail_on});
    if (!settings) {
        say_error(settings.error());
        return exit_failed;
    }
    if (command.config.show) return settings->show(decks);
    Result<KnownFindings> known = KnownFindings::of(command.baseline, command.write_baseline);
    if (!known) {
        say_error(known.error());
        return exit_failed;
    }
    std::unique_ptr<FileSink> out = std::make_unique<FileSink>(STDOUT_FILENO, "standard output");
    if (!command.output.file.empty()) {
        Result<std::unique_ptr<FileSink>> file = FileSink::replace(command.output.file);
        if (!file) {
            say_error(file.error());
            return exit_failed;
        }
        out = std::move(*file);
    }

    // Several decks are checked side by side; threads that are left over help within each.
    const unsigned threads = thread_count(command.reading);
    const unsigned side_by_side = static_cast<unsigned>(std::clamp<std::size_t>(decks.size(), 1, threads));
    const unsigned within = std::max(1u, threads / side_by_side);

    const std::unique_ptr<ReportWriter> writer = make_writer(command, *out);
    const bool on_terminal = command.output.file.empty() && ::isatty(STDOUT_FILENO) == 1;
    Progress progress(!command.output.quiet, decks.size());
    Summary summary;
    bool failing = false;
    std::size_t taken = 0;
    std::atomic<bool> stop = false;
    InOrder results([&](DeckResult result) {
        if (stop) return;
        const Settings holds = settings->of(taken++);
        known->take(result, holds.selection());
        std::vector<DeckResult> one;
        one.push_back(std::move(result));
        const DeckResult& deck = one.front();
        const Summary of_deck = summarise(one);
        failing = failing || fails(of_deck, fail_on_from(holds.fail_on.value));
        add(summary, of_deck);
        if (deck.failed() || (on_terminal && !deck.findings.empty())) progress.clear();
        writer->deck(deck);
        if (deck.failed() || on_terminal) out->flush();
        if (deck.failed()) say_failure(deck);
        if (out->failed()) stop = true;
        progress.show(summary.decks, deck.path);
    });
    parallel_for(side_by_side, decks.size(), [&](std::size_t i) {
        results.wait_for_turn(i);
        results.add(i, stop ? DeckResult{} : check_one(decks[i], command, settings->of(i), within));
    });
    writer->end(summary);
    progress.clear();

    if (const int status = finish(*out); status != exit_clean) return status;
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    summary.seconds = time.count();
    if (!command.output.quiet) say(summary_sentence(summary));
    if (const int status = known->finish(command.output.quiet); status != exit_clean) return status;
    if (summary.failed > 0) return exit_failed;
    return failing ? exit_findings : exit_clean;
}

} // namespace drawbead
