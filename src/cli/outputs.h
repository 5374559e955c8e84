#pragma once
// The results of one run in several formats at once.
#include "base/result.h"
#include "cli/options.h"
#include "report/output.h"
#include "report/writer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace drawbead {

/// Passes decks on to one writer per target. Each file appears when it is complete, or not at all; one that
/// cannot be written does not keep the others from it.
class Outputs {
    using FileIdentity = std::pair<uint64_t, uint64_t>; ///< device and number

public:
    /// Opens all targets, before any work is done. Refused are an existing file that is one of `inputs`, and
    /// two results in one place; `aside`: where results of the run go beside these, if anywhere.
    static Result<std::unique_ptr<Outputs>> open(const std::vector<OutputTarget>& targets, ColourMode,
                                                 const WriterOptions&, const std::vector<std::string>& inputs,
                                                 const std::string& aside = {});

    /// A target that turns out to be a file of the deck is given up, and the file stays.
    void deck(const DeckResult&);
    void end(const Summary&);
    /// Hands standard output over, as far as it is written.
    void flush_standard_output();
    /// Standard output is a terminal that shows results.
    bool on_terminal() const { return on_terminal_; }
    /// No target takes anything any more.
    bool failed() const;
    /// Makes the files appear; says what went wrong. An ExitStatus.
    int finish();

private:
    struct One {
        std::unique_ptr<FileSink> sink;
        std::unique_ptr<ReportWriter> writer;
        bool standard_output = false;
        std::string file;
        std::optional<FileIdentity> replaces; ///< the file that is there already
    };
    void spare_files_of(const DeckResult&);
    std::vector<One> all_;
    bool on_terminal_ = false;
};

/// Whether a report in this format says what repairs would change.
bool holds_changes(Format);

/// The catalogue for reports, and what --fail-on means to them.
std::vector<RuleInfo> rule_catalogue();
std::optional<Severity> least_failing(FailOn);

/// What a run over decks ends with. `signal`: the one that ended it early, 0 for none.
int exit_status_of(const Summary&, bool failing, int signal);

} // namespace drawbead
