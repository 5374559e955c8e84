#include "config/settings.h"

#include <catch2/catch.hpp>

using namespace drawbead;

namespace {

Config config_of(const std::string& text, const std::string& path = "c.yaml") {
    auto config = parse_config(text, path);
    REQUIRE(config);
    return std::move(*config);
}

} // namespace

TEST_CASE("without a configuration all is as it always was") {
    const Settings settings = settle(nullptr, "a_0000.rad", {});
    CHECK(settings.rule_limits() == Limits{});
    CHECK(settings.select.value.empty());
    CHECK(settings.ignore.value.empty());
    CHECK(settings.fail_on.value == "error");
    CHECK(settings.severities().empty());
    CHECK(settings.select.origin.text() == "default");
}

TEST_CASE("the command line wins over overrides, these over the file, the file over defaults") {
    const Config config = config_of(
        "select: LIN\nignore: ENG\nseverity: {LIN: info, PAR: error}\n"
        "limits: {LIN005: {turn-degrees: 30}, LIN011: {ratio: 4}}\n"
        "overrides:\n"
        "  - {paths: old/, ignore: SRF, severity: {LIN: error}, limits: {LIN005: {turn-degrees: 40}}}\n"
        "  - {paths: 'old/*_0000.rad', limits: {LIN005: {turn-degrees: 50}}}\n");
    const Settings plain = settle(&config, "new/a_0000.rad", {}), old = settle(&config, "old/a_0000.rad", {}),
                   deeper = settle(&config, "old/x/a_0000.rad", {});
    CHECK(plain.ignore.value == std::vector<std::string>{"ENG"});
    CHECK(plain.rule_limits().LIN005_turn_degrees == 30);
    CHECK(plain.severities().at("LIN") == Severity::info);
    CHECK(old.ignore.value == std::vector<std::string>{"SRF"});
    CHECK(old.select.value == std::vector<std::string>{"LIN"});
    CHECK(old.rule_limits().LIN005_turn_degrees == 50);
    CHECK(old.rule_limits().LIN011_ratio == 4);
    CHECK(old.severities().at("LIN") == Severity::error);
    CHECK(old.severities().at("PAR") == Severity::error);
    CHECK(deeper.rule_limits().LIN005_turn_degrees == 40);
    Choices command_line;
    command_line.ignore = {{"PAR"}, {"command line", 0, 0}};
    const Settings most = settle(&config, "old/a_0000.rad", command_line);
    CHECK(most.ignore.value == std::vector<std::string>{"PAR"});
    CHECK(most.ignore.origin.text() == "command line");
}

TEST_CASE("patterns are relative to the folder of the file") {
    const Config config = config_of("overrides: [{paths: 'a/*', fail-on: never}]\n", "lib/c.yaml");
    CHECK(settle(&config, "lib/a/x_0000.rad", {}).fail_on.value == "never");
    CHECK(settle(&config, "a/x_0000.rad", {}).fail_on.value == "error");
    CHECK(settle(&config, "lib/b/../a/x_0000.rad", {}).fail_on.value == "never");
}

TEST_CASE("what is shown can be read again and says the same") {
    const Config config =
        config_of("select: [LIN, SRF]\nignore: [sharp-corner]\nseverity: {LIN: info}\nfail-on: warning\n"
                  "limits: {LIN005: {turn-degrees: 31.25}, LIN003: {coincident-steps: 3e-7}}\n");
    const std::string text = show(settle(&config, "a_0000.rad", {}), "a_0000.rad");
    CHECK(text.find("turn-degrees: 31.25") != std::string::npos);
    CHECK(text.find("# c.yaml:5:33") != std::string::npos);
    CHECK(text.find("# default") != std::string::npos);
    const Config again = config_of(text);
    const Settings settings = settle(&again, "a_0000.rad", {});
    CHECK(settings.rule_limits() == settle(&config, "a_0000.rad", {}).rule_limits());
    CHECK(settings.select.value == std::vector<std::string>{"LIN", "SRF"});
    CHECK(settings.ignore.value == std::vector<std::string>{"sharp-corner"});
    CHECK(settings.severities().at("LIN") == Severity::info);
    CHECK(settings.fail_on.value == "warning");
}
