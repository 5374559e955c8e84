#include "deck/number.h"

#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>

using namespace drawbead;

namespace {
bool same_bits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}
} // namespace

TEST_CASE("reals as the solver reads them") {
    struct Case {
        const char* text;
        double value;
        NumberState state;
    };
    const Case cases[] = {{"1.0D5", 1e5, NumberState::ok},
                          {" 1.0d5 ", 1e5, NumberState::ok},
                          {"1.5+3", 1500, NumberState::ok},
                          {"-2-2", -0.02, NumberState::ok},
                          {"1.5-3", 0.0015, NumberState::ok},
                          {".5", 0.5, NumberState::ok},
                          {"3.", 3, NumberState::ok},
                          {"1.0E", 1, NumberState::ok},
                          {"+7", 7, NumberState::ok},
                          {"-0", -0.0, NumberState::ok},
                          {"", 0, NumberState::blank},
                          {" \t ", 0, NumberState::blank},
                          {"1 2", 1, NumberState::trailing},
                          {"abc", 0, NumberState::garbage},
                          {"1.0.2", 0, NumberState::garbage},
                          {"12mm", 0, NumberState::garbage},
                          {"-", 0, NumberState::garbage},
                          {".", 0, NumberState::garbage},
                          {"1e309", 0, NumberState::not_finite},
                          {"NaN", 0, NumberState::not_finite},
                          {"-Inf", 0, NumberState::not_finite},
                          {"1e-400", 0, NumberState::ok},
                          {"4.9e-324", 4.9e-324, NumberState::ok},
                          {"1D+3", 1000, NumberState::ok},
                          {"0.1e1", 1, NumberState::ok},
                          {"1.0E+", 0, NumberState::garbage}};
    for (const Case& c : cases) {
        INFO(c.text);
        CHECK(same_bits(parse_real(c.text).value, c.value));
        CHECK(parse_real(c.text).state == c.state);
    }
}

TEST_CASE("the fast path, the slow path and the C library agree to the last bit") {
    std::mt19937_64 random(11);
    char text[64];
    for (int i = 0; i < 200000; ++i) {
        double value;
        const uint64_t bits = random();
        if (i % 3 == 0) {
            std::memcpy(&value, &bits, sizeof value);
            if (!(std::abs(value) < 1e300)) continue;
        } else {
            value = (static_cast<double>(bits >> 11) - 4e15) * (i % 2 ? 1e-12 : 1e-9);
        }
        const char* formats[] = {"%.15g", "%.17g", "%.6f", "%.13E", "%.3f", "%20.12f"};
        std::snprintf(text, sizeof text, formats[i % 6], value);
        const double expected = std::strtod(text, nullptr);
        const RealCell fast = parse_real(text), slow = parse_real_slow(text);
        INFO(text);
        REQUIRE(fast.state == NumberState::ok);
        REQUIRE(same_bits(fast.value, expected));
        REQUIRE(same_bits(slow.value, expected));
    }
}

TEST_CASE("integers") {
    CHECK(parse_integer(" 42 ").value == 42);
    CHECK(parse_integer("-7").value == -7);
    CHECK(parse_integer("+7").value == 7);
    CHECK(parse_integer("1.5").value == 1);
    CHECK(parse_integer("1.5").state == NumberState::ok);
    CHECK(parse_integer("1 2 3").value == 1);
    CHECK(parse_integer("1 2 3").state == NumberState::trailing);
    CHECK(parse_integer("2147483647").value == 2147483647);
    CHECK(parse_integer("2147483648").state == NumberState::not_finite);
    CHECK(parse_integer("99999999999999999999").state == NumberState::not_finite);
    CHECK(parse_integer("x").state == NumberState::garbage);
    CHECK(parse_integer("").state == NumberState::blank);
}
