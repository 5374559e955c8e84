#include "config/config.h"
#include "config/options.h"
#include "rules/limits.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace drawbead;

namespace {

std::string error_of(const std::string& text) {
    const auto config = parse_config(text, "c.yaml");
    return config ? "" : to_string(config.error());
}

} // namespace

TEST_CASE("a configuration is read with the place of each value") {
    const auto config = parse_config("select: lin\n"
                                     "ignore: [LIN010, sharp-corner]\n"
                                     "severity: {ENG: warning, lin001: info}\n"
                                     "fail-on: never\n"
                                     "include-path: [../common, /abs]\n"
                                     "limits:\n"
                                     "  LIN005: {turn-degrees: 30}\n"
                                     "overrides:\n"
                                     "  - paths: old/\n"
                                     "    limits: {PAR007: {least-n-per-mm: 1e-3}}\n",
                                     "x/c.yaml");
    REQUIRE(config);
    CHECK(config->choices.select->value == std::vector<std::string>{"LIN"});
    CHECK(config->choices.select->origin.text() == "x/c.yaml:1:9");
    CHECK(config->choices.ignore->value == std::vector<std::string>{"LIN010", "sharp-corner"});
    CHECK(config->choices.severity.at("LIN001").value == Severity::info);
    CHECK(config->choices.severity.at("ENG").origin.line == 3);
    CHECK(config->choices.fail_on->value == "never");
    CHECK(config->choices.include_path->value == std::vector<std::string>{"common", "/abs"});
    REQUIRE(config->choices.limits.size() == 1);
    const auto& [place, value] = *config->choices.limits.begin();
    CHECK(limit_table()[place].rule == "LIN005");
    CHECK(value.value == 30);
    CHECK(value.origin.text() == "x/c.yaml:7:26");
    REQUIRE(config->overrides.size() == 1);
    CHECK(config->overrides[0].paths == std::vector<std::string>{"old/"});
    CHECK(config->overrides[0].choices.limits.begin()->second.value == 1e-3);
    CHECK(parse_config("", "c")->choices.limits.empty());
}

TEST_CASE("mistakes have a place and a next step") {
    CHECK(error_of("selct: [LIN]\n") == "c.yaml:1:1: error: unknown key 'selct'; did you mean 'select'?");
    CHECK(error_of("x: 1\n") ==
          "c.yaml:1:1: error: unknown key 'x'; known here: select, ignore, severity, fail-on, "
          "include-path, limits, overrides");
    CHECK(error_of("ignore: [LIN055]\n") ==
          "c.yaml:1:10: error: no rule or family 'LIN055'; did you mean 'LIN005'?");
    CHECK(error_of("limits:\n  LIN005:\n    turn-degres: 3\n") ==
          "c.yaml:3:5: error: LIN005 has no limit 'turn-degres'; did you mean 'turn-degrees'?");
    CHECK(error_of("limits: {LIN05: {}}\n")
              .starts_with("c.yaml:1:10: error: no rule with limits 'LIN05'; did you mean 'LIN0"));
    CHECK(error_of("limits: {LIN002: {}}\n").starts_with("c.yaml:1:10: error: LIN002 has no limits"));
    CHECK(error_of("limits: {sharp-corner: {}}\n") == "c.yaml:1:10: error: limits go by codes; write LIN005");
    CHECK(error_of("limits: {LIN005: {turn-degrees: 200}}\n") ==
          "c.yaml:1:33: error: LIN005 turn-degrees must be 0 to 180 degrees, not 200");
    CHECK(error_of("limits: {LIN005: {turn-degrees: '20'}}\n") ==
          "c.yaml:1:33: error: LIN005 turn-degrees needs a number, not '20'");
    for (const char* value : {"nan", "inf", "1.5.2", "0x10", "yes", "", "[1]", "{a: 1}", "1e999"})
        CHECK(error_of("limits: {LIN005: {turn-degrees: " + std::string(value) + "}}\n")
                  .find("needs a number") != std::string::npos);
    CHECK(error_of("severity: {LIN: erorr}\n") ==
          "c.yaml:1:17: error: severity knows no 'erorr'; did you mean 'error'?");
    CHECK(error_of("severity: error\n") ==
          "c.yaml:1:11: error: severity needs a map; such as {LIN005: error}");
    CHECK(error_of("fail-on: [error]\n") == "c.yaml:1:10: error: fail-on needs a word");
    CHECK(error_of("fail-on: fatal\n").starts_with("c.yaml:1:10: error: fail-on knows no 'fatal'"));
    CHECK(error_of("ignore: {LIN: 1}\n") == "c.yaml:1:9: error: ignore needs a word or a list");
    CHECK(error_of("ignore: [[LIN]]\n") == "c.yaml:1:10: error: an entry of ignore needs a word");
    CHECK(error_of("ignore:\n") == "c.yaml:1:1: error: ignore needs a word or a list");
    CHECK(error_of("[a, b]\n").starts_with("c.yaml:1:1: error: a configuration is a map of keys"));
    CHECK(error_of("word\n").starts_with("c.yaml:1:1: error: a configuration is a map of keys"));
    CHECK(error_of("paths: [a]\n") == "c.yaml:1:1: error: key 'paths' stands in an override only");
    CHECK(error_of("overrides:\n  - ignore: [LIN]\n")
              .starts_with("c.yaml:2:5: error: an override needs paths"));
    CHECK(error_of("overrides:\n  - paths: a\n    overrides: []\n") ==
          "c.yaml:3:5: error: key 'overrides' cannot stand in an override");
    CHECK(error_of("overrides: {paths: a}\n").starts_with("c.yaml:1:12: error: overrides needs a list"));
    CHECK(error_of("limits: {LIN005: 20}\n").starts_with("c.yaml:1:18: error: LIN005 needs a map of limits"));
}

TEST_CASE("every option of the table is read, and every limit") {
    for (const LimitInfo& limit : limit_table()) {
        const std::string key = "limits: {" + std::string(limit.rule) + ": {" + limit.key() + ": ";
        INFO(key);
        for (const double value : {limit.least, limit.usual, limit.most}) {
            const auto config = parse_config(key + std::to_string(value) + "}}\n", "c");
            if (std::stod(std::to_string(value)) != value) continue; // six digits are too few to write it
            REQUIRE(config);
            CHECK(config->choices.limits.begin()->second.value == value);
        }
        CHECK(error_of(key + std::to_string(limit.most + 1) + "}}\n").find("must be") != std::string::npos);
        CHECK(error_of(key + std::to_string(limit.least - 1) + "}}\n").find("must be") != std::string::npos);
    }
    for (const ConfigOption& option : config_options()) {
        INFO(option.key);
        const std::string error = error_of(std::string(option.key) + ": [[]]\n");
        CHECK(error.find("unknown key") == std::string::npos);
        CHECK_FALSE(error.empty());
        CHECK(option.text.find_first_of("\"\\|\n") == std::string_view::npos);
    }
}
