#include "deck/engine_deck.h"

#include <catch2/catch.hpp>

using namespace drawbead;

namespace {

std::optional<EngineDeck> engine(const std::string& text) {
    MemoryReader reader;
    reader.add("folder/NAME_0001.rad", text);
    return read_engine_deck("folder/NAME_0000.rad", reader);
}

} // namespace

TEST_CASE("the name of the engine deck follows from that of the starter deck") {
    CHECK(engine_deck_path("a/NAME_0000.rad") == "a/NAME_0001.rad");
    CHECK(engine_deck_path("NAME.rad") == "NAME_0001.rad");
    CHECK(engine_deck_path("NAME") == "NAME_0001.rad");
    CHECK(engine_deck_path("_0000.rad") == "_0000_0001.rad");
}

TEST_CASE("the end of the run and what adds mass") {
    const auto plain = engine("#RADIOSS ENGINE\n/RUN/NAME/1\n# end\n            1.5E-3\n/VERS/2022\n");
    REQUIRE(plain);
    CHECK(plain->end == 1.5e-3);
    CHECK(plain->mass_scaling.empty());
    const auto scaled =
        engine("/DT/NODA/CST/0  \r\n 0.67 1.E-6\r\n/RUN/NAME/1\r\n 2.0\r\n/RUN/NAME/2\r\n 3.0\r\n");
    REQUIRE(scaled);
    CHECK(scaled->end == 2);
    CHECK(scaled->mass_scaling == "/DT/NODA/CST/0 in folder/NAME_0001.rad");
    const auto none = engine("/RUN/NAME/1\n/STOP\n 7\n");
    REQUIRE(none);
    CHECK_FALSE(none->end);
    CHECK_FALSE(engine("/RUN/NAME/1\nnonsense\n")->end);
    CHECK_FALSE(engine("")->end);
    MemoryReader restarted;
    restarted.add("NAME_0001.rad", "/RUN/NAME/1\n 1.0\n");
    restarted.add("NAME_0002.rad", "/RUN/NAME/2\n 4.0\n/DT/AMS\n 0.67 1.E-6\n");
    restarted.add("NAME_0004.rad", "/RUN/NAME/4\n 9.0\n");
    const auto last = read_engine_deck("NAME_0000.rad", restarted);
    REQUIRE(last);
    CHECK(last->end == 4);
    CHECK(last->path == "NAME_0002.rad");
    CHECK(last->mass_scaling == "/DT/AMS in NAME_0002.rad");
    MemoryReader empty;
    CHECK_FALSE(read_engine_deck("NAME_0000.rad", empty));
}
