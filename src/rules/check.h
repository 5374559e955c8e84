#pragma once
// Runs rules over one deck.
#include "findings/report.h"
#include "rules/analysis.h"
#include "rules/limits.h"
#include "rules/rule.h"
#include "rules/suppressions.h"

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace drawbead {

struct Selection {
    std::vector<std::string> select; ///< codes ("SRF001"), families ("SRF"), names or "ALL"; empty: all
    std::vector<std::string> ignore; ///< wins over select where it is as long or longer

    bool operator()(const RuleInfo&) const;
    /// The first entry that names no rule and no family, if any.
    std::optional<std::string> unknown() const;
};

/// Where the time of a run goes, in nanoseconds, summed over decks and threads.
struct CheckTimes {
    explicit CheckTimes(std::size_t rules) : by_rule(rules) {}
    std::atomic<uint64_t> reading{0}, model{0}, analysis{0};
    std::vector<std::atomic<uint64_t>> by_rule; ///< as registry()
};

/// What a scene says of the motion, instead of the deck and the engine deck beside it.
struct SceneMotion {
    PrescribedMotion prescribed;
    std::vector<MotionTarget> targets; ///< what its moves name; for the deck's own motion none
    double end = 0;                    ///< of the run
    /// Where each target stands, for errors.
    struct Place {
        uint64_t line = 0;
        uint32_t column = 0;
    };
    std::string path;
    std::vector<Place> places;
};

struct CheckOptions {
    Selection selection;
    unsigned threads = 1;        ///< within one deck
    bool with_changes = false;   ///< say what each repair that is offered would change
    CheckTimes* times = nullptr; ///< when asked for
    std::optional<SceneMotion> scene{};
    Limits limits{};
    /// Severities instead of the rules' own, by code, name, family or "ALL"; the closest name counts.
    std::map<std::string, Severity> severity{};
};

/// What one rule said of one thing.
struct RuleDraft {
    const Rule* rule = nullptr;
    Draft draft;
    bool suppressed = false; ///< a comment in the deck takes it away
};

/// A deck with all that was made of it and what the rules say.
struct CheckedDeck {
    std::unique_ptr<Deck> deck;
    Model model;
    Analysis analysis;
    Limits limits;
    Suppressions suppressions;
    std::vector<RuleDraft> drafts; ///< by rule, in the order of the registry

    RuleContext context() const { return {*deck, model, analysis, limits, suppressions}; }
    /// Gives the memory of everything but the deck's text back.
    void forget() {
        drafts.clear();
        analysis = {};
        model = {};
    }
};

/// Runs the rules over a deck that can be read. `more`: needs beyond those of the rules.
Result<std::unique_ptr<CheckedDeck>> read_and_check(const std::string& path, FileReader&, const ReadOptions&,
                                                    std::span<const Rule* const> rules, const Limits&,
                                                    Needs more, unsigned threads,
                                                    const std::optional<SceneMotion>& scene = {},
                                                    CheckTimes* times = nullptr);
/// The same as a result that owns what it says: findings sorted by place. `with_changes`: each with what its
/// repair would change, as rules/planned_changes.h says; the model needs what those repairs look at.
DeckResult result_of(const CheckedDeck&, const std::map<std::string, Severity>& severity = {},
                     bool with_changes = false);
/// A deck that cannot be read.
DeckResult unreadable_deck(const std::string& path, const Error&);
/// A place with its line and column.
ResolvedPlace resolve(const Deck&, const Span&);

/// Reads `path`, builds what the selected rules need, runs them. Never fails: a deck that cannot be read is a
/// result with `failure` set.
DeckResult check_deck(const std::string& path, FileReader&, const ReadOptions&, const CheckOptions&);

/// What `info` prints.
DeckResult describe_deck(const std::string& path, FileReader&, const ReadOptions&);

} // namespace drawbead
