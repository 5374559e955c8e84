#pragma once
// Runs rules over one deck.
#include "findings/report.h"
#include "rules/analysis.h"
#include "rules/limits.h"
#include "rules/rule.h"
#include "rules/suppressions.h"

#include <map>
#include <memory>
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

struct CheckOptions {
    Selection selection;
    unsigned threads = 1; ///< within one deck
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
                                                    Needs more, unsigned threads);
/// The same as a result that owns what it says: findings sorted by place.
DeckResult result_of(const CheckedDeck&, const std::map<std::string, Severity>& severity = {});
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
