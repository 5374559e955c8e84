#pragma once
// Runs rules over one deck.
#include "findings/report.h"
#include "rules/rule.h"

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
};

/// Reads `path`, builds what the selected rules need, runs them. Never fails: a deck that cannot be read is a
/// result with `failure` set.
DeckResult check_deck(const std::string& path, FileReader&, const ReadOptions&, const CheckOptions&);

/// What `info` prints.
DeckResult describe_deck(const std::string& path, FileReader&, const ReadOptions&);

} // namespace drawbead
