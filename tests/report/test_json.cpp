#include "example.h"
#include "report/json.h"
#include "report/writer.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

using namespace drawbead;

namespace {

std::string json_of(const Report& report) {
    StringSink out;
    const std::unique_ptr<ReportWriter> writer = json_writer(out, {report.tool_version});
    for (const DeckResult& deck : report.decks)
        writer->deck(deck);
    writer->end(report.summary);
    return out.text();
}

} // namespace

TEST_CASE("JSON report, to the letter") {
    const std::string path = DRAWBEAD_TESTS_DIR "/report/example.json";
    const std::string text = json_of(example_report());
    if (std::getenv("DRAWBEAD_UPDATE")) std::ofstream(path) << text;
    std::ostringstream expected;
    expected << std::ifstream(path).rdbuf();
    CHECK(text == expected.str());
}

TEST_CASE("a report without decks") {
    Report report;
    report.tool_version = "0";
    CHECK(json_of(report) == "{\n"
                             "  \"tool\": \"drawbead\",\n"
                             "  \"version\": \"0\",\n"
                             "  \"schema\": 1,\n"
                             "  \"decks\": [],\n"
                             "  \"summary\": {\n"
                             "    \"decks\": 0,\n"
                             "    \"failed\": 0,\n"
                             "    \"interfaces\": 0,\n"
                             "    \"errors\": 0,\n"
                             "    \"warnings\": 0,\n"
                             "    \"infos\": 0,\n"
                             "    \"suppressed\": 0,\n"
                             "    \"known\": 0,\n"
                             "    \"gone\": 0\n"
                             "  }\n"
                             "}\n");
}

TEST_CASE("a part of a run, and one that was interrupted, say so") {
    StringSink out;
    const std::unique_ptr<ReportWriter> writer = json_writer(out, {"0", {}, Shard{2, 7}});
    Summary summary;
    summary.interrupted = true;
    summary.asked = 12;
    writer->end(summary);
    CHECK(out.text().find("\"schema\": 1,\n  \"shard\": {\"number\": 2, \"of\": 7},\n") != std::string::npos);
    CHECK(out.text().find("\"gone\": 0,\n    \"interrupted\": true,\n    \"asked\": 12\n") !=
          std::string::npos);
}

TEST_CASE("strings: quotes, control bytes, and bytes that are no UTF-8") {
    CHECK(json_string("a\"b\\c\n\t\r\x01\x7f") == R"("a\"b\\c\n\t\r\u0001\u007f")");
    CHECK(json_string("\xce\xbc \xe2\x80\xa6 \xf0\x9f\x98\x80") ==
          "\"\xce\xbc \xe2\x80\xa6 \xf0\x9f\x98\x80\"");
    const std::string bad = "\xef\xbf\xbd";
    CHECK(json_string("B\xf6rdel") == "\"B" + bad + "rdel\"");
    CHECK(json_string("\xe2\x80") == "\"" + bad + bad + "\"");           // cut
    CHECK(json_string("\xc0\xaf") == "\"" + bad + bad + "\"");           // overlong
    CHECK(json_string("\xed\xa0\x80") == "\"" + bad + bad + bad + "\""); // surrogate
    CHECK(json_string("\xf4\x90\x80\x80") == "\"" + bad + bad + bad + bad + "\"");
    CHECK(json_string(std::string_view("\0", 1)) == "\"\\u0000\"");
}

TEST_CASE("numbers read back as they were; JSON has no NaN") {
    for (const double value : {0.1, 1.0 / 3.0, 1e30, 4.1e-7, -0.0, 5e-324, 123456789.0}) {
        const std::string text = json_number(value);
        CHECK(std::strtod(text.c_str(), nullptr) == value);
        CHECK(text.size() <= 24);
    }
    CHECK(json_number(0.1) == "0.1");
    CHECK(json_number(4800) == "4800");
    CHECK(json_number(std::nan("")) == "null");
    CHECK(json_number(-std::numeric_limits<double>::infinity()) == "null");
}

TEST_CASE("layouts") {
    StringSink out;
    JsonWriter json(out);
    json.begin_array();
    json.begin_object(JsonWriter::Layout::line);
    json.member("a", 1);
    json.key("b");
    json.begin_array();
    json.value(true);
    json.null();
    json.end();
    json.end();
    json.begin_object();
    json.end();
    json.end();
    CHECK(out.text() == "[\n  {\"a\": 1, \"b\": [true, null]},\n  {}\n]\n");
}
