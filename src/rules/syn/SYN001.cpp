#include "rules/rule.h"

namespace drawbead {

namespace {
void check(const RuleContext&, FindingSink&) {}
} // namespace

extern const Rule SYN001{
    {.code = "SYN001",
     .name = "card-missing",
     .summary = "a title or a card of an interface is missing, or data follow its last card",
     .severity = Severity::error},
    Needs::none,
    check};

} // namespace drawbead
