#include "report/text.h"
#include "report/utf8.h"
#include "report/writer.h"

#include <map>

namespace drawbead {

namespace {

/// Text of XML 1.0, in an element or an attribute: what it cannot hold, even as a reference, becomes U+FFFD.
std::string xml_text(std::string_view text) {
    const std::string valid = valid_utf8(text);
    std::string out;
    for (std::size_t i = 0; i < valid.size(); ++i) {
        const auto byte = static_cast<unsigned char>(valid[i]);
        switch (byte) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        case '\t':
        case '\r':
            out += "&#" + std::to_string(byte) + ';';
            break;
        case '\n':
            out += "&#10;";
            break;
        default:
            // U+FFFE and U+FFFF are no characters of XML either.
            if (const std::string_view three = std::string_view(valid).substr(i, 3);
                three == "\xef\xbf\xbe" || three == "\xef\xbf\xbf") {
                out += "\xef\xbf\xbd";
                i += 2;
            } else if (byte < 0x20) {
                out += "\xef\xbf\xbd";
            } else {
                out += valid[i];
            }
        }
    }
    return out;
}

class JunitWriter final : public ReportWriter {
public:
    JunitWriter(OutputSink& out, const WriterOptions& options) : out_(out), options_(options) {
        out_.write("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"drawbead\">\n");
    }

    void deck(const DeckResult& deck) override {
        if (deck.failed()) {
            std::string text = deck.failure;
            if (!deck.failure_help.empty()) text += "; " + deck.failure_help;
            suite(deck.path, 1, 0, 1);
            open_case(deck.path, "deck can be read");
            outcome("error", "deck-not-read", text, place_text(failure_place(deck)) + ": " + text);
            out_.write("    </testcase>\n  </testsuite>\n");
            return;
        }
        std::map<std::string_view, std::vector<const Finding*>> by_rule;
        for (const Finding& finding : deck.findings)
            by_rule[finding.code].push_back(&finding);
        std::size_t failures = 0;
        for (const auto& [code, findings] : by_rule)
            failures += worst_of(deck, findings) != nullptr ? 1 : 0;
        suite(deck.path, by_rule.empty() ? 1 : by_rule.size(), failures, 0);
        if (by_rule.empty()) {
            open_case(deck.path, "no findings");
            out_.write("    </testcase>\n");
        }
        for (const auto& [code, findings] : by_rule)
            write_case(deck, findings);
        out_.write("  </testsuite>\n");
    }

    void end(const Summary& summary) override {
        if (summary.interrupted) {
            const std::string text = "interrupted after " + std::to_string(summary.decks) + " of " +
                                     std::to_string(summary.asked) + " decks";
            suite("drawbead", 1, 0, 1);
            open_case("drawbead", "run is complete");
            outcome("error", "run-interrupted", text, text);
            out_.write("    </testcase>\n  </testsuite>\n");
        }
        out_.write("</testsuites>\n");
    }

private:
    static ResolvedPlace failure_place(const DeckResult& deck) {
        ResolvedPlace place = deck.failure_place;
        if (place.file.empty()) place.file = deck.path;
        return place;
    }

    /// The most severe finding when it is as severe as what fails a run.
    const Finding* worst_of(const DeckResult& deck, const std::vector<const Finding*>& findings) const {
        const std::optional<Severity> least = options_.least_failing(deck);
        const Finding* worst = nullptr;
        for (const Finding* one : findings)
            if (least && one->severity >= *least && (!worst || one->severity > worst->severity)) worst = one;
        return worst;
    }

    void suite(std::string_view name, std::size_t tests, std::size_t failures, std::size_t errors) {
        out_.write("  <testsuite name=\"" + xml_text(name) + "\" tests=\"" + std::to_string(tests) +
                   "\" failures=\"" + std::to_string(failures) + "\" errors=\"" + std::to_string(errors) +
                   "\">\n");
    }
    void open_case(std::string_view deck, std::string_view name) {
        out_.write("    <testcase classname=\"" + xml_text(deck) + "\" name=\"" + xml_text(name) + "\">\n");
    }
    void outcome(std::string_view element, std::string_view type, std::string_view message,
                 std::string_view text) {
        const std::string tag(element);
        out_.write("      <" + tag + " type=\"" + xml_text(type) + "\" message=\"" + xml_text(message) +
                   "\">" + xml_text(text) + "</" + tag + ">\n");
    }

    void write_case(const DeckResult& deck, const std::vector<const Finding*>& findings) {
        const Finding& first = *findings.front();
        std::string text;
        for (const Finding* one : findings) {
            text += finding_line(deck, *one, Palette(false)) + '\n';
            for (const std::string& note : one->notes)
                text += "  note: " + note + '\n';
            if (!one->help.empty()) text += "  help: " + one->help + '\n';
        }
        open_case(deck.path, first.code + ' ' + first.name);
        if (const Finding* worst = worst_of(deck, findings)) {
            std::string message = worst->message;
            if (findings.size() > 1)
                message += " (and " + std::to_string(findings.size() - 1) + " more of " + first.code + ')';
            outcome("failure", name(worst->severity), message, text);
        } else {
            out_.write("      <system-out>" + xml_text(text) + "</system-out>\n");
        }
        out_.write("    </testcase>\n");
    }

    OutputSink& out_;
    WriterOptions options_;
};

} // namespace

std::unique_ptr<ReportWriter> junit_writer(OutputSink& out, const WriterOptions& options) {
    return std::make_unique<JunitWriter>(out, options);
}

} // namespace drawbead
