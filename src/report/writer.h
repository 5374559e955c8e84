#pragma once
// Reports are written deck by deck, so that a batch of thousands of decks needs no more memory than one.
#include "findings/report.h"
#include "report/output.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace drawbead {

/// Call deck() for each deck in order, then end() once. The sink must outlive the writer.
class ReportWriter {
public:
    virtual ~ReportWriter() = default;
    virtual void deck(const DeckResult&) = 0;
    virtual void end(const Summary&) = 0;
};

/// What the writers of a run share. `rules` and what its members point at must outlive the writer.
struct WriterOptions {
    std::string_view tool_version;
    std::span<const RuleInfo> rules{}; ///< the catalogue, by code
    std::optional<Shard> shard{};      ///< when the run is a part of one
    /// --fail-on, which holds for all decks; without it each deck has its own.
    std::optional<std::optional<Severity>> fail_on{};

    std::optional<Severity> least_failing(const DeckResult& deck) const {
        return fail_on.value_or(deck.fail_on);
    }
};

/// Text, per finding: `path:line:column: severity: CODE name: message [fix: title]`, the source line with a
/// caret, further places, notes, help, an empty line. Decks that could not be read are left to the caller:
/// they are errors, not results. Control bytes of deck text never reach the terminal.
std::unique_ptr<ReportWriter> full_writer(OutputSink&, bool colour);
/// Text, the first of these lines only: what editors and scripts read.
std::unique_ptr<ReportWriter> concise_writer(OutputSink&, bool colour);
/// JSON by schemas/report.schema.json. `Summary::seconds` is left out: the same deck gives the same bytes.
std::unique_ptr<ReportWriter> json_writer(OutputSink&, const WriterOptions&);
/// JSON by schemas/lines.schema.json, one object a line: the run, findings, decks, the summary.
std::unique_ptr<ReportWriter> lines_writer(OutputSink&, const WriterOptions&);
/// One row per finding and per deck that could not be read, in UTF-8, quoted where needed (RFC 4180, but with
/// "\n" at the end of a row).
std::unique_ptr<ReportWriter> csv_writer(OutputSink&);
/// SARIF 2.1.0 with the pages of all rules; columns in Unicode code points.
std::unique_ptr<ReportWriter> sarif_writer(OutputSink&, const WriterOptions&);
/// JUnit XML: a deck is a suite, a rule that found something in it is a case, which fails when a finding is
/// as severe as what fails a run.
std::unique_ptr<ReportWriter> junit_writer(OutputSink&, const WriterOptions&);
/// Workflow commands of GitHub: the worst ten findings and decks, then a summary.
std::unique_ptr<ReportWriter> github_writer(OutputSink&);
/// GitLab's Code Quality report.
std::unique_ptr<ReportWriter> gitlab_writer(OutputSink&);

/// "3 decks, 7 interfaces: 2 errors, 1 warning in 0.12 s", without a line end.
std::string summary_sentence(const Summary&);
/// The same without the time.
std::string counts_sentence(const Summary&);

} // namespace drawbead
