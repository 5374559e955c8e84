// Fingerprints hold through edits that change no entity: over every deck on the pages of the rules.
#include "literate.h"
#include "rules/rule.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <sstream>

using namespace drawbead;

namespace {

using Texts = std::map<std::string, std::string>;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += line + "\n";
    return text;
}

bool is_header(const std::string& line) {
    return !line.empty() && line[0] == '/';
}

/// A file cut before each keyword line; comments above one stay with the block before.
std::vector<std::string> blocks_of(const std::string& text) {
    std::vector<std::string> blocks(1);
    for (const std::string& line : lines_of(text)) {
        if (is_header(line)) blocks.emplace_back();
        blocks.back() += line + "\n";
    }
    return blocks;
}

/// Comments above every keyword line and data line that may have one.
std::string with_comments(const std::string& text) {
    std::vector<std::string> out;
    for (const std::string& line : lines_of(text)) {
        if (is_header(line) && !out.empty()) out.insert(out.end(), {"# a comment", "#", "# and another one"});
        out.push_back(line);
    }
    return joined(out);
}

/// What the order means something for: directives, submodels, units before what uses them, damage to headers.
bool order_matters(const std::string& text) {
    for (const std::string& line : lines_of(text))
        if (line.starts_with("#include") || line.starts_with("#enddata") || line.starts_with("//") ||
            line.starts_with("/PARAMETER"))
            return true;
    return blocks_of(text).back().substr(0, 4) != "/END";
}

/// Blocks between /BEGIN and /END the other way round. Tables of nodes and elements, too.
std::string reordered(const std::string& text) {
    std::vector<std::string> blocks = blocks_of(text);
    const auto begin = std::find_if(blocks.begin(), blocks.end(),
                                    [](const std::string& b) { return b.starts_with("/BEGIN"); });
    if (begin == blocks.end() || order_matters(text)) return text;
    std::reverse(begin + 1, blocks.end() - 1);
    std::string out;
    for (const std::string& block : blocks)
        out += block;
    return out;
}

std::vector<std::string> prints_of(const DeckResult& result) {
    std::vector<std::string> all;
    for (const Finding& f : result.findings)
        all.push_back(f.code + " " + f.fingerprint);
    std::sort(all.begin(), all.end());
    return all;
}

void each_example(const std::function<void(const literate::Document&, const literate::Example&)>& act) {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(DRAWBEAD_RULES_DIR))
        if (entry.path().extension() == ".md") paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    REQUIRE(paths.size() >= registry().size());
    for (const std::string& path : paths) {
        const literate::Document document = literate::read_document(path);
        for (const literate::Example& example : document.examples)
            act(document, example);
    }
}

} // namespace

TEST_CASE("comments above do not change fingerprints") {
    each_example([](const literate::Document& document, const literate::Example& example) {
        INFO(document.code << ", the deck at line " << example.page_line);
        Texts texts = literate::texts_of(example);
        const std::vector<std::string> before = prints_of(literate::run_texts(texts));
        for (auto& [name, text] : texts)
            text = with_comments(text);
        CHECK(prints_of(literate::run_texts(texts)) == before);
    });
}

TEST_CASE("the order of blocks does not change fingerprints") {
    std::size_t tried = 0;
    each_example([&](const literate::Document& document, const literate::Example& example) {
        INFO(document.code << ", the deck at line " << example.page_line);
        Texts texts = literate::texts_of(example);
        std::string& main = texts["deck.rad"];
        const std::string moved = reordered(main);
        if (moved == main) return;
        ++tried;
        const std::vector<std::string> before = prints_of(literate::run_texts(texts));
        main = moved;
        CHECK(prints_of(literate::run_texts(texts)) == before);
    });
    CHECK(tried > 100);
}

TEST_CASE("blocks that move into an include keep their fingerprints") {
    std::size_t tried = 0;
    each_example([&](const literate::Document& document, const literate::Example& example) {
        INFO(document.code << ", the deck at line " << example.page_line);
        Texts texts = literate::texts_of(example);
        std::string& main = texts["deck.rad"];
        std::vector<std::string> blocks = blocks_of(main);
        const auto begin = std::find_if(blocks.begin(), blocks.end(),
                                        [](const std::string& b) { return b.starts_with("/BEGIN"); });
        if (begin == blocks.end() || order_matters(main)) return;
        ++tried;
        const std::vector<std::string> before = prints_of(literate::run_texts(texts));
        std::string head, moved;
        for (auto at = blocks.begin(); at != blocks.end() - 1; ++at)
            (at <= begin ? head : moved) += *at;
        texts["moved.inc"] = moved;
        main = head + "#include moved.inc\n" + blocks.back();
        // An include may bring a finding of its own (SYN011), and takes none away.
        const std::vector<std::string> after = prints_of(literate::run_texts(texts));
        INFO(after.size() << " after, " << before.size() << " before");
        CHECK(std::includes(after.begin(), after.end(), before.begin(), before.end()));
    });
    CHECK(tried > 100);
}

TEST_CASE("another id makes another fingerprint") {
    const literate::Document document = literate::read_document(DRAWBEAD_RULES_DIR "/lin/LIN005.md");
    const auto print_of = [](const Texts& texts) {
        for (const Finding& f : literate::run_texts(texts).findings)
            if (f.code == "LIN005") return f.fingerprint;
        return std::string();
    };
    Texts texts = literate::texts_of(document.examples.at(0));
    const std::string before = print_of(texts);
    REQUIRE_FALSE(before.empty());
    const auto renumber = [&](const std::string& from, const std::string& to) {
        Texts changed = texts;
        std::string& main = changed["deck.rad"];
        for (std::size_t at = 0; (at = main.find(from, at)) != std::string::npos; at += to.size())
            main.replace(at, from.size(), to);
        return print_of(changed);
    };
    const std::string node = renumber("       105", "       905"),
                      bead = renumber("/INTER/TYPE8/1\n", "/INTER/TYPE8/8\n");
    CHECK_FALSE(node.empty());
    CHECK(node != before); // the node at the corner
    CHECK_FALSE(bead.empty());
    CHECK(bead != before);
    CHECK(renumber("       101", "       901") == before); // a node that has nothing to do with it
}
