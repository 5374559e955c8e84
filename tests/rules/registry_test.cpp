#include "literate.h"
#include "rules/rule.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <set>

using namespace drawbead;

TEST_CASE("rules are sorted by code, and codes and names are unique") {
    std::set<std::string_view> names;
    std::string_view last;
    for (const Rule& rule : registry()) {
        INFO(rule.info.code);
        CHECK(last < rule.info.code);
        last = rule.info.code;
        CHECK(names.insert(rule.info.name).second);
        CHECK(rule.check != nullptr);
    }
    CHECK(registry().size() > 10);
}

TEST_CASE(
    "codes are three letters and three digits, names kebab-case, summaries sentences without a full stop") {
    const auto letter = [](char c) { return c >= 'A' && c <= 'Z'; };
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    for (const Rule& rule : registry()) {
        const std::string_view code = rule.info.code, name = rule.info.name;
        INFO(code << " " << name);
        REQUIRE(code.size() == 6);
        CHECK(std::all_of(code.begin(), code.begin() + 3, letter));
        CHECK(std::all_of(code.begin() + 3, code.end(), digit));
        CHECK(std::all_of(name.begin(), name.end(),
                          [&](char c) { return (c >= 'a' && c <= 'z') || digit(c) || c == '-'; }));
        CHECK(name.front() != '-');
        CHECK(name.back() != '-');
        REQUIRE_FALSE(rule.info.summary.empty());
        CHECK(rule.info.summary.back() != '.');
    }
}

TEST_CASE("every rule file is in the registry, with its page, and every page has a rule") {
    std::set<std::string> files, pages, rules;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(DRAWBEAD_RULES_DIR)) {
        const std::filesystem::path path = entry.path();
        if (!entry.is_regular_file() || path.parent_path() == std::filesystem::path(DRAWBEAD_RULES_DIR))
            continue;
        const std::string stem = path.stem().string();
        if (stem.size() != 6 || stem[3] < '0' || stem[3] > '9') continue; // helpers of a family
        if (path.extension() == ".cpp") files.insert(stem);
        if (path.extension() == ".md") pages.insert(stem);
    }
    for (const Rule& rule : registry()) {
        rules.insert(std::string(rule.info.code));
        CHECK(rule.info.page.substr(0, 9) == "# " + std::string(rule.info.code) + " ");
    }
    CHECK(files == rules);
    CHECK(pages == rules);
}

TEST_CASE("a rule is found by code and by name") {
    REQUIRE(find_rule("SYN001") != nullptr);
    CHECK(find_rule("SYN001")->info.name == "card-missing");
    CHECK(find_rule("card-missing") == find_rule("SYN001"));
    CHECK(find_rule("SYN") == nullptr);
    CHECK(find_rule("") == nullptr);
}
