#include "report/json_report.h"
#include "report/writer.h"

namespace drawbead {

namespace {

class LinesWriter final : public ReportWriter {
public:
    LinesWriter(OutputSink& out, const WriterOptions& options) : json_(out) {
        begin("run");
        json_.member("tool", "drawbead");
        json_.member("version", options.tool_version);
        json_.member("schema", 1);
        json_.end();
    }

    void deck(const DeckResult& deck) override {
        for (const Finding& finding : deck.findings) {
            begin("finding");
            json_.member("deck", deck.path);
            write_finding_members(json_, finding);
            json_.end();
        }
        begin("deck");
        json_.member("path", deck.path);
        json_.key("failure");
        if (deck.failed())
            write_failure(json_, deck);
        else
            json_.null();
        json_.member("interfaces", deck.info.interfaces.size());
        json_.member("findings", deck.findings.size());
        json_.end();
    }

    void end(const Summary& summary) override {
        begin("summary");
        write_summary_members(json_, summary);
        json_.end();
    }

private:
    void begin(std::string_view type) {
        json_.begin_object(JsonWriter::Layout::line);
        json_.member("type", type);
    }

    JsonWriter json_;
};

} // namespace

std::unique_ptr<ReportWriter> lines_writer(OutputSink& out, const WriterOptions& options) {
    return std::make_unique<LinesWriter>(out, options);
}

} // namespace drawbead
