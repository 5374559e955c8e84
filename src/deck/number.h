#pragma once
// Numbers as Fortran and the solver's reader write them: 1.0D+3, 1.5-3 (exponent sign without a letter),
// .5, 3., 1.0E
#include <cstdint>
#include <string_view>

namespace drawbead {

enum class NumberState : uint8_t {
    blank,      ///< nothing but blanks and tabs
    ok,         ///< the whole cell is one number
    trailing,   ///< a number, then something else that the solver ignores
    garbage,    ///< does not begin with a number; the solver takes 0 and reports an error
    not_finite, ///< overflows a double (1e309), an integer over 2147483647, or NaN / Inf as text
};

struct RealCell {
    double value = 0;
    NumberState state = NumberState::blank;
};
struct IntegerCell {
    int64_t value = 0;
    NumberState state = NumberState::blank;
};

/// Reads the first number of a cell. Blanks and tabs around it do not count. Fast for plain cells, one exact
/// slow path for the rest; both agree to the last bit.
RealCell parse_real(std::string_view cell);
/// As the solver's reader: "1.5" is 1, "+7" is 7.
IntegerCell parse_integer(std::string_view cell);
/// The slow path of parse_real, for tests of the fast one.
RealCell parse_real_slow(std::string_view cell);

std::string_view trim(std::string_view);

} // namespace drawbead
