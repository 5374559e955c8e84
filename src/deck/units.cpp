#include "deck/units.h"

#include "deck/number.h"

#include <array>
#include <cmath>
#include <cstdlib>

namespace drawbead {

namespace {

struct Prefix {
    std::string_view text;
    double factor;
};
constexpr std::array<Prefix, 25> prefixes{
    {{"y", 1e-24},   {"z", 1e-21}, {"a", 1e-18}, {"f", 1e-15},       {"p", 1e-12},
     {"n", 1e-9},    {"mu", 1e-6}, {"u", 1e-6},  {"\xc2\xb5", 1e-6}, {"\xce\xbc", 1e-6},
     {"\xb5", 1e-6}, {"m", 1e-3},  {"c", 1e-2},  {"d", 1e-1},        {"da", 1e1},
     {"h", 1e2},     {"k", 1e3},   {"K", 1e3},   {"M", 1e6},         {"G", 1e9},
     {"T", 1e12},    {"P", 1e15},  {"E", 1e18},  {"Z", 1e21},        {"Y", 1e24}}};

std::optional<double> prefix_factor(std::string_view text) {
    if (text.empty()) return 1.0;
    for (const Prefix& prefix : prefixes)
        if (prefix.text == text) return prefix.factor;
    return std::nullopt;
}

/// SI prefix of a power of 1000, for derived units.
std::optional<std::string_view> prefix_of(double factor) {
    constexpr std::array<Prefix, 9> engineering{{{"n", 1e-9},
                                                 {"u", 1e-6},
                                                 {"m", 1e-3},
                                                 {"", 1e0},
                                                 {"k", 1e3},
                                                 {"M", 1e6},
                                                 {"G", 1e9},
                                                 {"T", 1e12},
                                                 {"P", 1e15}}};
    for (const Prefix& prefix : engineering)
        if (std::abs(factor / prefix.factor - 1) < 1e-9) return prefix.text;
    return std::nullopt;
}

double integer_power(double base, int exponent) {
    double result = 1;
    for (int i = 0; i < std::abs(exponent); ++i)
        result *= base;
    return exponent < 0 ? 1 / result : result;
}

/// The name as written when it is a code, else one made from the factor: a `/BEGIN` card may hold "1.0".
std::string base_name(const std::string& written, double factor, char letter) {
    if (written.empty()) return "";
    if (parse_real(written).state == NumberState::garbage) return written;
    const double relative = letter == 'g' ? factor * 1000 : factor;
    if (letter == 'g' && std::abs(factor - 1) < 1e-9) return "kg";
    if (letter == 'm' && std::abs(factor / 1e-2 - 1) < 1e-9) return "cm";
    const auto prefix = prefix_of(relative);
    return prefix ? std::string(*prefix) + letter : "";
}

std::string power_name(const std::string& base, int exponent) {
    if (exponent == 1) return base;
    return base + "^" + std::to_string(exponent);
}

} // namespace

std::optional<double> unit_factor(std::string_view code, char base) {
    const std::string_view text = trim(code);
    if (text.empty()) return std::nullopt;
    const RealCell number = parse_real(text);
    if (number.state == NumberState::ok) {
        if (number.value > 0) return number.value;
        return std::nullopt;
    }
    if (text.back() != base) return std::nullopt;
    const auto prefix = prefix_factor(text.substr(0, text.size() - 1));
    if (!prefix) return std::nullopt;
    return base == 'g' ? *prefix / 1000 : *prefix;
}

double conversion_factor(const UnitSystem& from, const UnitSystem& to, Dimension d) {
    // A ratio of equal factors is exactly 1, so decks in one system are not changed by a rounding.
    return integer_power(from.mass / to.mass, d.mass) * integer_power(from.length / to.length, d.length) *
           integer_power(from.time / to.time, d.time);
}

std::string unit_name(const UnitSystem& units, Dimension d) {
    const std::string mass = base_name(units.mass_name, units.mass, 'g');
    const std::string length = base_name(units.length_name, units.length, 'm');
    const std::string time = base_name(units.time_name, units.time, 's');
    if (mass.empty() || length.empty() || time.empty()) return "";
    if (d == length_dimension) return length;
    if (d == time_dimension) return time;
    if (d.time == -2 && d.mass == 1) {
        // Forces and what is made of forces and lengths are named by newton and pascal.
        const double newton = units.mass * units.length / (units.time * units.time);
        const auto force_prefix = prefix_of(newton);
        if (force_prefix) {
            const std::string force = std::string(*force_prefix) + "N";
            if (d == force_dimension) return force;
            if (d == force_per_length_dimension) return force + "/" + length;
            if (d == pressure_dimension) {
                const auto pressure_prefix = prefix_of(newton / (units.length * units.length));
                return pressure_prefix ? std::string(*pressure_prefix) + "Pa" : force + "/" + length + "^2";
            }
            if (d.length == 2) return force + " " + length;
        }
    }
    std::string text;
    const std::array<std::pair<const std::string*, int>, 3> parts{
        {{&mass, d.mass}, {&length, d.length}, {&time, d.time}}};
    for (const auto& [base, exponent] : parts) {
        if (exponent == 0) continue;
        if (!text.empty()) text += " ";
        text += power_name(*base, exponent);
    }
    return text;
}

} // namespace drawbead
