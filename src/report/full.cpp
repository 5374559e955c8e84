#include "report/text.h"
#include "report/writer.h"

#include <algorithm>

namespace drawbead {

namespace {

/// Further places that are spelled out before the rest is only counted.
constexpr std::size_t listed_places = 3;

/// What a terminal shows for the bytes [0, end): a UTF-8 sequence is one column.
std::size_t shown_columns(std::string_view text, std::size_t end) {
    const std::string_view part = text.substr(0, end);
    return static_cast<std::size_t>(std::count_if(
        part.begin(), part.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

class FullWriter final : public ReportWriter {
public:
    FullWriter(OutputSink& out, bool colour) : out_(out), palette_(colour) {}

    void deck(const DeckResult& deck) override {
        for (const Finding& finding : deck.findings) {
            out_.write(finding_line(deck, finding, palette_) + '\n');
            if (!finding.places.empty()) {
                source(finding.places.front(), palette_.of(finding.severity));
                others(finding);
            }
            for (const std::string& note : finding.notes)
                remark("note", note);
            if (!finding.help.empty()) remark("help", finding.help);
            out_.write('\n');
        }
    }
    void end(const Summary&) override {}

private:
    void source(const ResolvedPlace& place, std::string_view colour) {
        if (place.line == 0 || place.snippet.empty()) return;
        const std::string line = std::to_string(place.line);
        const std::string snippet = terminal_safe(place.snippet);
        margin(line);
        out_.write(' ');
        out_.write(snippet);
        out_.write('\n');
        // A place beyond the part of the line that is shown has no caret; one that ends beyond it is cut.
        const std::size_t begin = place.column ? place.column - 1 : 0;
        if (begin >= snippet.size()) return;
        const std::size_t end =
            std::clamp<std::size_t>(place.end_column ? place.end_column - 1 : 0, begin + 1, snippet.size());
        const std::size_t left = shown_columns(snippet, begin);
        const std::size_t width = std::max<std::size_t>(shown_columns(snippet, end) - left, 1);
        margin(std::string(line.size(), ' '));
        out_.write(std::string(1 + left, ' '));
        out_.write(colour);
        out_.write('^' + std::string(width - 1, '~'));
        out_.write(palette_.reset);
        out_.write('\n');
    }

    void margin(const std::string& line) {
        out_.write(palette_.blue);
        out_.write(std::string(line.size() < 6 ? 6 - line.size() : 0, ' ') + line + " |");
        out_.write(palette_.reset);
    }

    /// "  also: other.inc:12:1, 13:1, 14:1 … and 408 more places"; a file is named when it changes.
    void others(const Finding& finding) {
        const std::size_t total = std::max<std::size_t>(finding.place_count, finding.places.size());
        if (total < 2) return;
        std::string text;
        std::size_t shown = 1;
        for (; shown < finding.places.size() && shown <= listed_places; ++shown) {
            const ResolvedPlace& place = finding.places[shown];
            if (!text.empty()) text += ", ";
            std::string where = place_text(place);
            const std::string file = terminal_safe(place.file);
            if (place.line && place.file == finding.places[shown - 1].file) where.erase(0, file.size() + 1);
            text += where;
        }
        if (shown < total) {
            if (!text.empty()) text += " … and ";
            text += std::to_string(total - shown) + (total - shown == 1 ? " more place" : " more places");
        }
        remark("also", text);
    }

    void remark(std::string_view label, std::string_view text) {
        out_.write("  ");
        out_.write(palette_.bold);
        out_.write(label);
        out_.write(":");
        out_.write(palette_.reset);
        out_.write(' ');
        out_.write(terminal_safe(text));
        out_.write('\n');
    }

    OutputSink& out_;
    Palette palette_;
};

} // namespace

std::unique_ptr<ReportWriter> full_writer(OutputSink& out, bool colour) {
    return std::make_unique<FullWriter>(out, colour);
}

} // namespace drawbead
