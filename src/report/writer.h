#pragma once
// Reports are written deck by deck, so that a batch of thousands of decks needs no more memory than one.
#include "findings/report.h"
#include "report/output.h"

#include <memory>
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

/// Text, per finding: `path:line:column: severity: CODE name: message [fix: title]`, the source line with a
/// caret, further places, notes, help, an empty line. Decks that could not be read are left to the caller:
/// they are errors, not results. Control bytes of deck text never reach the terminal.
std::unique_ptr<ReportWriter> full_writer(OutputSink&, bool colour);
/// Text, the first of these lines only: what editors and scripts read.
std::unique_ptr<ReportWriter> concise_writer(OutputSink&, bool colour);
/// JSON by schemas/report.schema.json. `Summary::seconds` is left out: the same deck gives the same bytes.
std::unique_ptr<ReportWriter> json_writer(OutputSink&, std::string_view tool_version);

/// "3 decks, 7 interfaces: 2 errors, 1 warning in 0.12 s", without a line end.
std::string summary_sentence(const Summary&);

} // namespace drawbead
