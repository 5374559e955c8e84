#include "rules/fix.h"

#include "rules/planned_changes.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace drawbead {

namespace {

constexpr std::array<std::string_view, 10> family_order{"SYN", "REF", "LIN", "SRF", "PAR",
                                                        "STB", "KIN", "CTX", "ENG", "SUP"};

std::size_t stage_of(const RuleInfo& info) {
    const auto at = std::find(family_order.begin(), family_order.end(), info.family());
    return static_cast<std::size_t>(at - family_order.begin());
}

/// What a finding is about, whatever its numbers are.
struct Subject {
    std::string code;
    InterfaceId interface_id = 0;
    SurfaceId surface_id = 0;
    std::string discriminator;
    friend auto operator<=>(const Subject&, const Subject&) = default;
};
Subject subject_of(const RuleDraft& one) {
    return {std::string(one.rule->info.code), one.draft.interface_id.value_or(0),
            one.draft.surface_id.value_or(0), one.draft.discriminator};
}

Severity severity_of(const RuleDraft& one) {
    return one.draft.severity.value_or(one.rule->info.severity);
}

/// The files of a deck as they would be after some edits; all others as they were read.
class EditedReader final : public FileReader {
public:
    using Text = std::shared_ptr<const Buffer<char>>;

    EditedReader(FileReader& disk, const Deck& deck, const EditList& edits, unsigned threads) : disk_(disk) {
        for (const auto& file : deck.files()) {
            const auto id = FileId{static_cast<uint32_t>(texts_.size())};
            const EditList mine = of_file(edits, id);
            Text text;
            std::string_view bytes = file->bytes();
            if (!mine.empty()) {
                auto made = std::make_shared<Buffer<char>>(edited_size(bytes, mine));
                write_edited(bytes, mine, made->data(), threads);
                bytes = {made->data(), made->size()};
                text = std::move(made);
            }
            texts_.push_back(std::move(text));
            files_.emplace(disk.identity(file->path()), bytes);
        }
    }

    Result<FileBytes> read(const std::string& path) override {
        const auto known = files_.find(disk_.identity(path));
        return known == files_.end() ? disk_.read(path) : FileBytes::view_of(known->second);
    }
    bool exists(const std::string& path) override { return disk_.exists(path); }
    std::string identity(const std::string& path) override { return disk_.identity(path); }
    bool changed_since_read(const std::string& path) override { return disk_.changed_since_read(path); }

    /// By file; empty for those that are as before.
    const std::vector<Text>& texts() const { return texts_; }

private:
    FileReader& disk_;
    std::map<std::string, std::string_view> files_;
    std::vector<Text> texts_;
};

/// A fix that was planned for one draft.
struct Planned {
    Subject subject;
    AppliedFix fix;
    EditList edits;
    std::vector<std::string_view> uncovers = {}; ///< see Fix

    /// Whether the damage may have hidden an error.
    bool may_uncover(std::string_view code, std::optional<InterfaceId> id) const {
        const auto is_concerned = [&](const InterfaceChange& c) { return c.interface_id == *id; };
        return std::any_of(uncovers.begin(), uncovers.end(),
                           [&](std::string_view kind) { return code.starts_with(kind); }) &&
               (!id || id == fix.interface_id ||
                std::any_of(fix.changes.begin(), fix.changes.end(), is_concerned));
    }
};

/// The deck at the end of a round.
struct State {
    std::shared_ptr<CheckedDeck> checked;
    std::vector<EditedReader::Text> texts; ///< what its files live in; empty: as on the disk
    EditList edits;                        ///< of the files as they were at first
};

/// The errors of a deck, to be compared with those of another one.
class Errors {
public:
    explicit Errors(const CheckedDeck& checked) {
        for (const RuleDraft& one : checked.drafts)
            if (severity_of(one) == Severity::error) {
                known_.emplace(one.rule->info.code, one.draft.interface_id.value_or(0));
                codes_.insert(one.rule->info.code);
            }
        for (const Drawbead& bead : checked.model.drawbeads())
            interfaces_.insert(bead.id);
    }

