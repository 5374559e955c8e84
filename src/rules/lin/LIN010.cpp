#include "rules/lin/step_report.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_order(context))
        report_steps(context, *a, a->check.too_fine, false,
                     {"shorter than a fifth of the element under it", "element",
                      "more nodes do not resolve more than the elements do, one node puts down at most",
                      "one to two nodes per element are enough"},
                     sink);
}

} // namespace

extern const Rule LIN010{
    {.code = "LIN010",
     .name = "spacing-too-fine",
     .summary = "steps along the bead are shorter than a fifth of the elements under them",
     .severity = Severity::info},
    needs_closest,
    check};

} // namespace drawbead
