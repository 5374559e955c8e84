#include "force/trace.h"

#include <catch2/catch.hpp>

using namespace drawbead;

namespace {

std::string header() {
    std::string text;
    for (std::size_t c = 0; c < trace_column_count; ++c)
        text += (c ? "," : "") + std::string(name(static_cast<TraceColumn>(c)));
    return text + "\n";
}

std::string row(int cycle, int nin, int inod, const std::string& last = "1") {
    std::string text = std::to_string(cycle) + "," + std::to_string(cycle) + ",0," + std::to_string(nin) +
                       "," + std::to_string(inod);
    for (std::size_t c = 5; c + 1 < trace_column_count; ++c)
        text += ",1";
    return text + "," + last + "\n";
}

std::string message(const std::string& text) {
    const auto trace = parse_trace(text, "t.csv");
    REQUIRE_FALSE(trace);
    return to_string(trace.error());
}

} // namespace

TEST_CASE("a complete trace is read; columns may stand in any order, extra ones are ignored") {
    const auto plain =
        parse_trace(header() + row(0, 1, 1) + row(0, 1, 2) + row(1, 1, 1) + row(1, 1, 2), "t.csv");
    REQUIRE(plain);
    CHECK(plain->rows.size() == 4);
    CHECK(plain->rows[3].integer(TraceColumn::inod) == 2);
    CHECK(plain->rows[3].line == 5);
    const auto extra = parse_trace("extra," + header() + "x," + row(0, 1, 1), "t.csv");
    REQUIRE(extra);
    CHECK(extra->rows[0].integer(TraceColumn::nin) == 1);
}

TEST_CASE("the last line may lack its end when its last value stands in full") {
    const std::string text = header() + row(0, 1, 1, "1.25e-7") + row(0, 1, 2, "1.25e-7");
    const auto trace = parse_trace(std::string_view(text).substr(0, text.size() - 1), "t.csv");
    REQUIRE(trace);
    CHECK(trace->rows.size() == 2);
}

TEST_CASE("line ends of any kind and a byte order mark are read") {
    std::string text = "\xEF\xBB\xBF" + header() + row(0, 1, 1) + row(0, 1, 2);
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
        text.replace(at, 1, "\r\n");
    const auto trace = parse_trace(text, "t.csv");
    REQUIRE(trace);
    CHECK(trace->rows.size() == 2);
}

TEST_CASE("what a record has beside the needed columns must be numbers, anything else may be anything") {
    const auto with = [](const std::string& name, const std::string& value) {
        return name + "," + header() + value + "," + row(0, 1, 1);
    };
    CHECK(parse_trace(with("seg", "17"), "t.csv"));
    CHECK(parse_trace(with("dt12", "1e-7"), "t.csv"));
    CHECK(parse_trace(with("remark", "NaN"), "t.csv"));
    CHECK(message(with("seg", "NaN")) ==
          "t.csv:2:1: error: seg is 'NaN', which is not finite; the run was no longer valid there");
    CHECK(message(with("dt12", "")) == "t.csv:2:1: error: dt12 is '', not a number; repair the row");
}

TEST_CASE("a trace that is not whole is refused, with place and reason") {
    const std::string good = header() + row(0, 1, 1) + row(0, 1, 2) + row(1, 1, 1) + row(1, 1, 2);
    CHECK(message("") == "t.csv:1: error: the trace is empty; the first line must name the columns");
    CHECK(message("ncycle,tt\n1,2\n")
              .find("t.csv:1: error: the trace lacks the columns dt1, nin, inod, node,") == 0);
    CHECK(message(header()) == "t.csv:1: error: the trace has no rows; was the time window ever open?");
    const std::string cut = header() + row(0, 1, 1, "1.25e-7") + row(0, 1, 2, "1.25e-7");
    CHECK(message(cut.substr(0, cut.size() - 2)) ==
          "t.csv:3: error: the last line has no end: the trace is cut; take the whole file");
    CHECK(message(good.substr(0, good.size() - 21) + "\n").find("values: the trace is cut or damaged") !=
          std::string::npos);
    CHECK(message("a,b,c\n1,2,3\n") ==
          "t.csv:1: error: the first line names no column of a trace; is this a trace?");
    CHECK(message(std::string("\x7f"
                              "ELF\0\1\n\0",
                              8))
              .find("names no column of a trace") != std::string::npos);
    CHECK(message(header().substr(0, header().size() - 1) + ",tt\n") ==
          "t.csv:1:366: error: column 'tt' stands twice; remove one");
    CHECK(message(header() + row(0, 1, 1, "nan")) ==
          "t.csv:2:163: error: m4 is 'nan', which is not finite; the run was no longer valid there");
    CHECK(message(header() + row(0, 1, 1, "1x")).find("m4 is '1x', not a number") != std::string::npos);
    CHECK(message(header() + row(0, 1, 1, "1,5")).find("more values than the first line has columns") !=
          std::string::npos);
    CHECK(message(header() + row(0, 1, 2) + row(0, 1, 1)) ==
          "t.csv:2: error: cycle 0 has node 2 where node 1 is due; rows are missing or swapped");
    CHECK(message(header() + row(0, 1, 1) + row(0, 1, 2) + row(1, 1, 1)) ==
          "t.csv:4: error: cycle 1 of interface number 1 has 1 nodes, earlier cycles 2; rows are missing");
    CHECK(message(header() + row(0, 1, 1) + row(2, 1, 1)) ==
          "t.csv:3: error: cycles 1 to 1 are missing; the stored force of incremental restraint needs every "
          "cycle");
    CHECK(message(header() + row(1, 1, 1) + row(0, 1, 1)).find("rows are out of order") != std::string::npos);
    CHECK(message(header() + row(0, 2, 1) + row(0, 1, 1)).find("rows are out of order") != std::string::npos);
}
