#include "rules/lin/step_report.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_order(context))
        report_steps(context, *a, a->check.uneven, true,
                     {"more than three times as long as the next one", "beside it",
                      "the force is put down unevenly, on one node up to", "space the nodes evenly"},
                     sink);
}

} // namespace

extern const Rule LIN011{{.code = "LIN011",
                          .name = "uneven-spacing",
                          .summary = "neighbouring steps along the bead differ by more than a factor of 3",
                          .severity = Severity::info},
                         needs_closest,
                         check};

} // namespace drawbead