    /// The first error of `after` that was not there before, nor hidden by what `plan` repairs; empty when
    /// there is none. Those of new interfaces count when no interface had one of the kind.
    std::string first_new(const CheckedDeck& after, const std::vector<Planned>& plan) const {
        for (const RuleDraft& one : after.drafts) {
            if (severity_of(one) != Severity::error) continue;
            const std::string_view code = one.rule->info.code;
            const InterfaceId id = one.draft.interface_id.value_or(0);
            const bool is_new = one.draft.interface_id && interfaces_.count(id) == 0;
            if (is_new ? codes_.count(code) != 0 : known_.count({code, id}) != 0) continue;
            if (std::none_of(plan.begin(), plan.end(),
                             [&](const Planned& p) { return p.may_uncover(code, one.draft.interface_id); }))
                return "it would bring a new error: " + std::string(code) + " " + one.draft.message;
        }
        return {};
    }

private:
    std::set<std::pair<std::string_view, InterfaceId>> known_;
    std::set<std::string_view> codes_;
    std::set<InterfaceId> interfaces_;
};

InterfaceOutcome::State state_of(const CheckedDeck& checked, std::size_t i) {
    InterfaceOutcome::State state;
    const BeadAnalysis& a = checked.analysis.beads[i];
    state.nodes = a.group ? a.group->nodes.size() : 0;
    state.fn = a.fn_total;
    state.ft = a.ft_total;
    const UnitSystem& units = checked.deck->work_units();
    if (i < checked.analysis.contact.interfaces.size() &&
        checked.analysis.contact.interfaces[i].unknown.empty()) {
        const SlopeChoice& slope = checked.analysis.contact.interfaces[i].contact.slope;
        constexpr Dimension slope_dimension{1, -1, -2};
        switch (slope.kind) {
        case Slope::none:
            state.slope = "none";
            break;
        case Slope::ramp:
            state.slope = quantity(slope.ramp, units, slope_dimension, 6);
            break;
        case Slope::reset:
            state.slope = "reset to the blank's stiffness";
            break;
        case Slope::depth_absent:
            state.slope = "the blank's stiffness";
            break;
        }
    }
    return state;
}

/// All interfaces before and after, in deck order, new ones last.
class Interfaces {
public:
    void take(const CheckedDeck& checked, const DeckResult& result, bool after) {
        const auto& beads = checked.model.drawbeads();
        for (std::size_t i = 0; i < beads.size(); ++i) {
            const auto [at, added] = place_.emplace(beads[i].id, all_.size());
            if (added) {
                all_.emplace_back();
                all_.back().id = beads[i].id;
                all_.back().title = printable(beads[i].title);
            }
            InterfaceOutcome::State state = state_of(checked, i);
            if (result.starter)
                for (const StarterMessages::Interface& one : result.starter->interfaces)
                    if (one.id == beads[i].id) state.messages = one.messages;
            (after ? all_[at->second].after : all_[at->second].before) = std::move(state);
        }
    }

    std::vector<InterfaceOutcome> changed(const std::vector<AppliedFix>& applied) {
        for (const AppliedFix& fix : applied)
            for (const InterfaceChange& change : fix.changes)
                if (const auto at = place_.find(change.interface_id); at != place_.end()) {
                    all_[at->second].segments_turned += change.segments_turned;
                    all_[at->second].nodes_moved += change.nodes_moved;
                }
        std::vector<InterfaceOutcome> out;
        for (InterfaceOutcome& one : all_)
            if (one.changed()) out.push_back(std::move(one));
        return out;
    }

private:
    std::map<InterfaceId, std::size_t> place_;
    std::vector<InterfaceOutcome> all_;
};

class Fixer {
public:
    Fixer(const std::string& path, FileReader& disk, const ReadOptions& reading, const FixOptions& options)
        : path_(path), disk_(disk), reading_(reading), options_(options) {
        for (const Rule& rule : registry()) {
            rules_.push_back(&rule);
            if (rule.fix && (options.with_changes || options.selection(rule.info)))
                needs_ = needs_ | rule.fix_needs;
        }
    }

