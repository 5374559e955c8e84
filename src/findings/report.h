#pragma once
// The outcome of a run over one or more decks, ready to be written in any format.
#include "findings/finding.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace drawbead {

struct InterfaceSummary {
    int64_t id = 0;
    std::string title;
    uint64_t nodes = 0;    ///< listed in its group
    uint64_t segments = 0; ///< of its main surface
    double length = 0;     ///< of the bead line, work units
};

/// What was read of a deck.
struct DeckInfo {
    int version = 0; ///< /BEGIN, as written
    std::string run_name;
    std::string mass_unit, length_unit, time_unit; ///< work units
    std::string input_mass_unit, input_length_unit, input_time_unit;
    std::vector<std::string> files;
    uint64_t bytes = 0;
    uint64_t nodes = 0, shells4 = 0, shells3 = 0, solids = 0, parts = 0;
    std::vector<InterfaceSummary> interfaces; ///< of TYPE8
    std::map<std::string, uint64_t> keywords; ///< "/NODE" -> blocks
};

struct StarterMessages {
    struct Interface {
        int64_t id = 0;
        std::vector<int> messages;      ///< of 112, 703, 1040, 1043, 346, 499; ascending
        std::vector<int64_t> nodes_346; ///< user ids, ascending
    };
    std::vector<int> messages; ///< union, ascending
    std::vector<Interface> interfaces;
};

/// Findings that are alike, as a baseline lists them.
struct BaselineEntry {
    std::string fingerprint, code;
    std::optional<int64_t> interface_id;
    uint64_t count = 1;
};

struct DeckResult {
    std::string path;
    std::string
        failure; ///< when the deck could not be read at all: the message; everything else is empty then
    ResolvedPlace failure_place;
    std::string failure_help;
    DeckInfo info;
    std::optional<StarterMessages> starter;
    std::vector<Finding> findings;   ///< sorted by place, code, message
    uint64_t suppressed = 0;         ///< findings that a comment in the deck takes away
    uint64_t known = 0;              ///< findings that the baseline takes away
    std::vector<BaselineEntry> gone; ///< of the baseline, no longer found
    /// Least severity that fails a run, by the configuration of the deck; empty: none.
    std::optional<Severity> fail_on = Severity::error;

    bool failed() const { return !failure.empty(); }
};

struct Summary {
    uint64_t decks = 0, failed = 0, interfaces = 0;
    uint64_t errors = 0, warnings = 0, infos = 0;
    uint64_t suppressed = 0, known = 0, gone = 0; ///< see DeckResult
    double seconds = 0;                           ///< of the whole run; 0 where output must be reproducible
    uint64_t asked = 0; ///< decks that were to be looked at; fewer were when the run was interrupted
    bool interrupted = false;
    int exit_status = 0;
};

/// One of `of` equal parts of a run: every `of`th deck from number `number` on, from 1.
struct Shard {
    uint64_t number = 1, of = 1;
};

struct Report {
    std::string tool_version;
    std::vector<DeckResult> decks; ///< in the order given, folders sorted
    Summary summary;
};

/// Counts everything but `seconds`.
Summary summarise(const std::vector<DeckResult>&);

} // namespace drawbead
