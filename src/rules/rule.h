#pragma once
// One rule is one .cpp with a page of the same name beside it, and one line in registry.cpp.
#include "deck/deck.h"
#include "findings/finding.h"
#include "fix/planner.h"
#include "model/model.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace drawbead {

struct Analysis;
struct Limits;
struct Suppressions;

/// What a rule says, with places still in the deck; the sink resolves them and adds code, name and severity.
struct Draft {
    std::string message;
    Span primary;
    std::vector<Span> related; ///< in order of importance; the sink keeps the first 99
    uint64_t place_count = 0;  ///< of all places when more than listed, else 0
    std::optional<InterfaceId> interface_id;
    std::optional<SurfaceId> surface_id; ///< of the surface that it is about, for its fix
    std::optional<Severity> severity;    ///< when it differs from the rule's own
    Entities entities;
    std::vector<Measure> measured;
    std::vector<std::string> notes;
    std::string help;
    std::vector<FixOffer> fixes;
    std::string discriminator; ///< told apart from other findings of the same code, interface and entities
};

class FindingSink {
public:
    virtual ~FindingSink() = default;
    virtual void add(Draft) = 0;
};

/// All that a rule may look at.
struct RuleContext {
    const Deck& deck;
    const Model& model;
    const Analysis& analysis;
    const Limits& limits;             ///< rules/limits.h
    const Suppressions& suppressions; ///< rules/suppressions.h; judged only for the rules of the family SUP
};

struct Rule {
    RuleInfo info;
    Needs needs = Needs::none;
    void (*check)(const RuleContext&, FindingSink&) = nullptr;
    Needs fix_needs = Needs::none; ///< what `fix` looks at and `check` does not
    /// Repairs what a draft of `check` says, see fix/planner.h; empty when there is no repair that is no
    /// guess. Without it the rule's findings offer no fix.
    std::optional<Fix> (*fix)(const RuleContext&, const Draft&, FixPlanner&) = nullptr;
};

/// All rules, sorted by code.
std::span<const Rule> registry();
const Rule* find_rule(std::string_view code_or_name);

} // namespace drawbead
