#include "findings/finding.h"
#include "findings/report.h"

#include <array>

namespace drawbead {

std::string_view name(Severity severity) {
    constexpr std::array<std::string_view, 3> names{"info", "warning", "error"};
    return names[static_cast<std::size_t>(severity)];
}

std::string_view name(FixAvailability fix) {
    constexpr std::array<std::string_view, 4> names{"none", "unsafe", "sometimes safe", "safe"};
    return names[static_cast<std::size_t>(fix)];
}

std::optional<Severity> severity_from(std::string_view text) {
    for (const Severity s : {Severity::info, Severity::warning, Severity::error})
        if (name(s) == text) return s;
    return std::nullopt;
}

namespace {

/// FNV-1a, 64 bits: short, stable, good enough for a few thousand findings.
class Hash {
public:
    void bytes(std::string_view text) {
        for (const char c : text)
            byte(static_cast<unsigned char>(c));
        byte(0xff);
    }
    void number(int64_t v) {
        for (int i = 0; i < 8; ++i)
            byte(static_cast<unsigned char>(static_cast<uint64_t>(v) >> (8 * i)));
    }
    std::string hex() const {
        std::string text(16, '0');
        for (int i = 0; i < 16; ++i)
            text[static_cast<std::size_t>(i)] = "0123456789abcdef"[(state_ >> (60 - 4 * i)) & 15];
        return text;
    }

private:
    void byte(unsigned char b) { state_ = (state_ ^ b) * 0x100000001b3u; }
    uint64_t state_ = 0xcbf29ce484222325u;
};

} // namespace

std::string fingerprint(std::string_view code, std::optional<int64_t> interface_id, const Entities& entities,
                        std::string_view discriminator) {
    Hash hash;
    hash.bytes(code);
    hash.number(interface_id.value_or(-1));
    for (const EntityList* list : {&entities.nodes, &entities.segments, &entities.elements}) {
        hash.number(static_cast<int64_t>(list->count));
        hash.number(static_cast<int64_t>(list->digest));
    }
    hash.bytes(discriminator);
    return hash.hex();
}

Summary summarise(const std::vector<DeckResult>& decks) {
    Summary summary;
    summary.decks = decks.size();
    for (const DeckResult& deck : decks) {
        if (deck.failed()) ++summary.failed;
        summary.interfaces += deck.info.interfaces.size();
        summary.suppressed += deck.suppressed;
        summary.known += deck.known;
        for (const BaselineEntry& entry : deck.gone)
            summary.gone += entry.count;
        for (const Finding& finding : deck.findings) {
            switch (finding.severity) {
            case Severity::error:
                ++summary.errors;
                break;
            case Severity::warning:
                ++summary.warnings;
                break;
            case Severity::info:
                ++summary.infos;
                break;
            }
        }
    }
    return summary;
}

} // namespace drawbead
