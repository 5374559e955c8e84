#include "base/nearest.h"
#include "cli/paths.h"

#include <catch2/catch.hpp>

using namespace drawbead;

TEST_CASE("the nearest word is what was probably meant") {
    const std::vector<std::string> words{"SRF001", "SRF002", "REF001", "line-has-gap", "json"};
    CHECK(nearest("SRF01", words) == "SRF001");
    CHECK(nearest("srf002", words) == "SRF002");
    CHECK(nearest("RSF002", words) == "SRF002"); // a swap counts once
    CHECK(nearest("line-gap", words) == "line-has-gap");
    CHECK(nearest("jsno", words) == "json");
    CHECK_FALSE(nearest("xml", words));
    CHECK_FALSE(nearest("something else", words));
    CHECK_FALSE(nearest("x", {}));
    CHECK_FALSE(nearest(std::string(100000, 'x'), words));
    CHECK(did_you_mean("jsn", words) == "did you mean 'json'?");
    CHECK(did_you_mean("xml", words).empty());
}

TEST_CASE("starter decks by name") {
    CHECK(is_starter_name("hood_0000.rad"));
    CHECK(is_starter_name("HOOD_0000.RAD"));
    CHECK(is_starter_name("_0000.rad"));
    CHECK_FALSE(is_starter_name("hood_0001.rad"));
    CHECK_FALSE(is_starter_name("hood.rad"));
    CHECK_FALSE(is_starter_name("0000.rad"));
}
