#include "rules/check.h"

#include "base/parallel.h"
#include "cli/commands.h"
#include "cli/deck_settings.h"
#include "cli/interrupt.h"
#include "cli/outputs.h"
#include "cli/paths.h"
#include "cli/reading.h"
#include "cli/scene_times.h"
#include "cli/selection.h"
#include "config/baseline.h"
#include "report/table.h"
#include "report/writer.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <malloc.h>
#include <map>
#include <mutex>
#include <new>
#include <optional>

namespace drawbead {

namespace {

/// Decks that may be finished ahead of one that is still being checked: results wait in memory.
constexpr std::size_t finished_ahead = 64;

DeckResult check_one(const DeckPath& deck, const ReadArguments& reading, const Settings& settings,
                     CheckOptions options) {
    if (deck.failed()) return failed_deck(deck.path, deck.failure, deck.help);
    try {
        const Result<DeckSource> source = deck_source(deck.path, reading);
        if (!source) return failed_deck(deck.path, source.error().message);
        ReadOptions how = read_options(reading, options.threads);
        how.include_path = settings.include_path.value;
        options.selection = settings.selection();
        options.limits = settings.rule_limits();
        options.severity = settings.severities();
        return check_deck(source->name, *source->reader, how, options);
    } catch (const std::bad_alloc&) {
        return failed_deck(deck.path, "out of memory", "check fewer decks at a time with -j");
    }
}

/// What the rules take of a scene.
SceneMotion scene_motion(const Scene& scene, double end) {
    SceneMotion out;
    out.prescribed = prescribed_by(scene);
    out.targets = targets_of(scene);
    out.end = end;
    out.path = scene.path;
    for (const SceneMove& move : scene.moves)
        out.places.push_back({move.place.line, move.place.column});
    return out;
}

/// Takes results in any order and passes them on in deck order; one that is not there is passed on, too.
/// Whoever is too far ahead waits, so that memory stays flat however long one deck takes.
class InOrder {
public:
    explicit InOrder(std::function<void(std::optional<DeckResult>)> sink) : sink_(std::move(sink)) {}

    void wait_for_turn(std::size_t index) {
        std::unique_lock lock(mutex_);
        turn_.wait(lock, [&] { return index < next_ + finished_ahead; });
    }
    void add(std::size_t index, std::optional<DeckResult> result) {
        const std::lock_guard lock(mutex_);
        waiting_.emplace(index, std::move(result));
        for (auto it = waiting_.begin(); it != waiting_.end() && it->first == next_;
             it = waiting_.erase(it), ++next_)
            sink_(std::move(it->second));
        turn_.notify_all();
    }

private:
    std::function<void(std::optional<DeckResult>)> sink_;
    std::mutex mutex_;
    std::condition_variable turn_;
    std::map<std::size_t, std::optional<DeckResult>> waiting_;
    std::size_t next_ = 0;
};

/// A batch takes and gives back the same memory for every deck: it stays with the process in between, since
/// to get it from the system again costs more than to read a small deck.
void keep_memory() {
#ifdef __GLIBC__
    constexpr int kept = 64 << 20, mapped_from = 16 << 20;
    ::mallopt(M_TRIM_THRESHOLD, kept);
    ::mallopt(M_MMAP_THRESHOLD, mapped_from);
#endif
}

/// Every `of`th deck.
std::vector<DeckPath> part_of(std::vector<DeckPath> decks, const Shard& shard) {
    std::vector<DeckPath> part;
    for (std::size_t i = shard.number - 1; i < decks.size(); i += shard.of)
        part.push_back(std::move(decks[i]));
    return part;
}

/// What each rule found, for --statistics.
class Statistics {
public:
    Statistics() : times(registry().size()) {}

    void count(const DeckResult& deck) {
        ++decks_;
        bytes_ += deck.info.bytes;
        for (const Finding& finding : deck.findings)
            ++findings_[finding.code];
    }

