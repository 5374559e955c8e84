#pragma once
// Findings that are known and shall not count, in a file beside the decks (schemas/baseline.schema.json). A
// finding is known by its fingerprint: its code, interface and entities, never a line. Decks are named from
// the folder of the file, so that a checkout may move.
#include "base/result.h"
#include "findings/report.h"
#include "report/output.h"
#include "rules/check.h"

#include <map>
#include <string>
#include <vector>

namespace drawbead {

class Baseline {
public:
    /// Nothing is known, of a file that is still to be written.
    explicit Baseline(std::string path) : path_(std::move(path)) {}
    static Result<Baseline> read(const std::string& path);

    /// Takes known findings out of the result and counts them; what is known and was not found goes to
    /// `gone`, where the selection has run its rule. For several threads at once.
    void apply(DeckResult&, const Selection& run) const;

    /// Makes all findings of a deck known, for `write`, and takes them out of the result.
    void learn(DeckResult&, const Selection& run);

    struct Change {
        uint64_t findings = 0, decks = 0; ///< in the file now
        uint64_t added = 0, removed = 0;
    };
    /// What was learned, in place of what `before` knows of the same decks and rules. It keeps what that
    /// knows of other rules, of decks that could not be read, and of decks that were not looked at and still
    /// exist. The file, opened with FileSink::replace when the run began, is finished.
    Result<Change> write(const Baseline& before, FileSink&);

private:
    using Key = std::tuple<std::string, int64_t, std::string>; ///< code, interface or -1, fingerprint
    using Counts = std::map<Key, uint64_t>;
    struct Deck {
        Counts known;
        Selection run; ///< of what `learn` was given
        bool failed = false;
    };

    std::string path_;
    std::map<std::string, Deck> decks_;

    std::string name_of(const std::string& deck) const;
};

} // namespace drawbead
