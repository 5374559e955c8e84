#include "deck/scan.h"
#include "deck/source_file.h"

#include <catch2/catch.hpp>
#include <random>
#include <string>

using namespace drawbead;

namespace {

std::vector<uint64_t> marks_by_lines(const std::string& text) {
    std::vector<uint64_t> marks;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        const std::size_t first = line.find_first_not_of(" \t");
        if (first != std::string::npos && line[first] == '/') {
            const char next = first + 1 < line.size() ? line[first + 1] : '\0';
            if (first == 0 || (next >= 'A' && next <= 'Z') || next == '/') marks.push_back(begin + first);
        }
        if (line.size() > 1 && line[0] == '#' && std::string("iIeE!").find(line[1]) != std::string::npos)
            marks.push_back(begin);
        begin = end + 1;
    }
    return marks;
}

} // namespace

TEST_CASE("marks and newlines of random text equal a line-by-line reading, for any count of threads") {
    std::mt19937 random(7);
    const std::string letters = "\n\n/#iE! \t0123456789A/\r";
    std::string text;
    for (std::size_t i = 0; i < 3 * LineScan::stride + 12345; ++i)
        text += letters[random() % letters.size()];
    const LineScan one = scan_lines(text, 1);
    CHECK(one.marks == marks_by_lines(text));
    REQUIRE(one.newlines.size() == 5);
    for (std::size_t k = 0; k < one.newlines.size(); ++k)
        CHECK(one.newlines[k] == count_newlines(std::string_view(text).substr(0, k * LineScan::stride)));
    const LineScan two = scan_lines(text, 2);
    CHECK(two.marks == one.marks);
    CHECK(two.newlines == one.newlines);
}

TEST_CASE("places are lines and columns from 1, with any line end and without the last one") {
    const SourceFile file("a", FileBytes("ab\r\ncd\n\nef"), 1);
    CHECK(file.lines() == 4);
    CHECK(file.at(0).line == 1);
    CHECK(file.at(5).line == 2);
    CHECK(file.at(5).column == 2);
    CHECK(file.at(8).line == 4);
    CHECK(file.line_at(1) == "ab");
    CHECK(file.line_at(7) == "");
    CHECK(file.line_at(9) == "ef");
    CHECK(file.next_line(8) == 10);
    CHECK(SourceFile("empty", FileBytes(""), 1).lines() == 0);
}

TEST_CASE("comments that begin with a word and a colon are noted, wherever chunks end") {
    const std::string long_word(40, 'w');
    const std::string lines =
        "# word: x\n#word:\n#\tTwo: \n # indented: no\n# 12: no\n#: no\n# two words: no\n#include x\n"
        "# " +
        long_word + ": no\nx # later: no\n# last:";
    for (std::size_t shift = 0; shift < 130; ++shift) {
        const std::string text = std::string(shift, ' ') + "\n" + lines;
        const LineScan scan = scan_lines(text, 1);
        std::vector<uint64_t> expected;
        for (const char* line : {"# word: x", "#word:", "#\tTwo:", "# last:"})
            expected.push_back(text.find(line));
        CHECK(scan.remarks == expected);
        CHECK(scan.marks == std::vector<uint64_t>{text.find("#include")});
    }
    CHECK(scan_lines("#", 1).remarks.empty());
    CHECK(scan_lines("# a", 1).remarks.empty());
    CHECK(scan_lines("# a:", 1).remarks.size() == 1);
}
