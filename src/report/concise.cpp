#include "report/text.h"
#include "report/writer.h"

namespace drawbead {

namespace {

class ConciseWriter final : public ReportWriter {
public:
    ConciseWriter(OutputSink& out, bool colour) : out_(out), palette_(colour) {}

    void deck(const DeckResult& deck) override {
        for (const Finding& finding : deck.findings)
            out_.write(finding_line(deck, finding, palette_) + '\n');
    }
    void end(const Summary&) override {}

private:
    OutputSink& out_;
    Palette palette_;
};

} // namespace

std::unique_ptr<ReportWriter> concise_writer(OutputSink& out, bool colour) {
    return std::make_unique<ConciseWriter>(out, colour);
}

} // namespace drawbead
