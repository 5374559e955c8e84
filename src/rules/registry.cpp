#include "rules/pages.h"
#include "rules/rule.h"

#include <algorithm>
#include <vector>

namespace drawbead {

// The one table of rules: one line per rule, sorted by code (a test sees to it).
#define DRAWBEAD_RULES(RULE)                                                                                 \
    RULE(CTX001)                                                                                             \
    RULE(CTX002)                                                                                             \
    RULE(CTX003)                                                                                             \
    RULE(CTX004)                                                                                             \
    RULE(CTX005)                                                                                             \
    RULE(CTX006)                                                                                             \
    RULE(CTX007)                                                                                             \
    RULE(ENG001)                                                                                             \
    RULE(ENG002)                                                                                             \
    RULE(ENG003)                                                                                             \
    RULE(ENG004)                                                                                             \
    RULE(ENG005)                                                                                             \
    RULE(ENG006)                                                                                             \
    RULE(ENG007)                                                                                             \
    RULE(ENG008)                                                                                             \
    RULE(ENG009)                                                                                             \
    RULE(ENG010)                                                                                             \
    RULE(KIN001)                                                                                             \
    RULE(KIN002)                                                                                             \
    RULE(KIN003)                                                                                             \
    RULE(KIN004)                                                                                             \
    RULE(KIN005)                                                                                             \
    RULE(KIN006)                                                                                             \
    RULE(KIN007)                                                                                             \
    RULE(LIN001)                                                                                             \
    RULE(LIN002)                                                                                             \
    RULE(LIN003)                                                                                             \
    RULE(LIN004)                                                                                             \
    RULE(LIN005)                                                                                             \
    RULE(LIN006)                                                                                             \
    RULE(LIN007)                                                                                             \
    RULE(LIN008)                                                                                             \
    RULE(LIN009)                                                                                             \
    RULE(LIN010)                                                                                             \
    RULE(LIN011)                                                                                             \
    RULE(LIN012)                                                                                             \
    RULE(LIN013)                                                                                             \
    RULE(LIN014)                                                                                             \
    RULE(PAR001)                                                                                             \
    RULE(PAR002)                                                                                             \
    RULE(PAR003)                                                                                             \
    RULE(PAR004)                                                                                             \
    RULE(PAR005)                                                                                             \
    RULE(PAR006)                                                                                             \
    RULE(PAR007)                                                                                             \
    RULE(PAR008)                                                                                             \
    RULE(PAR009)                                                                                             \
    RULE(REF001)                                                                                             \
    RULE(REF002)                                                                                             \
    RULE(REF003)                                                                                             \
    RULE(REF004)                                                                                             \
    RULE(REF005)                                                                                             \
    RULE(REF006)                                                                                             \
    RULE(REF007)                                                                                             \
    RULE(REF008)                                                                                             \
    RULE(REF009)                                                                                             \
    RULE(SRF001)                                                                                             \
    RULE(SRF002)                                                                                             \
    RULE(SRF003)                                                                                             \
    RULE(SRF004)                                                                                             \
    RULE(SRF005)                                                                                             \
    RULE(SRF006)                                                                                             \
    RULE(SRF007)                                                                                             \
    RULE(SRF008)                                                                                             \
    RULE(SRF009)                                                                                             \
    RULE(SRF010)                                                                                             \
    RULE(SRF011)                                                                                             \
    RULE(STB001)                                                                                             \
    RULE(STB002)                                                                                             \
    RULE(STB003)                                                                                             \
    RULE(STB004)                                                                                             \
    RULE(STB005)                                                                                             \
    RULE(STB006)                                                                                             \
    RULE(SUP001)                                                                                             \
    RULE(SUP002)                                                                                             \
    RULE(SUP003)                                                                                             \
    RULE(SYN001)                                                                                             \
    RULE(SYN002)                                                                                             \
    RULE(SYN003)                                                                                             \
    RULE(SYN004)                                                                                             \
    RULE(SYN005)                                                                                             \
    RULE(SYN006)                                                                                             \
    RULE(SYN007)                                                                                             \
    RULE(SYN008)                                                                                             \
    RULE(SYN009)                                                                                             \
    RULE(SYN010)                                                                                             \
    RULE(SYN011)                                                                                             \
    RULE(SYN012)                                                                                             \
    RULE(SYN013)                                                                                             \
    RULE(SYN014)                                                                                             \
    RULE(SYN015)                                                                                             \
    RULE(SYN016)                                                                                             \
    RULE(SYN017)                                                                                             \
    RULE(SYN018)

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
#define DRAWBEAD_ADDRESS(code) &(code),
    std::vector<Rule> rules;
    for (const Rule* rule : {DRAWBEAD_RULES(DRAWBEAD_ADDRESS)}) {
        rules.push_back(*rule);
        rules.back().info.page = page_of(rule->info.code);
        if (!rule->fix) rules.back().info.fix = FixAvailability::none;
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
