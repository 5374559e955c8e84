// Formats for other programs. The files example.* are what the example report has to look like; with
// DRAWBEAD_UPDATE set they are written.
#include "example.h"
#include "report/text.h"
#include "report/utf8.h"
#include "report/writer.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>

using namespace drawbead;

namespace {

using MakeWriter = std::function<std::unique_ptr<ReportWriter>(OutputSink&)>;

std::string written(const Report& report, const MakeWriter& make) {
    StringSink out;
    const std::unique_ptr<ReportWriter> writer = make(out);
    for (const DeckResult& deck : report.decks)
        writer->deck(deck);
    writer->end(report.summary);
    return out.text();
}

const std::vector<RuleInfo>& catalogue() {
    static const std::vector<RuleInfo> rules{
        {"CTX001", "no-drawbead", "the deck has no drawbead", Severity::info, FixAvailability::none, 0, ""},
        {"PAR001", "unit-suspect", "a unit is \"odd\"", Severity::warning, FixAvailability::none, 0, ""},
        {"SRF001", "segment-normal-away-from-bead", "segments face away", Severity::error,
         FixAvailability::safe, 0,
         "# SRF001\n\n## What it does\nFinds segments.\nAll of them.\n\n## Why\nForce.\n"}};
    return rules;
}

WriterOptions options() {
    WriterOptions made;
    made.tool_version = "1.2.3";
    made.rules = catalogue();
    return made;
}

Report example() {
    Report report = example_report();
    report.summary.asked = report.summary.decks;
    report.summary.exit_status = 2;
    return report;
}

void check_against(const char* file, const std::string& text) {
    const std::string path = std::string(DRAWBEAD_TESTS_DIR "/report/") + file;
    if (std::getenv("DRAWBEAD_UPDATE")) std::ofstream(path) << text;
    std::ostringstream expected;
    expected << std::ifstream(path).rdbuf();
    CHECK(text == expected.str());
}

/// A report of one finding.
Report report_of(const Finding& finding) {
    Report report;
    report.decks.resize(1);
    report.decks[0].path = "a_0000.rad";
    report.decks[0].findings = {finding};
    report.summary = summarise(report.decks);
    return report;
}

Finding finding_with(const std::string& message) {
    Finding finding;
    finding.code = "SYN005";
    finding.name = "not-a-number";
    finding.severity = Severity::error;
    finding.message = message;
    finding.places = {{"a_0000.rad", 3, 5, 8, "1 x 2"}};
    finding.place_count = 1;
    finding.fingerprint = "00000000000000aa";
    return finding;
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
        ++n;
    return n;
}

} // namespace

TEST_CASE("the example in every format, to the letter") {
    const Report report = example();
    check_against("example.csv", written(report, csv_writer));
    check_against("example.github.txt", written(report, github_writer));
    check_against("example.gitlab.json", written(report, gitlab_writer));
    check_against("example.junit.xml",
                  written(report, [](OutputSink& o) { return junit_writer(o, options()); }));
    check_against("example.jsonl", written(report, [](OutputSink& o) { return lines_writer(o, options()); }));
    check_against("example.sarif", written(report, [](OutputSink& o) { return sarif_writer(o, options()); }));
}

TEST_CASE("a run without decks") {
    Report none;
    CHECK(written(none, csv_writer) == "deck,file,line,column,end_column,severity,code,name,interface,"
                                       "message,places,help,fix,fingerprint\n");
    CHECK(written(none, gitlab_writer) == "[]\n");
    CHECK(written(none, github_writer) ==
          "::notice title=drawbead::0 decks, 0 interfaces: nothing to check\n");
    CHECK(written(none, [](OutputSink& o) { return junit_writer(o, options()); }) ==
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"drawbead\">\n</testsuites>\n");
}

TEST_CASE("an interrupted run says so in every format") {
    Report report;
    report.summary.interrupted = true;
    report.summary.asked = 5;
    const std::string what = "interrupted after 0 of 5";
    for (const MakeWriter& make :
         {MakeWriter(csv_writer), MakeWriter(github_writer), MakeWriter(gitlab_writer),
          MakeWriter([](OutputSink& o) { return junit_writer(o, options()); }),
          MakeWriter([](OutputSink& o) { return sarif_writer(o, options()); })})
        CHECK(written(report, make).find(what) != std::string::npos);
    CHECK(written(report, [](OutputSink& o) {
              return lines_writer(o, options());
          }).find("\"interrupted\": true, \"asked\": 5}\n") != std::string::npos);
}

TEST_CASE("CSV: quotes, commas and line ends stand in quotes") {
    const std::string text = written(report_of(finding_with("a, \"b\"\nc")), csv_writer);
    CHECK(
        text.substr(text.find('\n') + 1) ==
        "a_0000.rad,a_0000.rad,3,5,8,error,SYN005,not-a-number,,\"a, \"\"b\"\"\nc\",1,,,00000000000000aa\n");
    Report nameless = report_of(finding_with("m"));
    nameless.decks[0].path = "";
    CHECK(written(nameless, csv_writer).find("\n\"\",a_0000.rad,3,") != std::string::npos);
}

TEST_CASE("GitHub: what the commands are made of is escaped") {
    Finding finding = finding_with("100 %\r\nof: all, \x1b");
    finding.places[0].file = "a,b:c%_0000.rad";
    const std::string text = written(report_of(finding), github_writer);
    CHECK(text.substr(0, text.find('\n')) ==
          "::error file=a%2Cb%3Ac%25_0000.rad,line=3,endLine=3,col=5,endColumn=7,title=SYN005 "
          "not-a-number::100 %25%0D%0Aof: all, ?");
}

