#include "rules/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace drawbead {

std::string number(double value, int digits) {
    if (!std::isfinite(value)) return fmt::format("{}", value);
    if (value == 0) return "0";
    const double size = std::abs(value);
    if (size < 1e-4 || size >= 1e7) {
        std::string text = fmt::format("{:.{}e}", value, digits - 1);
        const std::size_t e = text.find('e');
        std::string mantissa = text.substr(0, e);
        if (mantissa.find('.') != std::string::npos) {
            while (mantissa.back() == '0')
                mantissa.pop_back();
            if (mantissa.back() == '.') mantissa.pop_back();
        }
        return mantissa + text.substr(e);
    }
    const int decimals = std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(size))));
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (text.find('.') != std::string::npos) {
        while (text.back() == '0')
            text.pop_back();
        if (text.back() == '.') text.pop_back();
    }
    return text;
}

std::string quantity(double value, const UnitSystem& units, Dimension dimension, int digits) {
    const std::string unit = unit_name(units, dimension);
    return unit.empty() ? number(value, digits) : number(value, digits) + " " + unit;
}

std::string counted(uint64_t count, std::string_view singular, std::string_view plural) {
    if (count == 1) return fmt::format("1 {}", singular);
    return plural.empty() ? fmt::format("{} {}s", count, singular) : fmt::format("{} {}", count, plural);
}

namespace {

/// Length of the UTF-8 sequence that starts at text[0], 0 when it is none.
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    // Overlong forms, surrogates and what lies beyond U+10FFFF.
    if ((lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xed && byte(1) > 0x9f) ||
        (lead == 0xf0 && byte(1) < 0x90) || (lead == 0xf4 && byte(1) > 0x8f))
        return 0;
    return length;
}

} // namespace

std::size_t character_count(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); ++count)
        i += std::max<std::size_t>(sequence_length(text.substr(i)), 1);
    return count;
}

std::string printable(std::string_view text) {
    std::string out(text);
    for (std::size_t i = 0; i < out.size();) {
        const std::size_t length = sequence_length(std::string_view(out).substr(i));
        if (length == 0)
            out[i] = '?';
        else if (length == 1 && (static_cast<unsigned char>(out[i]) < 0x20 || out[i] == 0x7f))
            out[i] = ' ';
        i += std::max<std::size_t>(length, 1);
    }
    return out;
}

std::string quoted(std::string_view text, std::size_t most) {
    if (text.size() <= most) return "'" + printable(text) + "'";
    return "'" + printable(text.substr(0, most)) + "…'";
}

} // namespace drawbead
