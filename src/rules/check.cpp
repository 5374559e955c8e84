#include "rules/check.h"

#include "base/parallel.h"
#include "rules/analysis.h"
#include "rules/planned_changes.h"
#include "rules/text.h"
#include "scene/starter.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <tuple>
#include <unordered_map>

namespace drawbead {

namespace {

/// How closely an entry of a selection names a rule: 0 not at all, 1 "ALL", 2 its family, 3 its code or name.
int closeness(std::string_view entry, const RuleInfo& info) {
    if (entry == info.code || entry == info.name) return 3;
    if (entry == info.family()) return 2;
    return entry == "ALL" ? 1 : 0;
}

int closest(const std::vector<std::string>& entries, const RuleInfo& info) {
    int best = 0;
    for (const std::string& entry : entries)
        best = std::max(best, closeness(entry, info));
    return best;
}

/// What the user wants instead of the rule's own severity.
std::optional<Severity> wanted_severity(const std::map<std::string, Severity>& all, const RuleInfo& info) {
    std::optional<Severity> wanted;
    int best = 0;
    for (const auto& [word, severity] : all)
        if (const int close = closeness(word, info); close > best) best = close, wanted = severity;
    return wanted;
}

/// A finding with what it is sorted by: the order in which files are read, then where it stands.
struct Sorted {
    uint32_t file;
    uint64_t line;
    uint32_t column;
    Finding finding;
    bool suppressed = false;

    auto key() const { return std::tie(file, line, column, finding.code, finding.message); }
};

/// The finding that a draft becomes.
Sorted finding_of(const Deck& deck, const Rule& rule, const Draft& draft) {
    constexpr std::size_t most_places = 100;
    const RuleInfo& info = rule.info;
    Finding f;
    f.code = info.code;
    f.name = info.name;
    f.severity = draft.severity.value_or(info.severity);
    f.message = draft.message;
    f.interface_id = draft.interface_id;
    f.places.push_back(resolve(deck, draft.primary));
    for (const Span& span : draft.related) {
        if (f.places.size() == most_places) break;
        f.places.push_back(resolve(deck, span));
    }
    f.place_count = std::max<uint64_t>(draft.place_count, 1 + draft.related.size());
    f.entities = draft.entities;
    f.measured = draft.measured;
    f.notes = draft.notes;
    f.help = draft.help;
    if (rule.fix) f.fixes = draft.fixes;
    f.fingerprint = fingerprint(f.code, f.interface_id, f.entities, draft.discriminator);
    const ResolvedPlace& first = f.places.front();
    return {index(draft.primary.file), first.line, first.column, std::move(f)};
}

class Collector final : public FindingSink {
public:
    void add(Draft draft) override { drafts.push_back(std::move(draft)); }

