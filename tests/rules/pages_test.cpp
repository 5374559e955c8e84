// Runs every deck of the rules' pages and of cases/*.md. DRAWBEAD_UPDATE=1 rewrites the ```text and ```diff
// fences.
#include "literate.h"
#include "rules/rule.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace drawbead;
using literate::Document;
using literate::Example;

namespace {

std::vector<std::string> markdown_below(const std::string& folder) {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".md") paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

bool updating() {
    const char* wish = std::getenv("DRAWBEAD_UPDATE");
    return wish != nullptr && std::string(wish) == "1";
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += line + "\n";
    return text;
}

bool has_fix(const std::string& code) {
    const Rule* rule = find_rule(code);
    return rule != nullptr && rule->fix != nullptr;
}

/// Writes the present repairs into the page, and one below the first example of a page that has none. From
/// the end, so that line numbers stay true.
void update_diffs(const Document& document) {
    std::vector<std::string> lines = document.lines;
    const bool none = std::none_of(document.examples.begin(), document.examples.end(),
                                   [](const Example& e) { return e.diff_begin.has_value(); });
    const auto at = [&](std::size_t n) { return lines.begin() + static_cast<std::ptrdiff_t>(n); };
    std::optional<std::size_t> first;
    for (std::size_t i = 0; none && has_fix(document.code) && !first && i < document.examples.size(); ++i)
        if (!literate::repair(document.examples[i], document.code, true).diff.empty()) first = i;
    for (std::size_t i = document.examples.size(); i-- > 0;) {
        const Example& example = document.examples[i];
        bool is_unsafe = example.diff_unsafe;
        if (!example.diff_begin && first != i) continue;
        std::vector<std::string> diff = literate::repair(example, document.code, is_unsafe).diff;
        if (example.diff_begin) {
            lines.erase(at(*example.diff_begin), at(*example.diff_end));
            lines.insert(at(*example.diff_begin), diff.begin(), diff.end());
            continue;
        }
        is_unsafe = diff.empty();
        if (is_unsafe) diff = literate::repair(example, document.code, true).diff;
        diff.insert(diff.begin(), {std::string(is_unsafe ? "With `--unsafe`" : "The repair") + ":",
                                   is_unsafe ? "```diff unsafe" : "```diff"});
        diff.push_back("```");
        const std::size_t below = example.text_end ? *example.text_end + 1 : example.end;
        lines.insert(at(below), diff.begin(), diff.end());
    }
    if (lines == document.lines) return;
    std::ofstream out(document.path, std::ios::binary);
    out << joined(lines);
}

/// Writes the present texts into the page, and one below the first firing example of a page that has none.
void update(const Document& document) {
    std::vector<std::string> lines = document.lines;
    const bool none = std::none_of(document.examples.begin(), document.examples.end(),
                                   [](const Example& e) { return e.text_begin.has_value(); });
    std::optional<std::size_t> first;
    for (std::size_t i = 0; none && !first && i < document.examples.size(); ++i)
        if (document.examples[i].expects(document.code)) first = i;
    for (std::size_t i = document.examples.size(); i-- > 0;) { // from the end, so that line numbers stay true
        const Example& example = document.examples[i];
        const auto at = [&](std::size_t n) { return lines.begin() + static_cast<std::ptrdiff_t>(n); };
        std::vector<std::string> text = literate::text_of(example, literate::run(example), document.code);
        if (example.text_begin) {
            lines.erase(at(*example.text_begin), at(*example.text_end));
            lines.insert(at(*example.text_begin), text.begin(), text.end());
        } else if (first == i) {
            text.insert(text.begin(), "```text");
            text.push_back("```");
            lines.insert(at(example.end), text.begin(), text.end());
        }
    }
    if (lines == document.lines) return;
    std::ofstream out(document.path, std::ios::binary);
    out << joined(lines);
}

void run_all(const std::string& folder) {
    for (const std::string& path : markdown_below(folder)) {
        const Document document = literate::read_document(path);
        INFO(path);
        REQUIRE(document.error.empty());
        for (const Example& example : document.examples) {
            const DeckResult result = literate::run(example);
            const std::vector<std::string> different = literate::differences(example, result);
            INFO("the deck at line " << example.page_line << "\n" << joined(different));
            CHECK(different.empty());
            if (example.text_begin && !updating()) {
                const std::vector<std::string> text(
                    document.lines.begin() + static_cast<std::ptrdiff_t>(*example.text_begin),
                    document.lines.begin() + static_cast<std::ptrdiff_t>(*example.text_end));
                CHECK(joined(text) == joined(literate::text_of(example, result, document.code)));
            }
            if (example.diff_begin && !updating()) {
                const std::vector<std::string> diff(
                    document.lines.begin() + static_cast<std::ptrdiff_t>(*example.diff_begin),
                    document.lines.begin() + static_cast<std::ptrdiff_t>(*example.diff_end));
                const literate::Repair repair = literate::repair(example, document.code, example.diff_unsafe);
                CHECK(joined(diff) == joined(repair.diff));
                CHECK(repair.settled);
            }
        }
        if (updating()) {
            update(document);
            update_diffs(literate::read_document(path));
        }
    }
}

} // namespace

TEST_CASE("the decks of the rules' pages give the findings that they promise") {
    run_all(DRAWBEAD_RULES_DIR);
}

TEST_CASE("the decks of the cases give the findings that they promise") {
    run_all(DRAWBEAD_TESTS_DIR "/rules/cases");
}

TEST_CASE("every page has its headings, one example that fires and one that does not, and the text") {
    const std::vector<std::string> headings{"What it does", "Why it matters", "Example", "Fix safety",
                                            "References"};
    for (const Rule& rule : registry()) {
        INFO(rule.info.code);
        std::string family(rule.info.family());
        for (char& c : family)
            c = static_cast<char>(c - 'A' + 'a');
        const Document document = literate::read_document(std::string(DRAWBEAD_RULES_DIR "/") + family + "/" +
                                                          std::string(rule.info.code) + ".md");
        CHECK(document.code == rule.info.code);
        CHECK(document.name == rule.info.name);
        CHECK(document.headings == headings);
        std::size_t firing = 0, clean = 0, texts = 0;
        for (const Example& example : document.examples) {
            ++(example.expects(document.code) ? firing : clean);
            if (example.text_begin) ++texts;
        }
        CHECK(firing > 0);
        CHECK(clean > 0);
        if (rule.fix && !updating())
            CHECK(std::any_of(document.examples.begin(), document.examples.end(),
                              [](const Example& e) { return e.diff_begin.has_value(); }));
        if (!updating()) CHECK(texts > 0);
    }
}
