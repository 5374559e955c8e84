#include "study/hard_cases.h"

#include "cli/commands.h"
#include "report/json.h"
#include "report/table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <unistd.h>

namespace drawbead {

namespace {

/// A case with what was measured.
struct Measured {
    const HardCase& one;
    HardCaseResult result;

    bool passed() const { return result.as_expected(); }
    std::string_view verdict() const { return !passed() ? "FAILED" : one.violated ? "broken" : "holds"; }
};

std::string short_number(double value) {
    std::array<char, 32> text;
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4);
    return {text.data(), end};
}

/// How many hold, are broken by their law, and fail.
std::array<std::size_t, 3> counts(const std::vector<Measured>& cases) {
    std::array<std::size_t, 3> out{};
    for (const Measured& one : cases)
        ++out[!one.passed() ? 2 : one.one.violated ? 1 : 0];
    return out;
}

void write_text(OutputSink& out, const std::vector<Measured>& cases) {
    std::vector<std::vector<std::string>> rows{
        {"case", "law", "number", "measured", "expected", "to", "verdict", "invariant"}};
    for (const Measured& m : cases)
        rows.push_back({std::string(m.one.name), std::string(name(m.one.law)),
                        std::string(name(m.one.number)), short_number(m.result.measured),
                        short_number(m.result.expected), short_number(m.result.bound),
                        std::string(m.verdict()), std::string(m.one.invariant)});
    out.write(text_table(rows, {3, 4, 5}));
    const auto [holds, broken, failed] = counts(cases);
    out.write("\n" + std::to_string(cases.size()) + " cases: " + std::to_string(holds) + " hold, " +
              std::to_string(broken) + " broken by the law itself and by as much as it says, " +
              std::to_string(failed) + " failed\n");
    for (const Measured& m : cases)
        if (!m.passed())
            out.write("failed: " + m.one.id() + ": " + std::string(m.one.scene) + " " +
                      std::string(m.one.invariant) + "\n");
}

void write_json(OutputSink& out, const std::vector<Measured>& cases) {
    JsonWriter json(out);
    json.begin_object();
    json.member("tool", "drawbead");
    json.member("version", tool_version());
    json.member("schema", 1);
    const auto [holds, broken, failed] = counts(cases);
    json.key("summary");
    json.begin_object(JsonWriter::Layout::line);
    json.member("cases", cases.size());
    json.member("hold", holds);
    json.member("broken", broken);
    json.member("failed", failed);
    json.end();
    json.key("cases");
    json.begin_array();
    for (const Measured& m : cases) {
        json.begin_object();
        json.member("name", m.one.name);
        json.member("law", name(m.one.law));
        json.member("number", name(m.one.number));
        json.member("scene", m.one.scene);
        json.member("invariant", m.one.invariant);
        json.member("guard", m.one.guard);
        json.member("measured", m.result.measured);
        json.member("expected", m.result.expected);
        json.member("bound", m.result.bound);
        json.member("verdict", m.passed() ? m.verdict() : "failed");
        json.end();
    }
    json.end();
    json.end();
    out.write('\n');
}

} // namespace

int run_hard_cases(bool as_json, const std::string& path) {
    std::unique_ptr<FileSink> out = std::make_unique<FileSink>(STDOUT_FILENO, "standard output");
    if (!path.empty()) {
        Result<std::unique_ptr<FileSink>> file = FileSink::replace(path);
        if (!file) {
            say_error(file.error());
            return exit_failed;
        }
        out = std::move(*file);
    }
    std::vector<Measured> cases;
    for (const HardCase& one : hard_cases())
        cases.push_back({one, one.measure()});
    if (as_json)
        write_json(*out, cases);
    else
        write_text(*out, cases);
    const int status = finish(*out);
    if (status != exit_clean) return status;
    return counts(cases)[2] > 0 ? exit_findings : exit_clean;
}

} // namespace drawbead