    std::vector<Draft> drafts;
};

/// Adds the time since the last call to a sum.
class Laps {
public:
    void add_to(std::atomic<uint64_t>& sum) {
        const Clock::time_point now = Clock::now();
        sum += static_cast<uint64_t>(std::chrono::nanoseconds(now - last_).count());
        last_ = now;
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

double polyline_length(const Model& model, const NodeGroup& group) {
    double length = 0;
    for (std::size_t i = 1; i < group.nodes.size(); ++i) {
        const Vec3 a = model.nodes()[group.nodes[i - 1]], b = model.nodes()[group.nodes[i]];
        length +=
            std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y) + (b.z - a.z) * (b.z - a.z));
    }
    return length;
}

DeckInfo describe(const Deck& deck, const Model& model) {
    DeckInfo info;
    info.version = deck.root().version;
    info.run_name = deck.run_name();
    info.mass_unit = deck.work_units().mass_name;
    info.length_unit = deck.work_units().length_name;
    info.time_unit = deck.work_units().time_name;
    info.input_mass_unit = deck.root().input.mass_name;
    info.input_length_unit = deck.root().input.length_name;
    info.input_time_unit = deck.root().input.time_name;
    for (const auto& file : deck.files()) {
        info.files.push_back(file->path());
        info.bytes += file->bytes().size();
    }
    const Counts& counts = model.counts();
    info.nodes = counts.nodes;
    info.shells4 = counts.shells4;
    info.shells3 = counts.shells3;
    info.solids = counts.solids;
    info.parts = counts.parts;

    std::unordered_map<std::string_view, uint64_t> keywords;
    for (const Block& block : deck.blocks())
        ++keywords[block.keyword];
    for (const auto& [keyword, count] : keywords)
        info.keywords["/" + printable(keyword)] += count;

    const bool positions = model.nodes().x.size() == model.nodes().size();
    for (const Drawbead& bead : model.drawbeads()) {
        InterfaceSummary summary;
        summary.id = bead.id;
        summary.title = printable(bead.title);
        if (bead.group) {
            const NodeGroup& group = model.groups()[*bead.group];
            summary.nodes = group.nodes.size();
            if (positions) summary.length = polyline_length(model, group);
        }
        if (bead.surface) summary.segments = model.surfaces()[*bead.surface].segments.size();
        info.interfaces.push_back(std::move(summary));
    }
    return info;
}

/// An error at the first target of a scene that the deck does not have.
Result<void> targets_exist(const SceneMotion& scene, const Model& model) {
    const auto& held = model.motion().target_nodes;
    for (std::size_t i = 0; i < held.size(); ++i)
        if (!held[i])
            return Error{std::to_string(scene.targets[i].id) + " does not exist in the deck", scene.path,
                         scene.places[i].line, scene.places[i].column, ""};
    return {};
}

} // namespace

ResolvedPlace resolve(const Deck& deck, const Span& span) {
    constexpr std::size_t longest_snippet = 160;
    const SourceFile& file = deck.file(span.file);
    ResolvedPlace place;
    place.file = file.path();
    const uint64_t begin = std::min<uint64_t>(span.begin, file.bytes().size());
    const SourceFile::Position at = file.at(begin);
    const std::string_view line = file.line_at(begin);
    place.line = at.line;
    place.column = at.column;
    // The end stays on the first line; an empty place is shown as one column wide.
    const uint64_t past_line = uint64_t{line.size()} + 1;
    const uint64_t end = std::min<uint64_t>(at.column + (span.end > begin ? span.end - begin : 0), past_line);
    place.end_column = std::max(static_cast<uint32_t>(end), at.column + 1);
    place.snippet = printable(line.substr(0, longest_snippet));
    const auto characters = [&](uint32_t column) {
        const std::string_view before = line.substr(0, column - 1);
        return static_cast<uint32_t>(column - before.size() + character_count(before));
    };
    if (const uint32_t column = characters(place.column); column != place.column)
        place.character_column = column;
    if (const uint32_t column = characters(place.end_column); column != place.end_column)
        place.end_character_column = column;
    return place;
}

DeckResult unreadable_deck(const std::string& path, const Error& error) {
    DeckResult result;
    result.path = path;
    result.failure = error.message.empty() ? "cannot be read" : error.message;
    result.failure_place = {error.path.empty() ? path : error.path, error.line, error.column, error.column,
                            ""};
    result.failure_help = error.help;
    return result;
}

bool Selection::operator()(const RuleInfo& info) const {
    const int wanted = select.empty() ? 1 : closest(select, info);
    return wanted > 0 && closest(ignore, info) < wanted;
}

std::optional<std::string> Selection::unknown() const {
    for (const auto* entries : {&select, &ignore})
        for (const std::string& entry : *entries) {
            const auto rules = registry();
            const bool known = std::any_of(rules.begin(), rules.end(),
                                           [&](const Rule& r) { return closeness(entry, r.info) > 0; });
            if (!known) return entry;
        }
    return std::nullopt;
}

Result<std::unique_ptr<CheckedDeck>>
read_and_check(const std::string& path, FileReader& reader, const ReadOptions& read_options,
               std::span<const Rule* const> rules, const Limits& limits, Needs more, unsigned threads,
               const std::optional<SceneMotion>& scene, CheckTimes* times) {
    CheckTimes untold(times ? 0 : registry().size());
    CheckTimes& spent = times ? *times : untold;
    Laps laps;
    Result<Deck> read = Deck::read(path, reader, read_options);
    if (!read) return read.error();
    Needs needs = Needs::counts | more;
    for (const Rule* rule : rules)
        needs = needs | rule->needs;
    auto checked = std::make_unique<CheckedDeck>();
    checked->deck = std::make_unique<Deck>(std::move(*read));
    RunFacts run;
    if (has(needs, analysis_run)) run.engine = read_engine_deck(path, reader);
    if (scene) {
        run.prescribed = scene->prescribed;
        run.scene_end = scene->end;
    }
    laps.add_to(spent.reading);
    checked->model = scene && !scene->prescribed.by_deck
                         ? Model::build(*checked->deck, needs, threads, scene->targets)
                         : Model::build(*checked->deck, needs, threads);
    if (scene && !scene->prescribed.by_deck)
        if (auto all = targets_exist(*scene, checked->model); !all) return all.error();
    laps.add_to(spent.model);
    checked->limits = limits;
    checked->analysis = analyse(*checked->deck, checked->model, limits, needs, threads, std::move(run));
    laps.add_to(spent.analysis);

    // Suppressions are judged by what all other rules have found.
    const auto judges = [&](std::size_t i) { return rules[i]->info.family() == "SUP"; };
    checked->suppressions = read_suppressions(*checked->deck, checked->model);
    std::vector<Collector> by_rule(rules.size());
    parallel_for(threads, rules.size(), [&](std::size_t i) {
        if (judges(i)) return;
        Laps mine;
        rules[i]->check(checked->context(), by_rule[i]);
        mine.add_to(spent.by_rule[static_cast<std::size_t>(rules[i] - registry().data())]);
    });
    std::vector<std::vector<bool>> suppressed(rules.size());
    for (std::size_t i = 0; i < rules.size(); ++i)
        for (const Draft& draft : by_rule[i].drafts)
            suppressed[i].push_back(is_suppressed(checked->suppressions, *rules[i], draft));
    judge_suppressions(checked->suppressions, rules);
    for (std::size_t i = 0; i < rules.size(); ++i) {
        if (judges(i)) rules[i]->check(checked->context(), by_rule[i]);
        for (std::size_t k = 0; k < by_rule[i].drafts.size(); ++k)
            checked->drafts.push_back(
                {rules[i], std::move(by_rule[i].drafts[k]), !judges(i) && suppressed[i][k]});
    }
    return checked;
}

DeckResult result_of(const CheckedDeck& checked, const std::map<std::string, Severity>& severity,
                     bool with_changes) {
    const Deck& deck = *checked.deck;
    const Model& model = checked.model;
    const Analysis& analysis = checked.analysis;
    std::vector<Sorted> all;
    std::optional<ChangePlanner> planner;
    for (const RuleDraft& one : checked.drafts) {
        all.push_back(finding_of(deck, *one.rule, one.draft));
        all.back().suppressed = one.suppressed;
        if (const auto wanted = wanted_severity(severity, one.rule->info))
            all.back().finding.severity = *wanted;
        std::vector<FixOffer>& offers = all.back().finding.fixes;
        if (!with_changes || offers.empty() || one.suppressed) continue;
        if (!planner) planner.emplace(checked);
        planner->add_changes(one, offers);
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Sorted& a, const Sorted& b) { return a.key() < b.key(); });
    // A file that is included twice says the same thing at the same place twice.
    all.erase(std::unique(all.begin(), all.end(),
                          [](const Sorted& a, const Sorted& b) {
                              return a.finding.code == b.finding.code && a.line == b.line &&
                                     a.column == b.column && a.finding.message == b.finding.message &&
                                     a.finding.places.front().file == b.finding.places.front().file;
                          }),
              all.end());

