#include "rules/pages.h"
#include "rules/rule.h"

#include <algorithm>
#include <vector>

namespace drawbead {

// The one table of rules: one line per rule, sorted by code (a test sees to it).
#define DRAWBEAD_RULES(RULE) RULE(SYN001)

#define DRAWBEAD_DECLARE(code) extern const Rule code;
DRAWBEAD_RULES(DRAWBEAD_DECLARE)
#undef DRAWBEAD_DECLARE

namespace {

std::string_view page_of(std::string_view code) {
    const auto all = pages();
    const auto at = std::lower_bound(all.begin(), all.end(), code,
                                     [](const Page& page, std::string_view c) { return page.code < c; });
    return at != all.end() && at->code == code ? at->text : std::string_view{};
}

std::vector<Rule> build_registry() {
#define DRAWBEAD_ADDRESS(code) &code,
    std::vector<Rule> rules;
    for (const Rule* rule : {DRAWBEAD_RULES(DRAWBEAD_ADDRESS)}) {
        rules.push_back(*rule);
        rules.back().info.page = page_of(rule->info.code);
    }
#undef DRAWBEAD_ADDRESS
    return rules;
}

} // namespace

std::span<const Rule> registry() {
    static const std::vector<Rule> rules = build_registry();
    return rules;
}

const Rule* find_rule(std::string_view code_or_name) {
    for (const Rule& rule : registry())
        if (rule.info.code == code_or_name || rule.info.name == code_or_name) return &rule;
    return nullptr;
}

} // namespace drawbead