    FixOutcome run() {
        FixOutcome outcome;
        auto read = read_and_check(path_, disk_, reading_, rules_, options_.limits, needs_, options_.threads);
        if (!read) {
            outcome.before = unreadable_deck(path_, read.error());
            return outcome;
        }
        State state{std::move(*read), {}, {}};
        outcome.original = state.checked;
        outcome.before = said_of(*state.checked, options_.with_changes);
        Interfaces interfaces;
        interfaces.take(*state.checked, outcome.before, false);
        bool alone = false;
        while (outcome.rounds < options_.most_rounds) {
            std::vector<Planned> plan = plan_round(*state.checked, alone, outcome.declined);
            if (plan.empty()) {
                // What did not hold may hold now that other things are repaired.
                if (!std::exchange(dropped_too_early_, false)) break;
                dropped_.clear();
                continue;
            }
            ++outcome.rounds;
            EditList edits;
            for (const Planned& one : plan)
                edits.insert(edits.end(), one.edits.begin(), one.edits.end());
            sort_edits(edits);
            State next;
            const std::string wrong = try_round(state, plan, edits, next);
            if (wrong.empty()) {
                for (Planned& one : plan)
                    outcome.applied.push_back(std::move(one.fix));
                state = std::move(next);
                alone = false;
                dropped_too_early_ = !dropped_.empty();
                continue;
            }
            alone = plan.size() > 1;
            if (!alone) dropped_[plan.front().subject] = wrong;
            if (!read_again(state, outcome)) break;
        }
        outcome.result = state.checked;
        outcome.after = said_of(*state.checked, false);
        take_files(state, outcome);
        interfaces.take(*state.checked, outcome.after, true);
        outcome.force_unit = unit_name(state.checked->deck->work_units(), force_dimension);
        outcome.interfaces = interfaces.changed(outcome.applied);
        state.checked->forget(); // its memory can hold the pages of the files that are written next
        return outcome;
    }

private:
    DeckResult said_of(const CheckedDeck& checked, bool with_changes) const {
        DeckResult result = result_of(checked, options_.severity, with_changes);
        std::erase_if(result.findings, [&](const Finding& finding) {
            const RuleInfo& info = find_rule(finding.code)->info;
            return !options_.counted(info) && !options_.selection(info);
        });
        return result;
    }

    /// The fixes of the next round; `alone`: only one. What cannot be fixed goes to `declined`, which then
    /// describes this round.
    std::vector<Planned> plan_round(const CheckedDeck& checked, bool alone,
                                    std::vector<DeclinedFix>& declined) {
        std::vector<Planned> plan;
        declined.clear();
        std::vector<const RuleDraft*> drafts;
        for (const RuleDraft& one : checked.drafts)
            if (one.rule->fix && !one.suppressed && options_.selection(one.rule->info))
                drafts.push_back(&one);
        if (drafts.empty()) return plan;
        std::stable_sort(drafts.begin(), drafts.end(), [](const RuleDraft* a, const RuleDraft* b) {
            return stage_of(a->rule->info) < stage_of(b->rule->info);
        });
        IssueLog unreported;
        const OptionIndex index(*checked.deck, unreported);
        FreeIds ids(*checked.deck, index, checked.model);
        BlockFinder blocks(*checked.deck);
        std::set<const Block*> claimed;
        EditList accepted;

        std::size_t stage = family_order.size();
        for (const RuleDraft* one : drafts) {
            if (!plan.empty() && (alone || stage_of(one->rule->info) != stage)) break;
            const FreeIds before = ids;
            FixPlanner planner(*checked.deck, index, ids, options_.choices);
            std::optional<Fix> fix = one->rule->fix(checked.context(), one->draft, planner);
            Planned planned{subject_of(*one), {}, {}};
            if (fix) planned.edits = planner.edits();
            DeclinedFix reason = declined_fix(checked, *one);
            if (fix) reason.title = fix->title;
            const auto known_bad = dropped_.find(planned.subject);
            reason.needs_unsafe = fix && fix->applicability == FixAvailability::unsafe &&
                                  !options_.choices.unsafe && !planner.failed();
            if (!fix || planner.failed())
                reason.why = planner.failed() ? planner.failure() : "there is no repair that is no guess";
            else if (reason.needs_unsafe)
                reason.why = "the repair changes the physics or a choice: it needs --unsafe";
            else if (known_bad != dropped_.end())
                reason.why = known_bad->second;
            else if (planned.edits.empty())
                reason.why = "there is nothing to change in the text";
            if (!reason.why.empty()) {
                declined.push_back(std::move(reason));
                ids = before;
                continue;
            }
            std::set<const Block*> mine;
            for (const Edit& e : planned.edits)
                mine.insert(blocks.at(e.at));
            for (const BlockIndex i : planner.claims())
                mine.insert(&checked.deck->blocks()[i]);
            const bool free = std::none_of(mine.begin(), mine.end(),
                                           [&](const Block* b) { return claimed.count(b) != 0; }) &&
                              compatible(accepted, planned.edits);
            if (!free) {
                ids = before;
                continue;
            }
            claimed.insert(mine.begin(), mine.end());
            accepted.insert(accepted.end(), planned.edits.begin(), planned.edits.end());
            sort_edits(accepted);
            stage = stage_of(one->rule->info);
            const RuleInfo& info = one->rule->info;
            planned.fix = {std::string(info.code),
                           std::string(info.name),
                           fix->title,
                           fix->applicability == FixAvailability::safe,
                           one->draft.interface_id,
                           reason.place,
                           one->draft.message,
                           std::move(fix->changes)};
            planned.uncovers = std::move(fix->uncovers);
            plan.push_back(std::move(planned));
        }
        return plan;
    }

