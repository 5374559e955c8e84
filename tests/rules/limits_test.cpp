// Every limit of the table changes what its rule says of some deck on the rule's page, or of a case.
#include "literate.h"
#include "rules/limits.h"
#include "rules/rule.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

using namespace drawbead;

namespace {

std::vector<literate::Example> examples_of(std::string_view code) {
    std::string family(code.substr(0, 3));
    for (char& c : family)
        c = static_cast<char>(c - 'A' + 'a');
    std::vector<literate::Example> all = literate::read_document(std::string(DRAWBEAD_RULES_DIR "/") +
                                                                 family + "/" + std::string(code) + ".md")
                                             .examples;
    const std::string cases = DRAWBEAD_TESTS_DIR "/rules/cases/limits.md";
    for (literate::Example& one : literate::read_document(cases).examples)
        all.push_back(std::move(one));
    return all;
}

std::vector<std::string> said_by(std::string_view code, const DeckResult& result) {
    std::vector<std::string> all;
    for (const Finding& f : result.findings)
        if (f.code == code) all.push_back(std::string(name(f.severity)) + " " + f.message);
    return all;
}

} // namespace

TEST_CASE("each limit changes what its rule says of a deck") {
    for (const LimitInfo& limit : limit_table()) {
        INFO(limit.rule << " " << limit.key());
        bool changes = false;
        for (const literate::Example& example : examples_of(limit.rule)) {
            const std::vector<std::string> usual = said_by(limit.rule, literate::run(example));
            for (const double value : {limit.least, limit.most}) {
                Limits limits;
                limits.*limit.value = value;
                changes = changes || said_by(limit.rule, literate::run(example, 1, limits)) != usual;
            }
        }
        CHECK(changes);
    }
}

TEST_CASE("the table of limits is sound") {
    std::vector<std::pair<std::string, std::string>> keys;
    const Limits defaults;
    for (const LimitInfo& limit : limit_table()) {
        INFO(limit.rule << " " << limit.key());
        const Rule* rule = find_rule(limit.rule);
        REQUIRE(rule != nullptr);
        CHECK(rule->info.code == limit.rule);
        CHECK(defaults.*limit.value == limit.usual);
        CHECK(limit.least <= limit.usual);
        CHECK(limit.usual <= limit.most);
        CHECK(limit.least < limit.most);
        CHECK_FALSE(limit.text.empty());
        CHECK(limit.text.back() == '.');
        // Texts go into JSON and into a Markdown table as they are.
        CHECK(limit.text.find_first_of("\"\\|\n") == std::string_view::npos);
        CHECK(limit.key().find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos);
        keys.emplace_back(limit.rule, limit.key());
    }
    const auto by_rule = [](const auto& a, const auto& b) { return a.first < b.first; };
    CHECK(std::is_sorted(keys.begin(), keys.end(), by_rule));
    std::sort(keys.begin(), keys.end());
    CHECK(std::adjacent_find(keys.begin(), keys.end()) == keys.end());
}
