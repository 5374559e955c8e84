#pragma once
// What configuration files and the command line say of each deck of a run.
#include "cli/options.h"
#include "cli/paths.h"
#include "config/baseline.h"
#include "config/settings.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drawbead {

/// The part of a command line that a configuration can say, too; words as typed.
struct CommandChoices {
    const std::vector<std::string>&select, &ignore;
    bool fail_on_given;
    FailOn fail_on;
};

class DeckSettings {
public:
    /// Reads all configuration files that hold for the decks; an error when one has a mistake.
    static Result<DeckSettings> of(const std::vector<DeckPath>&, const ConfigArguments&, const ReadArguments&,
                                   const CommandChoices&);

    /// The configuration files that hold for any of the decks.
    std::vector<std::string> files() const;
    Settings of(std::size_t deck) const;
    /// Without the command line.
    Settings of_files(std::size_t deck) const;
    /// --show-config: one YAML document per deck on standard output. Returns the exit status.
    int show(const std::vector<DeckPath>&) const;

private:
    std::vector<std::string> names_; ///< of the decks, for the patterns of overrides
    std::vector<std::shared_ptr<const Config>> configs_;
    Choices command_line_;
};

/// --baseline and --write-baseline.
class KnownFindings {
public:
    static Result<KnownFindings> of(const std::string& baseline, const std::string& write_baseline);

    /// Takes out of a result what is known, or makes all of it known.
    void take(DeckResult&, const Selection&);
    /// Says what is gone, writes what is to be written. Returns the exit status.
    int finish(bool quiet);

private:
    std::optional<Baseline> read_, before_, written_;
    std::string read_path_, written_path_;
    std::unique_ptr<FileSink> sink_; ///< of what is written: opened first, so that no run is in vain
    uint64_t gone_ = 0;
    std::string gone_list_;
};

} // namespace drawbead
