#include "deck/number.h"

#include <array>
#include <cmath>
#include <fast_float/fast_float.h>
#include <string>

namespace drawbead {

namespace {

/// Old editors end a file with the byte 0x1a.
constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\x1a';
}
constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
constexpr bool is_sign(char c) {
    return c == '+' || c == '-';
}
constexpr bool is_exponent_letter(char c) {
    return c == 'e' || c == 'E' || c == 'd' || c == 'D';
}
constexpr char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
}

/// The parts of a number at the start of a text.
struct Shape {
    std::size_t mantissa_end = 0;                     ///< sign, digits, point
    std::size_t digits = 0;                           ///< in the mantissa
    std::size_t exponent_begin = 0, exponent_end = 0; ///< sign and digits of the exponent, without its letter
    std::size_t end = 0;
};

Shape shape_of(std::string_view text) {
    Shape shape;
    std::size_t at = 0;
    if (at < text.size() && is_sign(text[at])) ++at;
    bool point = false;
    for (; at < text.size(); ++at) {
        if (is_digit(text[at]))
            ++shape.digits;
        else if (text[at] == '.' && !point)
            point = true;
        else
            break;
    }
    shape.mantissa_end = shape.exponent_begin = shape.exponent_end = shape.end = at;
    if (shape.digits == 0 || at == text.size()) return shape;
    const bool letter = is_exponent_letter(text[at]);
    if (!letter && !is_sign(text[at])) return shape;
    std::size_t from = at + (letter ? 1 : 0);
    std::size_t to = from;
    if (to < text.size() && is_sign(text[to])) ++to;
    const std::size_t first_digit = to;
    while (to < text.size() && is_digit(text[to]))
        ++to;
    if (to == first_digit) {
        // "1.0E" is 1.0; "1.0-" is 1.0 followed by something else.
        if (letter && to == from) shape.end = from;
        return shape;
    }
    shape.exponent_begin = from;
    shape.exponent_end = shape.end = to;
    return shape;
}

bool is_not_finite_word(std::string_view text) {
    std::string word;
    for (std::size_t i = !text.empty() && is_sign(text[0]) ? 1 : 0; i < text.size() && word.size() < 9; ++i)
        word.push_back(lower(text[i]));
    return word.rfind("nan", 0) == 0 || word == "inf" || word.rfind("infinit", 0) == 0;
}

/// What follows a number in its cell: nothing, more text after a blank, or text that sticks to it.
NumberState state_after(std::string_view rest) {
    if (rest.empty()) return NumberState::ok;
    return is_blank(rest[0]) ? NumberState::trailing : NumberState::garbage;
}

/// Value of the number described by `shape`, correctly rounded.
double exact_value(std::string_view text, const Shape& shape) {
    std::string plain;
    plain.reserve(shape.end + 2);
    std::size_t from = 0;
    if (text[0] == '+') from = 1;
    plain.append(text.substr(from, shape.mantissa_end - from));
    if (shape.exponent_end > shape.exponent_begin) {
        plain.push_back('e');
        plain.append(text.substr(shape.exponent_begin, shape.exponent_end - shape.exponent_begin));
    }
    double value = 0;
    fast_float::from_chars(plain.data(), plain.data() + plain.size(), value);
    return value;
}

constexpr std::array<double, 23> powers_of_ten{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                               1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                               1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// A cell that is one plain number with at most 15 digits and a small exponent: one exact multiplication or
/// division is then correctly rounded. False when it is anything else.
bool parse_plain(std::string_view text, double& value) {
    if (text.size() > 24) return false;
    std::size_t at = 0;
    const bool negative = text[0] == '-';
    if (is_sign(text[0])) ++at;
    uint64_t mantissa = 0;
    int digits = 0, exponent = 0;
    for (; at < text.size() && is_digit(text[at]); ++at, ++digits)
        mantissa = mantissa * 10 + static_cast<unsigned>(text[at] - '0');
    if (at < text.size() && text[at] == '.') {
        for (++at; at < text.size() && is_digit(text[at]); ++at, ++digits, --exponent)
            mantissa = mantissa * 10 + static_cast<unsigned>(text[at] - '0');
    }
    if (digits == 0 || digits > 15) return false;
    if (at < text.size()) {
        if (is_exponent_letter(text[at])) ++at;
        if (at == text.size()) return false;
        const bool minus = text[at] == '-';
        if (is_sign(text[at])) ++at;
        if (at == text.size() || text.size() - at > 3) return false;
        int written = 0;
        for (; at < text.size() && is_digit(text[at]); ++at)
            written = written * 10 + (text[at] - '0');
        exponent += minus ? -written : written;
    }
    if (at != text.size() || exponent < -22 || exponent > 22) return false;
    const auto whole = static_cast<double>(mantissa);
    const double power = powers_of_ten[static_cast<std::size_t>(exponent < 0 ? -exponent : exponent)];
    const double magnitude = exponent < 0 ? whole / power : whole * power;
    value = negative ? -magnitude : magnitude;
    return true;
}

} // namespace

std::string_view trim(std::string_view text) {
    while (!text.empty() && is_blank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back()))
        text.remove_suffix(1);
    return text;
}

RealCell parse_real_slow(std::string_view cell) {
    const std::string_view text = trim(cell);
    if (text.empty()) return {};
    const Shape shape = shape_of(text);
    if (shape.digits == 0)
        return {0, is_not_finite_word(text) ? NumberState::not_finite : NumberState::garbage};
    const NumberState state = state_after(text.substr(shape.end));
    if (state == NumberState::garbage) return {0, state};
    const double value = exact_value(text, shape);
    if (!std::isfinite(value)) return {0, NumberState::not_finite};
    return {value, state};
}

RealCell parse_real(std::string_view cell) {
    const std::string_view text = trim(cell);
    if (text.empty()) return {};
    if (double value = 0; parse_plain(text, value)) return {value, NumberState::ok};
    return parse_real_slow(text);
}

IntegerCell parse_integer(std::string_view cell) {
    const std::string_view text = trim(cell);
    if (text.empty()) return {};
    const Shape shape = shape_of(text);
    if (shape.digits == 0)
        return {0, is_not_finite_word(text) ? NumberState::not_finite : NumberState::garbage};
    const NumberState state = state_after(text.substr(shape.end));
    if (state == NumberState::garbage) return {0, state};
    std::size_t at = is_sign(text[0]) ? 1 : 0;
    int64_t value = 0;
    constexpr int64_t largest = 2147483647;
    for (; at < text.size() && is_digit(text[at]); ++at) {
        value = value * 10 + (text[at] - '0');
        if (value > largest) return {0, NumberState::not_finite};
    }
    return {text[0] == '-' ? -value : value, state};
}

} // namespace drawbead
