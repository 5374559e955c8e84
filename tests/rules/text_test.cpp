#include "rules/text.h"

#include <catch2/catch.hpp>

using namespace drawbead;

TEST_CASE("numbers have four significant digits, and whole ones all of theirs") {
    CHECK(number(0) == "0");
    CHECK(number(80) == "80");
    CHECK(number(0.5) == "0.5");
    CHECK(number(-2) == "-2");
    CHECK(number(42000) == "42000");
    CHECK(number(12345.6) == "12346");
    CHECK(number(3.14159265) == "3.142");
    CHECK(number(9.99996) == "10");
    CHECK(number(0.000123456) == "0.0001235");
    CHECK(number(1e-6) == "1e-06");
    CHECK(number(1.5e9) == "1.5e+09");
    CHECK(number(3.14159265, 2) == "3.1");
}

TEST_CASE("a quantity names its unit") {
    UnitSystem mm{1000, 1e-3, 1, "Mg", "mm", "s"};
    CHECK(quantity(80, mm, force_per_length_dimension) == "80 N/mm");
    CHECK(quantity(2.5, mm, length_dimension) == "2.5 mm");
    CHECK(quantity(2.5, mm, dimensionless) == "2.5");
}

TEST_CASE("counts agree with their noun") {
    CHECK(counted(1, "node") == "1 node");
    CHECK(counted(0, "node") == "0 nodes");
    CHECK(counted(2, "entry", "entries") == "2 entries");
}

TEST_CASE("what the user typed is shown as printable UTF-8, byte for byte") {
    CHECK(printable("a\tb\x01") == "a b ");
    CHECK(printable("µm") == "µm");
    CHECK(printable("\xb5m") == "?m");
    CHECK(printable("ab\xe2\x82") == "ab??");
    CHECK(printable("\xc0\xaf\xed\xa0\x80") == "?????");
    CHECK(quoted("abc") == "'abc'");
    CHECK(quoted("abcdef", 3) == "'abc…'");
}

TEST_CASE("long lists of ids are cut") {
    CHECK(listed(std::vector<int>{1, 2, 3}) == "1, 2, 3");
    CHECK(listed(std::vector<int>{1, 2, 3, 4}, 2) == "1, 2 and 2 more");
    CHECK(listed(std::vector<int>{}) == "");
}
