// SARIF 2.1.0. Section numbers are of the OASIS standard.
#include "report/json.h"
#include "report/text.h"
#include "report/utf8.h"
#include "report/writer.h"

#include <algorithm>

namespace drawbead {

namespace {

using Layout = JsonWriter::Layout;

std::string_view level_of(Severity severity) {
    switch (severity) {
    case Severity::error:
        return "error";
    case Severity::warning:
        return "warning";
    case Severity::info:
        break;
    }
    return "note";
}

/// A path as a reference (RFC 3986): bytes that may not stand in one are escaped, and so is ':' since a
/// relative path must not look like a scheme.
std::string uri_of(std::string_view path) {
    constexpr std::string_view plain = "-._~/!$&'()*+,;=@";
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string uri = path.substr(0, 1) == "/" ? "file://" : "";
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (letter || plain.find(c) != std::string_view::npos) {
            uri += c;
        } else {
            uri += '%';
            uri += digits[byte >> 4];
            uri += digits[byte & 15];
        }
    }
    return uri;
}

/// Braces stand for placeholders in messages (3.11.5).
std::string message_text(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '{' || c == '}') out += c;
        out += c;
    }
    return out;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k <= bytes.size() ? letters[group >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

std::size_t code_points(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); ++count)
        i += std::max<std::size_t>(sequence_length(text.substr(i)), 1);
    return count;
}

/// The first paragraph of a rule's page: what it does.
std::string_view first_paragraph(std::string_view page) {
    const std::size_t heading = page.find("\n## ");
    if (heading == std::string_view::npos) return {};
    const std::size_t begin = page.find('\n', heading + 1);
    if (begin == std::string_view::npos) return {};
    const std::string_view rest = page.substr(begin + 1);
    return rest.substr(0, std::min(rest.find("\n\n"), rest.size()));
}

class SarifWriter final : public ReportWriter {
public:
    SarifWriter(OutputSink& out, const WriterOptions& options) : json_(out), rules_(options.rules) {
        json_.begin_object();
        json_.member("$schema", "https://json.schemastore.org/sarif-2.1.0.json");
        json_.member("version", "2.1.0");
        json_.key("runs");
        json_.begin_array();
        json_.begin_object();
        json_.key("tool");
        json_.begin_object();
        json_.key("driver");
        json_.begin_object();
        json_.member("name", "drawbead");
        json_.member("version", options.tool_version);
        json_.member("semanticVersion", options.tool_version);
        json_.key("rules");
        json_.begin_array();
        for (const RuleInfo& rule : rules_)
            write_rule(rule);
        json_.end();
        json_.end();
        json_.end();
        json_.member("columnKind", "unicodeCodePoints");
        // Where it is, is not said: the same decks give the same bytes in another folder (3.14.14).
        json_.key("originalUriBaseIds");
        json_.begin_object();
        json_.key(base);
        json_.begin_object();
        message("description", "The folder that drawbead was run in.");
        json_.end();
        json_.end();
        json_.key("results");
        json_.begin_array();
    }

    void deck(const DeckResult& deck) override {
        if (deck.failed()) {
            Failure failure{deck.failure, deck.failure_place};
            if (!deck.failure_help.empty()) failure.text += "; " + deck.failure_help;
            if (failure.place.file.empty()) failure.place.file = deck.path;
            failures_.push_back(std::move(failure));
        }
        for (const Finding& finding : deck.findings)
            write_result(deck, finding);
    }

    void end(const Summary& summary) override {
        json_.end();
        json_.key("invocations");
        json_.begin_array();
        json_.begin_object();
        json_.member("executionSuccessful", summary.failed == 0 && !summary.interrupted);
        json_.member("exitCode", summary.exit_status);
        json_.key("toolExecutionNotifications");
        json_.begin_array();
        for (const Failure& failure : failures_)
            notification("deck-not-read", failure.text, &failure.place);
        if (summary.interrupted)
            notification("run-interrupted",
                         "interrupted after " + std::to_string(summary.decks) + " of " +
                             std::to_string(summary.asked) + " decks",
                         nullptr);
        json_.end();
        json_.end();
        json_.end();
        json_.end();
        json_.end();
        json_.end();
    }

private:
    static constexpr const char* base = "SRCROOT";
    struct Failure {
        std::string text;
        ResolvedPlace place;
    };

    void message(std::string_view key, std::string_view text) {
        json_.key(key);
        json_.begin_object(Layout::line);
        json_.member("text", text);
        json_.end();
    }

    void write_rule(const RuleInfo& rule) {
        json_.begin_object();
        json_.member("id", rule.code);
        json_.member("name", rule.name);
        message("shortDescription", rule.summary);
        const std::string_view paragraph = first_paragraph(rule.page);
        message("fullDescription", paragraph.empty() ? rule.summary : paragraph);
        json_.key("defaultConfiguration");
        json_.begin_object(Layout::line);
        json_.member("level", level_of(rule.severity));
        json_.end();
        json_.key("help");
        json_.begin_object();
        json_.member("text", std::string(rule.summary) + "; 'drawbead explain " + std::string(rule.code) +
                                 "' says more");
        if (!rule.page.empty()) json_.member("markdown", rule.page);
        json_.end();
        json_.key("properties");
        json_.begin_object(Layout::line);
        json_.key("tags");
        json_.begin_array();
        json_.value(rule.family());
        json_.end();
        json_.end();
        json_.end();
    }

