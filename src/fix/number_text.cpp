#include "fix/number_text.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace drawbead {

namespace {

/// Without zeros that say nothing: ".5" and "1e-7".
std::string shortened(std::string text) {
    const std::size_t sign = text[0] == '-' ? 1 : 0;
    if (text.compare(sign, 2, "0.") == 0) text.erase(sign, 1);
    if (const std::size_t e = text.find('e'); e != std::string::npos)
        while (e + 3 < text.size() && text[e + 2] == '0')
            text.erase(e + 2, 1);
    return text;
}

} // namespace

std::string real_text(double value, uint32_t width) {
    char buffer[64];
    const auto pointed = [&](std::to_chars_result end) {
        std::string text(buffer, end.ptr);
        if (text.find_first_of(".en") == std::string::npos) text += ".0";
        return text;
    };
    std::string text = pointed(std::to_chars(buffer, buffer + sizeof buffer, value));
    if (text.size() <= width) return text;
    text = shortened(text);
    if (text.size() > width)
        text = shortened(
            pointed(std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific)));
    // Where that is too long: as many digits as fit, but no fewer than six.
    for (int digits = 16; text.size() > width && digits >= 6; --digits)
        text = shortened(pointed(
            std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits)));
    return text.size() > width ? std::string{} : text;
}

std::string cell_text(const Deck& deck, const Block& block, Dimension dimension, double value,
                      uint32_t width) {
    const std::optional<double> factor = deck.factor(block.scope, block.unit, dimension);
    if (!factor || *factor == 0) return {};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double written = value / *factor;
    std::string best;
    double error = infinity;
    for (const double near :
         {written, std::nextafter(written, -infinity), std::nextafter(written, infinity)}) {
        std::string text = real_text(near, width);
        const double off = std::abs(parse_real(text).value * *factor - value);
        if (text.empty() || off >= error) continue;
        error = off;
        best = std::move(text);
    }
    return best;
}

} // namespace drawbead