TEST_CASE("GitHub: the worst ten, the first of those that are as bad") {
    Report report;
    report.decks.resize(2);
    for (int i = 0; i < 8; ++i) {
        Finding finding = finding_with("warning " + std::to_string(i));
        finding.severity = Severity::warning;
        report.decks[0].findings.push_back(finding);
    }
    for (int i = 0; i < 4; ++i)
        report.decks[1].findings.push_back(finding_with("error " + std::to_string(i)));
    report.summary = summarise(report.decks);
    const std::string text = written(report, github_writer);
    CHECK(count(text, "::error file=") == 4);
    CHECK(count(text, "::warning file=") == 6);
    CHECK(text.find("error 3\n::warning") != std::string::npos);
    CHECK(text.find(
              "warning 5\n::notice title=drawbead::2 decks, 0 interfaces: 4 errors, 8 warnings; the worst 10 "
              "of 12 are shown\n") != std::string::npos);
}

TEST_CASE("JUnit: what XML 1.0 cannot hold") {
    const std::string text = written(report_of(finding_with("<a> & \"b\" \x01 \xef\xbf\xbe \xf6")),
                                     [](OutputSink& o) { return junit_writer(o, options()); });
    const std::string bad = "\xef\xbf\xbd";
    CHECK(text.find("message=\"&lt;a&gt; &amp; &quot;b&quot; " + bad + " " + bad + " " + bad + "\"") !=
          std::string::npos);
}

TEST_CASE("JUnit: a case fails by --fail-on") {
    Finding warning = finding_with("m");
    warning.severity = Severity::warning;
    const auto with = [&](std::optional<Severity> least) {
        Report report = report_of(warning);
        report.decks.front().fail_on = least;
        return written(report, [](OutputSink& out) { return junit_writer(out, options()); });
    };
    CHECK(count(with(Severity::error), "<failure") == 0);
    CHECK(count(with(Severity::error), "failures=\"0\"") == 1);
    CHECK(count(with(Severity::warning), "<failure type=\"warning\" message=\"m\">") == 1);
    CHECK(count(with(Severity::info), "failures=\"1\"") == 1);
    CHECK(count(with(std::nullopt), "<failure") == 0);
}

TEST_CASE("GitLab: fingerprints differ between decks and within one") {
    Report report = report_of(finding_with("m"));
    report.decks[0].findings.push_back(report.decks[0].findings[0]);
    report.decks.push_back(report.decks[0]);
    report.decks[1].path = "b_0000.rad";
    const std::string text = written(report, gitlab_writer);
    std::vector<std::string> prints;
    for (std::size_t at = 0; (at = text.find("\"fingerprint\": \"", at)) != std::string::npos; ++at)
        prints.push_back(text.substr(at + 16, 16));
    REQUIRE(prints.size() == 4);
    std::sort(prints.begin(), prints.end());
    CHECK(std::unique(prints.begin(), prints.end()) == prints.end());
    CHECK(text == written(report, gitlab_writer));
}

TEST_CASE("SARIF: paths become references, columns code points, Latin-1 stays what it is") {
    Finding finding = finding_with("{0} of {1}");
    finding.places[0] = {"./d\xc3\xa4 ck/\xf6:%_0000.rad", 3, 7, 9, "\xc3\xa4\xc3\xa4 1 2", 5, 7};
    finding.fixes = {
        {"t", FixAvailability::unsafe, {{"/abs/a.inc", {{0, 1, {"", 1, 1, 2, ""}, 1, "\xf6"}}}}}};
    const std::string text =
        written(report_of(finding), [](OutputSink& o) { return sarif_writer(o, options()); });
    CHECK(text.find("\"uri\": \"d%C3%A4%20ck/%F6%3A%25_0000.rad\", \"uriBaseId\": \"SRCROOT\"") !=
          std::string::npos);
    CHECK(text.find("\"startLine\": 3, \"startColumn\": 5, \"endLine\": 3, \"endColumn\": 7") !=
          std::string::npos);
    CHECK(text.find("\"text\": \"{{0}} of {{1}}\"") != std::string::npos);
    CHECK(text.find("\"uri\": \"file:///abs/a.inc\"}") != std::string::npos);
    CHECK(text.find("\"insertedContent\": {\"binary\": \"9g==\"}") != std::string::npos);
    CHECK(text.find("\"unsafe: t\"") != std::string::npos);
}

TEST_CASE("paths without what does not matter") {
    CHECK(plain_path("./a//b/./c.rad") == "a/b/c.rad");
    CHECK(plain_path("/a/b") == "/a/b");
    CHECK(plain_path("../a") == "../a");
    CHECK(plain_path(".") == ".");
    CHECK(plain_path("") == "");
}

TEST_CASE("bytes that are no UTF-8, there and back") {
    const std::string odd("\x00\x7f%20 \xf6\xe4", 8);
    CHECK(percent_encoded(odd) == "%00%7f%2520 %f6%e4");
    CHECK(percent_decoded(percent_encoded(odd)) == odd);
    CHECK(percent_decoded("100 % of 5%") == "100 % of 5%");
    CHECK(valid_utf8("B\xf6rdel \xce\xbc") == "B\xef\xbf\xbdrdel \xce\xbc");
}
