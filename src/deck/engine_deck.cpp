#include "deck/engine_deck.h"

#include "deck/number.h"

#include <string_view>

namespace drawbead {

namespace {

bool begins_with(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

/// NAME of NAME_0000.rad or NAME.rad.
std::string stem_of(const std::string& starter) {
    const auto without = [](std::string text, std::string_view ending) {
        if (text.size() > ending.size() &&
            std::string_view(text).substr(text.size() - ending.size()) == ending)
            text.resize(text.size() - ending.size());
        return text;
    };
    return without(without(starter, ".rad"), "_0000");
}

std::string numbered(const std::string& stem, int number) {
    std::string digits = std::to_string(number);
    return stem + '_' + std::string(4 - digits.size(), '0') + digits + ".rad";
}

/// Adds what one engine deck says.
void take(std::string_view rest, const std::string& path, EngineDeck& deck) {
    bool run = false, ended = false; // the next card is that of a /RUN; it was read
    while (!rest.empty()) {
        const std::size_t stop = rest.find('\n');
        std::string_view line = rest.substr(0, stop);
        rest.remove_prefix(stop == std::string_view::npos ? rest.size() : stop + 1);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        if (line.empty() || line[0] == '#' || line[0] == '$') continue;
        if (line[0] == '/') {
            run = begins_with(line, "/RUN/") && !ended;
            if (deck.mass_scaling.empty() &&
                (begins_with(line, "/DT/NODA/CST") || begins_with(line, "/DT/AMS")))
                deck.mass_scaling = std::string(trim(line)) + " in " + path;
            continue;
        }
        if (const double end = run ? parse_real(line).value : 0; end > deck.end.value_or(0)) {
            deck.end = end;
            deck.path = path;
            ended = true;
        }
        run = false;
    }
}

} // namespace

std::string engine_deck_path(const std::string& starter) {
    return numbered(stem_of(starter), 1);
}

std::optional<EngineDeck> read_engine_deck(const std::string& starter, FileReader& reader) {
    constexpr int most = 9999;
    const std::string stem = stem_of(starter);
    std::optional<EngineDeck> deck;
    for (int number = 1; number <= most; ++number) {
        const std::string path = numbered(stem, number);
        if (!reader.exists(path)) break;
        const Result<FileBytes> bytes = reader.read(path);
        if (!bytes) break;
        if (!deck) {
            deck.emplace();
            deck->path = path;
        }
        take(bytes->view(), path, *deck);
    }
    return deck;
}

} // namespace drawbead