    DeclinedFix declined_fix(const CheckedDeck& checked, const RuleDraft& one) const {
        return {std::string(one.rule->info.code),
                std::string(one.rule->info.name),
                {},
                one.draft.interface_id,
                resolve(*checked.deck, one.draft.primary),
                {},
                false};
    }

    /// What is wrong with the result; empty when the round may stay, `next` is then the deck after it.
    std::string try_round(const State& state, const std::vector<Planned>& plan, const EditList& edits,
                          State& next) {
        // What is asked of the deck before, then its memory goes to the deck after.
        CheckedDeck& before = *state.checked;
        const Errors errors(before);
        std::map<Subject, std::ptrdiff_t> left; // several interfaces may have one id, and one fix each
        for (const RuleDraft& one : before.drafts)
            ++left[subject_of(one)];
        for (const Planned& one : plan)
            --left[one.subject];
        before.forget();
        EditedReader reader(disk_, *before.deck, edits, options_.threads);
        auto read =
            read_and_check(path_, reader, reading_, rules_, options_.limits, needs_, options_.threads);
        if (!read) return "the result could not be read: " + read.error().message;
        const CheckedDeck& after = **read;
        if (after.deck->files().size() != before.deck->files().size())
            return "the result would read other files";
        for (std::size_t i = 0; i < after.deck->files().size(); ++i)
            if (after.deck->files()[i]->path() != before.deck->files()[i]->path())
                return "the result would read its files in another order";
        for (const RuleDraft& one : after.drafts)
            --left[subject_of(one)];
        for (const Planned& one : plan)
            if (left[one.subject] < 0) return "the finding was still there after the repair";
        if (std::string error = errors.first_new(after, plan); !error.empty()) return error;
        next.texts = reader.texts();
        for (std::size_t i = 0; i < next.texts.size(); ++i)
            if (!next.texts[i] && i < state.texts.size()) next.texts[i] = state.texts[i];
        next.edits = then(state.edits, edits);
        next.checked = std::move(*read);
        return {};
    }

    /// The deck before a round that came to nothing.
    bool read_again(State& state, FixOutcome& outcome) {
        EditedReader reader(disk_, *outcome.original->deck, state.edits, options_.threads);
        auto read =
            read_and_check(path_, reader, reading_, rules_, options_.limits, needs_, options_.threads);
        if (!read) return false;
        state.texts = reader.texts();
        state.checked = std::move(*read);
        return true;
    }

    static void take_files(const State& state, FixOutcome& outcome) {
        const Deck &before = *outcome.original->deck, &after = *outcome.result->deck;
        for (std::size_t i = 0; i < before.files().size(); ++i) {
            const SourceFile& file = *before.files()[i];
            EditList edits = minimal(file.bytes(), of_file(state.edits, FileId{static_cast<uint32_t>(i)}));
            if (edits.empty()) continue;
            outcome.files.push_back({file.path(), file.bytes(), after.files()[i]->bytes(), std::move(edits)});
        }
        outcome.texts = state.texts;
    }

    const std::string& path_;
    FileReader& disk_;
    const ReadOptions& reading_;
    const FixOptions& options_;
    std::vector<const Rule*> rules_;
    Needs needs_ = Needs::none;
    std::map<Subject, std::string> dropped_; ///< fixes that did not hold, and why
    bool dropped_too_early_ = false;         ///< something was repaired since
};

} // namespace

FixReport report_of(const FixOutcome& outcome, bool with_edits) {
    FixReport report;
    report.path = outcome.before.path;
    report.failure = outcome.before.failure;
    report.failure_help = outcome.before.failure_help;
    report.applied = outcome.applied;
    report.declined = outcome.declined;
    report.interfaces = outcome.interfaces;
    report.force_unit = outcome.force_unit;
    for (const FixedFile& file : outcome.files) {
        if (with_edits)
            report.files.push_back(
                change_of(outcome.original->deck->file(file.edits.front().at.file), file.edits));
        else
            report.files.push_back({file.path, {}});
    }
    std::vector<DeckResult> one;
    one.push_back(outcome.after);
    report.remaining = summarise(one);
    return report;
}

FixOutcome run_fixes(const std::string& path, FileReader& disk, const ReadOptions& reading,
                     const FixOptions& options) {
    return Fixer(path, disk, reading, options).run();
}

} // namespace drawbead
