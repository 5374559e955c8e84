#include "report/json.h"
#include "report/text.h"
#include "report/writer.h"

#include <algorithm>
#include <map>

namespace drawbead {

namespace {

class GitlabWriter final : public ReportWriter {
public:
    explicit GitlabWriter(OutputSink& out) : json_(out) { json_.begin_array(); }

    void deck(const DeckResult& deck) override {
        if (deck.failed()) {
            const ResolvedPlace& place = deck.failure_place;
            std::string text = deck.failure;
            if (!deck.failure_help.empty()) text += "; " + deck.failure_help;
            issue("deck-not-read", text, "blocker", place.file.empty() ? deck.path : place.file, place.line,
                  unique("deck-not-read", deck.path));
            return;
        }
        std::map<std::string, uint64_t> seen;
        for (const Finding& finding : deck.findings) {
            // Findings with the same fingerprint are one to GitLab: decks are told apart, and so are
            // the second and third of a deck.
            const uint64_t again = seen[finding.fingerprint]++;
            std::string discriminator = deck.path + '\n' + finding.fingerprint;
            if (again) discriminator += '\n' + std::to_string(again);
            const bool placed = !finding.places.empty();
            const std::string_view severity = finding.severity == Severity::info      ? "info"
                                              : finding.severity == Severity::warning ? "major"
                                                                                      : "critical";
            issue(finding.code, finding.message, severity, placed ? finding.places.front().file : deck.path,
                  placed ? finding.places.front().line : 0, unique(finding.code, discriminator));
        }
    }

    void end(const Summary& summary) override {
        if (summary.interrupted)
            issue("run-interrupted",
                  "interrupted after " + std::to_string(summary.decks) + " of " +
                      std::to_string(summary.asked) + " decks",
                  "blocker", ".", 0, unique("run-interrupted", ""));
        json_.end();
    }

private:
    static std::string unique(std::string_view code, std::string_view discriminator) {
        return fingerprint(code, std::nullopt, {}, discriminator);
    }

    /// GitLab knows no place without a line: the first one stands for the file.
    void issue(std::string_view check, std::string_view description, std::string_view severity,
               std::string_view path, uint64_t line, std::string_view print) {
        json_.begin_object();
        json_.member("description", description);
        json_.member("check_name", check);
        json_.member("fingerprint", print);
        json_.member("severity", severity);
        json_.key("location");
        json_.begin_object(JsonWriter::Layout::line);
        json_.member("path", plain_path(path));
        json_.key("lines");
        json_.begin_object();
        json_.member("begin", std::max<uint64_t>(line, 1));
        json_.end();
        json_.end();
        json_.end();
    }

    JsonWriter json_;
};

} // namespace

std::unique_ptr<ReportWriter> gitlab_writer(OutputSink& out) {
    return std::make_unique<GitlabWriter>(out);
}

} // namespace drawbead