    DeckResult result;
    result.path = deck.path();
    result.info = describe(deck, model);
    if (!analysis.starter.empty()) result.starter = starter_messages(model, analysis.starter);
    for (Sorted& one : all) {
        if (one.suppressed)
            ++result.suppressed;
        else
            result.findings.push_back(std::move(one.finding));
    }
    return result;
}

DeckResult check_deck(const std::string& path, FileReader& reader, const ReadOptions& read_options,
                      const CheckOptions& options) {
    std::vector<const Rule*> rules;
    for (const Rule& rule : registry())
        if (options.selection(rule.info)) rules.push_back(&rule);
    Needs more = Needs::none;
    if (options.with_changes)
        for (const Rule* rule : rules)
            more = more | rule->fix_needs;
    const auto checked = read_and_check(path, reader, read_options, rules, options.limits, more,
                                        options.threads, options.scene, options.times);
    return checked ? result_of(**checked, options.severity, options.with_changes)
                   : unreadable_deck(path, checked.error());
}

DeckResult describe_deck(const std::string& path, FileReader& reader, const ReadOptions& options) {
    const Result<Deck> read = Deck::read(path, reader, options);
    if (!read) return unreadable_deck(path, read.error());
    DeckResult result;
    result.path = path;
    result.info =
        describe(*read, Model::build(*read, Needs::counts | Needs::coordinates | Needs::blank_elements,
                                     options.threads));
    return result;
}

} // namespace drawbead