    void artifact_location(std::string_view path) {
        json_.key("artifactLocation");
        json_.begin_object(Layout::line);
        json_.member("uri", uri_of(plain_path(path)));
        if (path.substr(0, 1) != "/") json_.member("uriBaseId", base);
        json_.end();
    }

    void region_members(uint64_t line, uint32_t column, uint64_t end_line, uint32_t end_column) {
        json_.member("startLine", line);
        if (column) json_.member("startColumn", column);
        json_.member("endLine", end_line);
        if (column && end_column) json_.member("endColumn", end_column);
    }

    /// `with_text`: what stands there, and the line around it.
    void physical_location(const ResolvedPlace& place, bool with_text) {
        json_.key("physicalLocation");
        json_.begin_object();
        artifact_location(place.file);
        const std::string_view line = place.snippet;
        if (place.line) {
            json_.key("region");
            json_.begin_object(Layout::line);
            region_members(place.line, place.in_characters(), place.line, place.end_in_characters());
            // The line may be cut before the end of the place.
            if (with_text && place.column && place.end_column > place.column &&
                place.end_column - 1 <= line.size())
                message("snippet", line.substr(place.column - 1, place.end_column - place.column));
            json_.end();
        }
        if (place.line && with_text && !line.empty()) {
            json_.key("contextRegion");
            json_.begin_object(Layout::line);
            region_members(place.line, 1, place.line, static_cast<uint32_t>(code_points(line)) + 1);
            message("snippet", line);
            json_.end();
        }
        json_.end();
    }

    void write_result(const DeckResult& deck, const Finding& finding) {
        json_.begin_object();
        json_.member("ruleId", finding.code);
        const auto rule =
            std::lower_bound(rules_.begin(), rules_.end(), finding.code,
                             [](const RuleInfo& r, const std::string& c) { return r.code < c; });
        if (rule != rules_.end() && rule->code == finding.code)
            json_.member("ruleIndex", static_cast<std::size_t>(rule - rules_.begin()));
        json_.member("level", level_of(finding.severity));
        std::string text = finding.message;
        if (!finding.help.empty()) text += "; " + finding.help;
        message("message", message_text(text));
        json_.key("locations");
        json_.begin_array();
        json_.begin_object();
        ResolvedPlace first;
        first.file = deck.path;
        physical_location(finding.places.empty() ? first : finding.places.front(), true);
        json_.end();
        json_.end();
        if (finding.places.size() > 1) write_related(finding);
        json_.key("partialFingerprints");
        json_.begin_object(Layout::line);
        json_.member("drawbead/v1", finding.fingerprint);
        json_.end();
        write_fixes(finding);
        json_.key("properties");
        json_.begin_object();
        if (finding.interface_id) json_.member("interface", *finding.interface_id);
        json_.member("places", std::max<uint64_t>(finding.place_count, finding.places.size()));
        json_.member("deck", deck.path);
        if (!finding.notes.empty()) json_.member_list("notes", finding.notes);
        json_.end();
        json_.end();
    }

    void write_related(const Finding& finding) {
        json_.key("relatedLocations");
        json_.begin_array();
        for (std::size_t i = 1; i < finding.places.size(); ++i) {
            json_.begin_object();
            json_.member("id", i);
            physical_location(finding.places[i], false);
            message("message", "also here");
            json_.end();
        }
        json_.end();
    }

    /// Offers whose changes are known.
    void write_fixes(const Finding& finding) {
        const auto known = [](const FixOffer& fix) { return !fix.changes.empty(); };
        if (std::none_of(finding.fixes.begin(), finding.fixes.end(), known)) return;
        json_.key("fixes");
        json_.begin_array();
        for (const FixOffer& fix : finding.fixes) {
            if (!known(fix)) continue;
            const bool safe = fix.applicability == FixAvailability::safe;
            json_.begin_object();
            message("description", message_text((safe ? "" : "unsafe: ") + fix.title));
            json_.key("artifactChanges");
            json_.begin_array();
            for (const FileChange& change : fix.changes)
                write_change(change);
            json_.end();
            json_.end();
        }
        json_.end();
    }

    void write_change(const FileChange& change) {
        json_.begin_object();
        artifact_location(change.path);
        json_.key("replacements");
        json_.begin_array();
        for (const FileEdit& e : change.edits) {
            json_.begin_object();
            json_.key("deletedRegion");
            json_.begin_object(Layout::line);
            region_members(e.where.line, e.where.in_characters(), e.end_line, e.where.end_in_characters());
            json_.end();
            if (!e.text.empty()) {
                json_.key("insertedContent");
                json_.begin_object(Layout::line);
                // A deck in another encoding must stay in it.
                if (valid_utf8(e.text) == e.text)
                    json_.member("text", e.text);
                else
                    json_.member("binary", base64(e.text));
                json_.end();
            }
            json_.end();
        }
        json_.end();
        json_.end();
    }

    void notification(std::string_view id, std::string_view text, const ResolvedPlace* place) {
        json_.begin_object();
        json_.key("descriptor");
        json_.begin_object(Layout::line);
        json_.member("id", id);
        json_.end();
        json_.member("level", "error");
        message("message", message_text(text));
        if (place) {
            json_.key("locations");
            json_.begin_array();
            json_.begin_object();
            physical_location(*place, false);
            json_.end();
            json_.end();
        }
        json_.end();
    }

    JsonWriter json_;
    std::span<const RuleInfo> rules_;
    std::vector<Failure> failures_;
};

} // namespace

std::unique_ptr<ReportWriter> sarif_writer(OutputSink& out, const WriterOptions& options) {
    return std::make_unique<SarifWriter>(out, options);
}

} // namespace drawbead
