#include "report/info.h"

#include "report/json_report.h"
#include "report/table.h"
#include "report/text.h"

#include <charconv>

namespace drawbead {

namespace {

/// "Mg mm s", with "-" for what is not named.
std::string unit_text(const std::string& mass, const std::string& length, const std::string& time) {
    const auto shown = [](const std::string& unit) {
        return unit.empty() ? std::string("-") : terminal_safe(unit);
    };
    return shown(mass) + ' ' + shown(length) + ' ' + shown(time);
}

std::string length_text(double length, const std::string& unit) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, length, std::chars_format::general, 6);
    std::string text(digits, end.ptr);
    if (!unit.empty()) text += ' ' + terminal_safe(unit);
    return text;
}

} // namespace

void write_info_text(OutputSink& out, const DeckResult& deck) {
    const DeckInfo& info = deck.info;
    const std::string work = unit_text(info.mass_unit, info.length_unit, info.time_unit);
    const std::string input = unit_text(info.input_mass_unit, info.input_length_unit, info.input_time_unit);
    out.write(text_table({
        {"deck", terminal_safe(deck.path)},
        {"run", terminal_safe(info.run_name)},
        {"version", std::to_string(info.version)},
        {"units", work == input ? work : work + " (written in " + input + ")"},
        {"files", how_many(info.files.size(), "file") + ", " + how_many(info.bytes, "byte")},
        {"nodes", std::to_string(info.nodes)},
        {"shells4", std::to_string(info.shells4)},
        {"shells3", std::to_string(info.shells3)},
        {"solids", std::to_string(info.solids)},
        {"parts", std::to_string(info.parts)},
        {"drawbeads", std::to_string(info.interfaces.size())},
    }));
    if (!info.interfaces.empty()) {
        std::vector<std::vector<std::string>> rows{{"id", "nodes", "segments", "length", "title"}};
        for (const InterfaceSummary& one : info.interfaces)
            rows.push_back({std::to_string(one.id), std::to_string(one.nodes), std::to_string(one.segments),
                            length_text(one.length, info.length_unit), terminal_safe(one.title)});
        out.write("\n/INTER/TYPE8\n");
        out.write(text_table(rows, {0, 1, 2, 3}, 2));
    }
    if (info.files.size() > 1) {
        out.write("\nfiles\n");
        for (const std::string& file : info.files)
            out.write("  " + terminal_safe(file) + '\n');
    }
    if (!info.keywords.empty()) {
        std::vector<std::vector<std::string>> rows;
        rows.reserve(info.keywords.size());
        for (const auto& [keyword, blocks] : info.keywords)
            rows.push_back({std::to_string(blocks), terminal_safe(keyword)});
        out.write("\nkeywords\n");
        out.write(text_table(rows, {0}, 2));
    }
}

void write_info_json(OutputSink& out, const DeckResult& deck) {
    JsonWriter json(out);
    write_info(json, deck.info);
}

} // namespace drawbead
