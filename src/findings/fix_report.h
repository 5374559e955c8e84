#pragma once
// What a repair did, as values that own everything they say. Work units.
#include "findings/finding.h"
#include "findings/report.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace drawbead {

/// What a fix does to one interface.
struct InterfaceChange {
    int64_t interface_id = 0;
    uint64_t segments_turned = 0, nodes_moved = 0;
};

/// One repair that was made.
struct AppliedFix {
    std::string code, name, title;
    bool safe = true;
    std::optional<int64_t> interface_id;
    ResolvedPlace place; ///< of the finding, in the text of its round
    std::string message; ///< what the finding said
    std::vector<InterfaceChange> changes;
};

/// A finding of a rule with a fix that was not repaired.
struct DeclinedFix {
    std::string code, name, title; ///< title: when a fix was tried
    std::optional<int64_t> interface_id;
    ResolvedPlace place;
    std::string why;
    bool needs_unsafe = false; ///< --unsafe would make it
};

/// One interface before and after.
struct InterfaceOutcome {
    struct State {
        uint64_t nodes = 0;
        double fn = 0, ft = 0;     ///< sum of limit times tributary length: force
        std::string slope;         ///< with its unit; empty when not known
        std::vector<int> messages; ///< what the Starter says, ascending
    };
    int64_t id = 0;
    std::string title;
    uint64_t segments_turned = 0, nodes_moved = 0;
    std::optional<State> before; ///< empty: a new interface
    std::optional<State> after;  ///< empty: it is gone

    bool changed() const;
};

/// One deck.
struct FixReport {
    std::string path;
    std::string failure, failure_help; ///< when the deck could not be read, or its files not be written
    std::vector<AppliedFix> applied;
    std::vector<DeclinedFix> declined;
    std::vector<InterfaceOutcome> interfaces; ///< that changed, in deck order, new ones last
    std::vector<FileChange> files;
    std::vector<std::string> written; ///< paths
    bool proposed = false;            ///< nothing was to be written
    Summary remaining;                ///< findings after the repairs
    std::string force_unit;

    bool failed() const { return !failure.empty(); }
};

} // namespace drawbead
