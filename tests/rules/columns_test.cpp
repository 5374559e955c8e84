#include "rules/syn/columns.h"

#include <catch2/catch.hpp>

#include <array>
#include <string>

using namespace drawbead;
using Kind = ColumnFault::Kind;

namespace {

constexpr std::array<uint32_t, 10> tens{10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
constexpr std::array<uint32_t, 5> twenties{20, 40, 60, 80, 100};

std::optional<Kind> integers(std::string_view line) {
    const auto fault = column_fault(line, tens, 100);
    return fault ? std::optional(fault->kind) : std::nullopt;
}
std::optional<Kind> reals(std::string_view line) {
    const auto fault = column_fault(line, twenties, 100);
    return fault ? std::optional(fault->kind) : std::nullopt;
}

} // namespace

TEST_CASE("numbers in their columns are sound, however they are aligned") {
    CHECK_FALSE(integers("       101       102       103"));
    CHECK_FALSE(integers("101       102       103"));
    CHECK_FALSE(integers("    101      102     103   "));
    CHECK_FALSE(integers(""));
    CHECK_FALSE(integers("   \t  "));
    CHECK_FALSE(reals("                 80.                100.                  2.                  0.      "
                      "            0."));
    CHECK_FALSE(reals("80.                 100."));
    CHECK_FALSE(integers("     &node       102"));
}

TEST_CASE("numbers that touch because a cell is full are sound") {
    CHECK_FALSE(integers("100000000110000000021000000003"));
    CHECK_FALSE(integers("         51000000002"));
    CHECK_FALSE(integers("1000000002         51000000002"));
    CHECK_FALSE(reals("               160.0-1.5258789062500E-05"));
    CHECK_FALSE(reals("               160.0-1.525878906250E-05 "));
    CHECK_FALSE(reals("-1.5258789062500E-05-1.5258789062500E-05"));
}

TEST_CASE("a number across a border is told with its place") {
    CHECK(integers("       101         102") == Kind::straddle);
    CHECK(integers("         101       102") == Kind::straddle);
    CHECK(reals("                  80.                100.") == Kind::straddle);
    CHECK(reals("                  -1.5E-3") == Kind::straddle);
    const auto fault = column_fault("         101       102", tens, 100);
    REQUIRE(fault);
    CHECK(fault->begin == 9);
    CHECK(fault->end == 12);
    CHECK(fault->cell == 1);
}

TEST_CASE("a second number in a cell is told, a remark behind the values is not") {
    CHECK(integers("   101 102       103") == Kind::several);
    CHECK(integers("1 2 3") == Kind::several);
    CHECK_FALSE(integers("       101   # 7 nodes"));
    CHECK_FALSE(integers("         2         1                   2    incremental"));
    const auto fault = column_fault("       101   102 103", tens, 100);
    REQUIRE(fault);
    CHECK(fault->begin == 17);
    CHECK(fault->cell == 11);
}

TEST_CASE("tabs are told only where they mislead") {
    CHECK(integers("101\t102\t103") == Kind::tab);
    CHECK_FALSE(integers("       101       102\t"));
    CHECK_FALSE(integers("\t 101"));
    CHECK(integers("\t      101") == Kind::tab);
    CHECK(reals("\t\t\t80.") == Kind::tab);
}

TEST_CASE("decimal commas are told from free format") {
    CHECK(reals("                80,0               100,0                 2,0") == Kind::decimal_comma);
    CHECK(reals("80,5 100,5") == Kind::decimal_comma);
    CHECK(reals("                80,0               100                 2") == Kind::decimal_comma);
    CHECK_FALSE(reals("80,100,2,0,0"));
    CHECK_FALSE(reals("80., 100., 2."));
    CHECK_FALSE(reals("80, 100, 2"));
    CHECK_FALSE(integers("5,7,,2"));
    CHECK_FALSE(integers("5 , 7 , , 2"));
}

TEST_CASE("numbers behind the last field of a free-format line are told, with their place") {
    CHECK_FALSE(integers("1,2,3,4,5,6,7,8,9,10"));
    CHECK_FALSE(integers("1,2,3,4,5,6,7,8,9,10 and a remark"));
    CHECK_FALSE(integers("1,2,3,4,5,6,7,8,9,10,"));
    const auto fault = column_fault("1,2 3,,5,6,7,8,9,10, 11 ,12", tens, 100);
    REQUIRE(fault);
    CHECK(fault->kind == Kind::too_many);
    CHECK((fault->begin == 21 && fault->end == 23));
    CHECK(reals("1.,2.,3.,4.,5.,6.") == Kind::too_many);
}

TEST_CASE("numbers behind the last column are told, text is not") {
    const std::string full(100, ' ');
    CHECK(integers(full + "  1011") == Kind::over_width);
    CHECK_FALSE(integers(full + " end of the line"));
    const std::string eleven = "         1         2         3         4         5         6         7       "
                               "  8         9        10        11";
    CHECK(integers(eleven) == Kind::over_width);
}