    void say() const {
        std::vector<std::vector<std::string>> rows{{"rule", "name", "findings", "ms"}};
        const auto rules = registry();
        for (std::size_t i = 0; i < rules.size(); ++i) {
            const RuleInfo& info = rules[i].info;
            const auto found = findings_.find(info.code);
            rows.push_back({std::string(info.code), std::string(info.name),
                            std::to_string(found == findings_.end() ? 0 : found->second),
                            milliseconds(times.by_rule[i])});
        }
        std::sort(rows.begin() + 1, rows.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
        rows.push_back({"", "reading decks", "", milliseconds(times.reading)});
        rows.push_back({"", "building models", "", milliseconds(times.model)});
        rows.push_back({"", "analysis for several rules", "", milliseconds(times.analysis)});
        drawbead::say("\nwhere the time went, summed over threads");
        std::string table = text_table(rows, {2, 3});
        if (!table.empty()) table.pop_back();
        drawbead::say(table);
        drawbead::say("decks: " + std::to_string(decks_) + ", bytes: " + std::to_string(bytes_));
    }

    CheckTimes times;

private:
    static std::string milliseconds(uint64_t nanoseconds) {
        const uint64_t hundredths = (nanoseconds + 5000) / 10000;
        const std::string rest = std::to_string(hundredths % 100);
        return std::to_string(hundredths / 100) + (rest.size() == 1 ? ".0" : ".") + rest;
    }

    uint64_t decks_ = 0, bytes_ = 0;
    std::map<std::string, uint64_t, std::less<>> findings_;
};

} // namespace

int run(const CheckCommand& command) {
    const auto start = std::chrono::steady_clock::now();
    note_interrupts();
    std::vector<DeckPath> decks;
    std::optional<SceneMotion> scene;
    if (command.scene.empty()) {
        decks = find_decks(command.paths);
    } else {
        Result<Scene> read = read_scene(command.scene);
        const Result<SceneTimes> times = read ? times_of(*read) : read.error();
        if (!times) {
            say_error(times.error());
            return exit_failed;
        }
        decks = find_decks({read->deck});
        scene = scene_motion(*read, times->time.back());
    }
    const std::vector<RuleInfo> rules = rule_catalogue();
    WriterOptions options;
    options.tool_version = tool_version();
    options.rules = rules;
    if (command.fail_on_given) options.fail_on = least_failing(command.fail_on);
    if (command.shard) {
        options.shard = Shard{command.shard->number, command.shard->of};
        decks = part_of(std::move(decks), *options.shard);
    }
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
    std::vector<std::string> inputs = settings->files();
    for (const std::string& file : {command.scene, command.baseline})
        if (!file.empty()) inputs.push_back(file);
    for (const DeckPath& deck : decks)
        inputs.push_back(deck.path);
    Result<std::unique_ptr<Outputs>> opened =
        Outputs::open(command.outputs, command.output.colour, options, inputs, command.write_baseline);
    if (!opened) {
        say_error(opened.error());
        return exit_failed;
    }
    Outputs& outputs = **opened;

    // Several decks are checked side by side; threads that are left over help within each.
    const unsigned threads = thread_count(command.reading);
    const unsigned side_by_side = static_cast<unsigned>(std::clamp<std::size_t>(decks.size(), 1, threads));
    const unsigned within = std::max(1u, threads / side_by_side);
    const bool changes = std::any_of(command.outputs.begin(), command.outputs.end(),
                                     [](const OutputTarget& one) { return holds_changes(one.format); });
    Statistics statistics;
    CheckOptions checking; // and for each deck what its settings say
    checking.threads = within;
    checking.with_changes = changes;
    checking.times = command.statistics ? &statistics.times : nullptr;
    checking.scene = std::move(scene);

    if (decks.size() > 1) keep_memory();

    Progress progress(!command.output.quiet, decks.size());
    Summary summary;
    summary.asked = decks.size();
    bool failing = false;
    std::size_t taken = 0;
    std::atomic<bool> stop = false;
    InOrder results([&](std::optional<DeckResult> result) {
        // What is written is the first decks, without a hole.
        if (!result) stop = true;
        if (stop) return;
        const std::size_t index = taken++;
        const Settings holds = settings->of(index);
        statistics.count(*result);
        known->take(*result, holds.selection());
        result->fail_on = least_failing(fail_on_from(settings->of_files(index).fail_on.value));
        std::vector<DeckResult> one;
        one.push_back(std::move(*result));
        const DeckResult& deck = one.front();
        const Summary of_deck = summarise(one);
        failing = failing || fails(of_deck, options.least_failing(deck));
        add(summary, of_deck);
        if (deck.failed() || (outputs.on_terminal() && !deck.findings.empty())) progress.clear();
        outputs.deck(deck);
        if (deck.failed() || outputs.on_terminal()) outputs.flush_standard_output();
        if (deck.failed()) say_failure(deck);
        if (outputs.failed()) stop = true;
        progress.show(summary.decks, deck.path);
    });
    parallel_for(side_by_side, decks.size(), [&](std::size_t i) {
        results.wait_for_turn(i);
        std::optional<DeckResult> result;
        if (!stop && interrupt_signal() == 0)
            result = check_one(decks[i], command.reading, settings->of(i), checking);
        // Half of what was to come from standard input is no deck.
        if (decks[i].path == "-" && interrupt_signal() != 0) result.reset();
        results.add(i, std::move(result));
    });
    progress.clear();
    const int signal = summary.decks < summary.asked ? interrupt_signal() : 0;
    summary.interrupted = signal != 0;
    summary.exit_status = exit_status_of(summary, failing, signal);
    outputs.end(summary);

    if (const int status = outputs.finish(); status != exit_clean) return status;
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    summary.seconds = time.count();
    if (!command.output.quiet || summary.interrupted) say(summary_sentence(summary));
    if (command.statistics) statistics.say();
    // What was not looked at is neither gone nor known.
    if (!summary.interrupted)
        if (const int status = known->finish(command.output.quiet); status != exit_clean) return status;
    return summary.exit_status;
}

} // namespace drawbead
