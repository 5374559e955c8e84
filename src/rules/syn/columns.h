#pragma once
// Where the text of a fixed-format line does not fit its columns.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

struct ColumnFault {
    enum class Kind : uint8_t {
        straddle,      ///< one number across a border
        several,       ///< a second number in one cell, which is not read
        tab,           ///< tabs, and what an editor shows is not what is read
        decimal_comma, ///< a comma for a point: it switches the line to free format
        over_width,    ///< a number behind the last column
        too_many,      ///< a number behind the last field of a free-format line
    };
    Kind kind = Kind::straddle;
    uint32_t begin = 0, end = 0; ///< bytes of the line, from 0
    uint32_t cell = 0;           ///< first column of the cell that it is about, from 1
};

/// Last columns of whole numbers and of reals on a card, from layout 51 on, and the width of a card.
inline constexpr std::array<uint32_t, 10> columns_of_ten{10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
inline constexpr std::array<uint32_t, 5> columns_of_twenty{20, 40, 60, 80, 100};
inline constexpr uint32_t card_width = 100;

/// The first fault of a line, if any. `ends`: last column of each cell, ascending; blank ones count as cells.
/// `width`: columns that are read at all. Numbers that touch because a cell is full are as they should be.
std::optional<ColumnFault> column_fault(std::string_view line, std::span<const uint32_t> ends,
                                        uint32_t width);

/// The line with every number in columns of its own, which have no fault: one line, or more for a list that
/// is too long for one. Empty where it is not clear which number belongs where. `read`: indices of the cells
/// that hold something in this layout; empty for a list, in which the order alone counts.
std::vector<std::string> fitted_line(std::string_view line, std::span<const uint32_t> ends, uint32_t width,
                                     std::span<const uint32_t> read);

} // namespace drawbead
