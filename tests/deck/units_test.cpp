#include "deck/units.h"

#include <catch2/catch.hpp>

using namespace drawbead;

TEST_CASE("unit codes are SI prefixes and a base letter, or numbers") {
    CHECK(*unit_factor("Mg", 'g') == 1000);
    CHECK(*unit_factor("kg", 'g') == 1);
    CHECK(*unit_factor("g", 'g') == 1e-3);
    CHECK(*unit_factor("mm", 'm') == 1e-3);
    CHECK(*unit_factor("m", 'm') == 1);
    CHECK(*unit_factor("cm", 'm') == 1e-2);
    CHECK(*unit_factor("mus", 's') == 1e-6);
    CHECK(*unit_factor("\xc2\xb5s", 's') == 1e-6);
    CHECK(*unit_factor("ms", 's') == 1e-3);
    CHECK(*unit_factor("1.D0", 's') == 1);
    CHECK(*unit_factor(" 1.0 ", 'm') == 1);
    CHECK_FALSE(unit_factor("tonne", 'g'));
    CHECK_FALSE(unit_factor("mm", 's'));
    CHECK_FALSE(unit_factor("0", 'm'));
    CHECK_FALSE(unit_factor("-1", 'm'));
    CHECK_FALSE(unit_factor("", 'm'));
}

TEST_CASE("derived units have the names that engineers use") {
    const UnitSystem mm{1000, 1e-3, 1, "Mg", "mm", "s"};
    CHECK(unit_name(mm, force_dimension) == "N");
    CHECK(unit_name(mm, force_per_length_dimension) == "N/mm");
    CHECK(unit_name(mm, pressure_dimension) == "MPa");
    CHECK(unit_name(mm, length_dimension) == "mm");
    const UnitSystem si{1, 1, 1, "kg", "m", "s"};
    CHECK(unit_name(si, force_per_length_dimension) == "N/m");
    CHECK(unit_name(si, pressure_dimension) == "Pa");
    const UnitSystem crash{1, 1e-3, 1e-3, "kg", "mm", "ms"};
    CHECK(unit_name(crash, force_dimension) == "kN");
    CHECK(unit_name(crash, pressure_dimension) == "GPa");
    const UnitSystem numbers{1, 1, 1, "1.0", "1.0", "1.D0"};
    CHECK(unit_name(numbers, force_dimension) == "N");
    CHECK(unit_name(numbers, length_dimension) == "m");
    CHECK(unit_name(UnitSystem{}, length_dimension).empty());
    CHECK(unit_name(mm, density_dimension) == "Mg mm^-3");
}

TEST_CASE("equal systems convert by exactly 1") {
    const UnitSystem odd{0.3, 0.7, 1.1, "0.3", "0.7", "1.1"};
    CHECK(conversion_factor(odd, odd, pressure_dimension) == 1);
    const UnitSystem mm{1000, 1e-3, 1, "Mg", "mm", "s"}, si{1, 1, 1, "kg", "m", "s"};
    CHECK(conversion_factor(mm, si, pressure_dimension) == Approx(1e6));
    CHECK(conversion_factor(mm, si, force_per_length_dimension) == Approx(1e3));
}
