// Edits: made, composed, shown as a diff.
#include "deck/edit.h"

#include <catch2/catch.hpp>
#include <rapidcheck.h>
#include <sstream>

using namespace drawbead;

namespace {

constexpr FileId file{0};

Edit edit(uint64_t begin, uint64_t end, std::string text) {
    return {{file, begin, end}, std::move(text)};
}

/// Edits in order of a text of `size` bytes.
EditList any_edits(std::size_t size) {
    EditList edits;
    uint64_t at = 0;
    const int count = *rc::gen::inRange(0, 6);
    for (int i = 0; i < count && at <= size; ++i) {
        const auto begin = *rc::gen::inRange<uint64_t>(at, size + 1);
        const auto end = *rc::gen::inRange<uint64_t>(begin, std::min<uint64_t>(begin + 6, size) + 1);
        const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab \n")));
        edits.push_back(edit(begin, end, text));
        at = end;
    }
    sort_edits(edits);
    RC_PRE(in_order(edits));
    return edits;
}

std::string any_text() {
    return *rc::gen::container<std::string>(rc::gen::elementOf(std::string("xyz\n\n\r")));
}

/// What `patch` does with a diff of one file.
std::string patched(const std::string& text, const std::string& diff) {
    std::vector<std::string> old;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
        old.push_back(text.substr(at, end - at));
        at = end;
    }
    std::string out;
    std::size_t next = 0;
    std::istringstream lines(diff);
    std::string line;
    std::getline(lines, line);
    std::getline(lines, line);
    std::string* last = nullptr;
    std::string removed;
    while (std::getline(lines, line)) {
        if (line[0] == '@') {
            std::size_t first = std::stoul(line.substr(4));
            const std::size_t comma = line.find(',');
            if (comma < line.find('+') && std::stoul(line.substr(comma + 1)) == 0) ++first;
            while (next + 1 < first)
                out += old.at(next++);
        } else if (line[0] == '\\') {
            REQUIRE(last != nullptr);
            REQUIRE(last->back() == '\n');
            last->pop_back();
        } else if (line[0] == '+') {
            out += line.substr(1) + "\n";
            last = &out;
        } else {
            const std::string expected = line.substr(1) + "\n";
            const std::string& there = old.at(next++);
            REQUIRE((there == expected || there + "\n" == expected));
            removed = expected;
            last = &removed;
            if (line[0] == ' ') {
                out += expected;
                last = &out;
            }
        }
    }
    while (next < old.size())
        out += old.at(next++);
    return out;
}

} // namespace

TEST_CASE("edits replace, insert and delete, and leave the rest") {
    CHECK(edited("one two three", {edit(4, 7, "2"), edit(8, 8, "and "), edit(13, 13, "!")}) ==
          "one 2 and three!");
    CHECK(edited("abc", {}) == "abc");
    CHECK(edited_size("abc", {edit(0, 3, "")}) == 0);
}

TEST_CASE("an insertion stands before a replacement at its place, and keeps its order among others") {
    EditList edits{edit(2, 4, "X"), edit(2, 2, "1"), edit(2, 2, "2")};
    sort_edits(edits);
    REQUIRE(in_order(edits));
    CHECK(edited("abcdef", edits) == "ab12Xef");
    CHECK_FALSE(in_order({edit(0, 3, ""), edit(2, 4, "")}));
    CHECK_FALSE(in_order({edit(3, 4, ""), edit(0, 1, "")}));
}

TEST_CASE("edits go together when they do not meet") {
    CHECK(compatible({edit(0, 3, "x")}, {edit(3, 5, "y")}));
    CHECK_FALSE(compatible({edit(0, 3, "x")}, {edit(2, 5, "y")}));
    CHECK_FALSE(compatible({edit(0, 3, "x")}, {edit(3, 3, "y")}));
    CHECK_FALSE(compatible({edit(3, 3, "x")}, {edit(3, 3, "y")}));
    CHECK(compatible({edit(3, 3, "x")}, {edit(4, 4, "y")}));
    CHECK(compatible({{{FileId{0}, 0, 3}, "x"}}, {{{FileId{1}, 0, 3}, "x"}}));
}

TEST_CASE("two rounds composed are one round of the original") {
    CHECK(rc::check([] {
        const std::string text = any_text();
        const EditList first = any_edits(text.size());
        const std::string between = edited(text, first);
        const EditList second = any_edits(between.size());
        const EditList both = then(first, second);
        RC_ASSERT(in_order(both));
        RC_ASSERT(edited(text, both) == edited(between, second));
        RC_ASSERT(edited(text, minimal(text, both)) == edited(between, second));
        RC_ASSERT(then(first, {}) == then({}, first));
    }));
}

TEST_CASE("rounds are composed file by file") {
    const EditList first{{{FileId{0}, 0, 1}, "A"}, {{FileId{2}, 1, 1}, "x"}};
    const EditList second{{{FileId{1}, 0, 0}, "new "}, {{FileId{2}, 1, 2}, ""}};
    CHECK(then(first, second) == EditList{{{FileId{0}, 0, 1}, "A"}, {{FileId{1}, 0, 0}, "new "}});
}

TEST_CASE("bytes that stay are not part of the least edits") {
    CHECK(minimal("one two three", {edit(0, 13, "one 2 three")}) == EditList{edit(4, 7, "2")});
    CHECK(minimal("aaa", {edit(0, 3, "aa")}) == EditList{edit(2, 3, "")});
    CHECK(minimal("abc", {edit(0, 3, "abc")}).empty());
}

TEST_CASE("a diff with its hunks") {
    std::string text;
    for (int i = 1; i <= 20; ++i)
        text += std::to_string(i) + "\n";
    CHECK(unified_diff("deck.rad", text, {edit(2, 3, "two"), edit(48, 48, "new\n")}) ==
          "--- a/deck.rad\n+++ b/deck.rad\n@@ -1,5 +1,5 @@\n 1\n-2\n+two\n 3\n 4\n 5\n"
          "@@ -17,4 +17,5 @@\n 17\n 18\n 19\n+new\n 20\n");
    CHECK(unified_diff("a b.rad", "x\n", {edit(0, 1, "y")}) ==
          "--- a/a b.rad\t\n+++ b/a b.rad\t\n@@ -1 +1 @@\n-x\n+y\n");
    CHECK(unified_diff("deck.rad", text, {}).empty());
    CHECK(unified_diff("deck.rad", "x", {edit(1, 1, "\ny")}) ==
          "--- a/deck.rad\n+++ b/deck.rad\n@@ -1 +1,2 @@\n-x\n\\ No newline at end of file\n+x\n+y\n"
          "\\ No newline at end of file\n");
    CHECK(unified_diff("deck.rad", "x\r\ny\r\n", {edit(3, 4, "z")}) ==
          "--- a/deck.rad\n+++ b/deck.rad\n@@ -1,2 +1,2 @@\n x\r\n-y\r\n+z\r\n");
}

TEST_CASE("a diff patches the text into the edited one") {
    CHECK(rc::check([] {
        const std::string text = any_text();
        const EditList edits = any_edits(text.size());
        const std::string diff = unified_diff("f", text, edits);
        RC_ASSERT(patched(text, diff) == edited(text, edits));
    }));
}
