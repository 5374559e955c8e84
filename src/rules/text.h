#pragma once
// How messages write numbers, units, ids and what the user typed. Never depends on the locale.
#include "deck/units.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace drawbead {

/// At most `digits` significant digits (more for whole numbers below 1e7), no trailing zeros: "0.5", "42000",
/// "4.8e-07".
std::string number(double value, int digits = 4);

/// A number with the name of its unit: "80 N/mm".
std::string quantity(double value, const UnitSystem&, Dimension, int digits = 4);

/// "1 node", "412 nodes", "2 entries" (give the plural where it is not singular + "s").
std::string counted(uint64_t count, std::string_view singular, std::string_view plural = {});

/// What the user typed, between single quotes, at most `most` bytes, in printable UTF-8.
std::string quoted(std::string_view text, std::size_t most = 60);

/// Unicode code points, a byte that is no UTF-8 being one.
std::size_t character_count(std::string_view text);

/// The same text byte for byte, except that control bytes and bytes that are no UTF-8 become blanks and
/// question marks.
std::string printable(std::string_view text);

/// "11, 12, 13 and 4 more": at most `most` of them are written out.
template <class Ids>
std::string listed(const Ids& ids, std::size_t most = 5) {
    std::string text;
    std::size_t written = 0;
    for (const auto& id : ids) {
        if (written == most) break;
        if (written++ != 0) text += ", ";
        text += std::to_string(id);
    }
    const std::size_t rest = static_cast<std::size_t>(ids.size()) - written;
    if (rest != 0) text += " and " + std::to_string(rest) + " more";
    return text;
}

} // namespace drawbead
