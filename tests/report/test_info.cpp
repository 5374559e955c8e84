#include "example.h"
#include "report/catalogue.h"
#include "report/info.h"
#include "report/table.h"

#include <catch2/catch.hpp>

using namespace drawbead;

TEST_CASE("info as text, to the letter") {
    StringSink out;
    write_info_text(out, example_report().decks[0]);
    CHECK(out.text() == "deck       decks/hood_0000.rad\n"
                        "run        hood\n"
                        "version    2022\n"
                        "units      Mg mm s (written in Mg m s)\n"
                        "files      2 files, 123456 bytes\n"
                        "nodes      10000\n"
                        "shells4    9800\n"
                        "shells3    12\n"
                        "solids     1\n"
                        "parts      4\n"
                        "drawbeads  2\n"
                        "\n"
                        "/INTER/TYPE8\n"
                        "  id  nodes  segments       length  title\n"
                        "  11     42      9800     205.5 mm  bead \"A\"\n"
                        "  12      7      9800  0.333333 mm\n"
                        "\n"
                        "files\n"
                        "  decks/hood_0000.rad\n"
                        "  decks/blank.inc\n"
                        "\n"
                        "keywords\n"
                        "  2  /INTER/TYPE8\n"
                        "  1  /NODE\n");
}

TEST_CASE("info as JSON, to the letter") {
    StringSink out;
    write_info_json(out, example_report().decks[0]);
    CHECK(out.text() ==
          "{\n"
          "  \"version\": 2022,\n"
          "  \"run_name\": \"hood\",\n"
          "  \"units\": {\n"
          "    \"work\": {\"mass\": \"Mg\", \"length\": \"mm\", \"time\": \"s\"},\n"
          "    \"input\": {\"mass\": \"Mg\", \"length\": \"m\", \"time\": \"s\"}\n"
          "  },\n"
          "  \"files\": [\n"
          "    \"decks/hood_0000.rad\",\n"
          "    \"decks/blank.inc\"\n"
          "  ],\n"
          "  \"bytes\": 123456,\n"
          "  \"nodes\": 10000,\n"
          "  \"shells4\": 9800,\n"
          "  \"shells3\": 12,\n"
          "  \"solids\": 1,\n"
          "  \"parts\": 4,\n"
          "  \"interfaces_type8\": [\n"
          "    {\"id\": 11, \"title\": \"bead \\\"A\\\"\", \"nodes\": 42, \"segments\": 9800, \"length\": "
          "205.5},\n"
          "    {\"id\": 12, \"title\": \"\", \"nodes\": 7, \"segments\": 9800, \"length\": "
          "0.3333333333333333}\n"
          "  ],\n"
          "  \"keywords\": {\n"
          "    \"/INTER/TYPE8\": 2,\n"
          "    \"/NODE\": 1\n"
          "  }\n"
          "}\n");
}

TEST_CASE("the catalogue as text and JSON") {
    const std::vector<RuleInfo> rules{{"LIN001", "line-has-gap", "a hop is too long", Severity::error,
                                       FixAvailability::sometimes_safe, 0, ""},
                                      {"REF003", "node-group-sorted", "the group is sorted", Severity::error,
                                       FixAvailability::none, 112, ""}};
    StringSink text;
    write_catalogue_text(text, rules);
    CHECK(text.text() == "code    name               severity  fix             summary\n"
                         "LIN001  line-has-gap       error     sometimes safe  a hop is too long\n"
                         "REF003  node-group-sorted  error     -               the group is sorted\n");
    StringSink json;
    write_catalogue_json(json, {rules[1]}, "1.2.3");
    CHECK(json.text() == "{\n"
                         "  \"tool\": \"drawbead\",\n"
                         "  \"version\": \"1.2.3\",\n"
                         "  \"rules\": [\n"
                         "    {\n"
                         "      \"code\": \"REF003\",\n"
                         "      \"name\": \"node-group-sorted\",\n"
                         "      \"family\": \"REF\",\n"
                         "      \"severity\": \"error\",\n"
                         "      \"fix\": \"none\",\n"
                         "      \"starter_message\": 112,\n"
                         "      \"summary\": \"the group is sorted\"\n"
                         "    }\n"
                         "  ]\n"
                         "}\n");
}

TEST_CASE("tables count characters, not bytes") {
    CHECK(text_table({{"\xce\xbc", "x"}, {"ab", "y"}}) == "\xce\xbc   x\nab  y\n");
    CHECK(text_table({{"1", "x"}, {"22", ""}}, {0}, 2) == "   1  x\n  22\n");
}
