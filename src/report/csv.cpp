#include "report/utf8.h"
#include "report/writer.h"

#include <algorithm>

namespace drawbead {

namespace {

/// A row, cell by cell.
class Row {
public:
    Row& add(std::string_view text) {
        if (!line_.empty()) line_ += ',';
        const std::string cell = valid_utf8(text);
        // An empty first cell would leave the next one without its comma.
        if (!cell.empty() && cell.find_first_of(",\"\r\n") == std::string::npos) {
            line_ += cell;
            return *this;
        }
        if (cell.empty() && !line_.empty()) return *this;
        line_ += '"';
        for (const char c : cell) {
            if (c == '"') line_ += '"';
            line_ += c;
        }
        line_ += '"';
        return *this;
    }
    /// A count; 0 stands for "not known" and leaves the cell empty.
    Row& add(uint64_t number) { return add(number ? std::to_string(number) : std::string()); }
    std::string take() { return std::move(line_ += '\n'); }

private:
    std::string line_;
};

class CsvWriter final : public ReportWriter {
public:
    explicit CsvWriter(OutputSink& out) : out_(out) {
        out_.write("deck,file,line,column,end_column,severity,code,name,interface,message,places,help,fix,"
                   "fingerprint\n");
    }

    void deck(const DeckResult& deck) override {
        if (deck.failed()) {
            const ResolvedPlace& place = deck.failure_place;
            row(deck.path, place.file.empty() ? deck.path : place.file, place.line, place.column, 0,
                "deck-not-read", deck.failure, deck.failure_help);
            return;
        }
        for (const Finding& finding : deck.findings) {
            const ResolvedPlace place = finding.places.empty() ? ResolvedPlace{} : finding.places.front();
            std::string fixes;
            for (const FixOffer& fix : finding.fixes) {
                if (!fixes.empty()) fixes += "; ";
                if (fix.applicability != FixAvailability::safe) fixes += "unsafe: ";
                fixes += fix.title;
            }
            Row row;
            row.add(deck.path).add(finding.places.empty() ? deck.path : place.file);
            row.add(place.line).add(uint64_t{place.column}).add(uint64_t{place.end_column});
            row.add(name(finding.severity)).add(finding.code).add(finding.name);
            row.add(finding.interface_id ? std::to_string(*finding.interface_id) : std::string());
            row.add(finding.message);
            row.add(std::max<uint64_t>(finding.place_count, finding.places.size()));
            row.add(finding.help).add(fixes).add(finding.fingerprint);
            out_.write(row.take());
        }
    }

    void end(const Summary& summary) override {
        if (summary.interrupted)
            row("", "", 0, 0, 0, "run-interrupted",
                "interrupted after " + std::to_string(summary.decks) + " of " +
                    std::to_string(summary.asked) + " decks",
                "");
    }

private:
    /// Something that no rule says.
    void row(std::string_view deck, std::string_view file, uint64_t line, uint64_t column,
             uint64_t end_column, std::string_view what, std::string_view message, std::string_view help) {
        Row row;
        row.add(deck).add(file).add(line).add(column).add(end_column);
        row.add("error").add("").add(what).add("").add(message).add("").add(help).add("").add("");
        out_.write(row.take());
    }

    OutputSink& out_;
};

} // namespace

std::unique_ptr<ReportWriter> csv_writer(OutputSink& out) {
    return std::make_unique<CsvWriter>(out);
}

} // namespace drawbead
