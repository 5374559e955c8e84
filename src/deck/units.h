#pragma once
// Units of a deck: `/BEGIN` input and work systems, `/UNIT/id`, and the factors between them.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace drawbead {

/// Exponents of mass, length, time.
struct Dimension {
    int8_t mass = 0, length = 0, time = 0;
    friend constexpr bool operator==(Dimension, Dimension) = default;
};
inline constexpr Dimension dimensionless{0, 0, 0};
inline constexpr Dimension length_dimension{0, 1, 0};
inline constexpr Dimension time_dimension{0, 0, 1};
inline constexpr Dimension force_dimension{1, 1, -2};
inline constexpr Dimension force_per_length_dimension{1, 0, -2};
inline constexpr Dimension pressure_dimension{1, -1, -2};
inline constexpr Dimension density_dimension{1, -3, 0};

struct UnitSystem {
    double mass = 1, length = 1, time = 1;         ///< factors to kg, m, s
    std::string mass_name, length_name, time_name; ///< as written, empty when blank
};

/// Factor of a unit code (SI prefix + g, m or s; "mus", "Mg", "µm" …) or of a number, to kg, m or s. `base`
/// is the letter that the code must end in. Empty when not understood or not a positive finite number.
std::optional<double> unit_factor(std::string_view code, char base);

/// What a value of dimension d, written in `from`, must be multiplied by to be in `to`.
double conversion_factor(const UnitSystem& from, const UnitSystem& to, Dimension d);

/// Name of the unit of dimension d in a system, e.g. "N/mm" in Mg-mm-s, or "Mg mm s^-2"-like text elsewhere;
/// "" for dimensionless or unnamed units.
std::string unit_name(const UnitSystem&, Dimension d);

} // namespace drawbead
