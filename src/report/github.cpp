#include "report/text.h"
#include "report/utf8.h"
#include "report/writer.h"

#include <algorithm>

namespace drawbead {

namespace {

/// GitHub shows ten annotations of a kind per step, and which ten is not ours to choose once there are more.
constexpr std::size_t most_annotations = 10;

/// The message of a workflow command; line ends in it are line ends of the annotation.
std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : valid_utf8(text)) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '%')
            out += "%25";
        else if (c == '\r')
            out += "%0D";
        else if (c == '\n')
            out += "%0A";
        else
            out += byte < 0x20 || byte == 0x7f ? '?' : c;
    }
    return out;
}

/// The value of one of its properties.
std::string escaped_property(std::string_view text) {
    std::string out;
    for (const char c : escaped(text)) {
        if (c == ':')
            out += "%3A";
        else if (c == ',')
            out += "%2C";
        else
            out += c;
    }
    return out;
}

class GithubWriter final : public ReportWriter {
public:
    explicit GithubWriter(OutputSink& out) : out_(out) {}

    void deck(const DeckResult& deck) override {
        if (deck.failed()) {
            ResolvedPlace place = deck.failure_place;
            if (place.file.empty()) place.file = deck.path;
            std::string message = deck.failure;
            if (!deck.failure_help.empty()) message += "\n" + deck.failure_help;
            keep(unreadable, [&] { return command("error", place, "deck not read", message); });
            return;
        }
        for (const Finding& finding : deck.findings) {
            const auto text = [&] {
                ResolvedPlace place;
                place.file = deck.path;
                if (!finding.places.empty()) place = finding.places.front();
                std::string message = finding.message;
                for (const std::string& note : finding.notes)
                    message += "\n" + note;
                if (!finding.help.empty()) message += "\n" + finding.help;
                const std::string_view level = finding.severity == Severity::info      ? "notice"
                                               : finding.severity == Severity::warning ? "warning"
                                                                                       : "error";
                return command(level, place, finding.code + ' ' + finding.name, message);
            };
            keep(static_cast<int>(finding.severity), text);
        }
    }

    void end(const Summary& summary) override {
        for (const Annotation& one : worst_)
            out_.write(one.text);
        std::string message = counts_sentence(summary);
        if (count_ > worst_.size())
            message += "; the worst " + std::to_string(worst_.size()) + " of " + std::to_string(count_) +
                       " are shown";
        out_.write(std::string(summary.interrupted ? "::error" : "::notice") +
                   " title=drawbead::" + escaped(message) + '\n');
    }

private:
    static constexpr int unreadable = 3; ///< worse than any severity
    struct Annotation {
        int rank;
        std::string text;
    };

    template <class Text>
    void keep(int rank, const Text& text) {
        ++count_;
        // Behind all that are as bad: of two the first one stays.
        const auto at = std::find_if(worst_.begin(), worst_.end(),
                                     [&](const Annotation& one) { return one.rank < rank; });
        if (at == worst_.end() && worst_.size() == most_annotations) return;
        worst_.insert(at, {rank, text()});
        if (worst_.size() > most_annotations) worst_.pop_back();
    }

    static std::string command(std::string_view level, const ResolvedPlace& place, std::string_view title,
                               std::string_view message) {
        std::string text = "::" + std::string(level) + " file=" + escaped_property(plain_path(place.file));
        if (place.line)
            text += ",line=" + std::to_string(place.line) + ",endLine=" + std::to_string(place.line);
        if (place.line && place.column) {
            text += ",col=" + std::to_string(place.in_characters());
            // Their last column is part of the place.
            if (place.end_in_characters() > place.in_characters())
                text += ",endColumn=" + std::to_string(place.end_in_characters() - 1);
        }
        return text + ",title=" + escaped_property(title) + "::" + escaped(message) + '\n';
    }

    OutputSink& out_;
    std::vector<Annotation> worst_; ///< worst first, in order of appearance where equal
    std::size_t count_ = 0;
};

} // namespace

std::unique_ptr<ReportWriter> github_writer(OutputSink& out) {
    return std::make_unique<GithubWriter>(out);
}

} // namespace drawbead
