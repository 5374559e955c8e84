#include "rules/lin/step_report.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_order(context))
        report_steps(context, *a, a->check.over_element, true,
                     {"longer than the element under it", "element",
                      "segments between two nodes get no force and those under a node all of it, up to",
                      "list a bead node for every element that the bead crosses"},
                     sink);
}

} // namespace

extern const Rule LIN009{{.code = "LIN009",
                          .name = "spacing-over-element",
                          .summary = "steps along the bead are longer than the elements under them",
                          .severity = Severity::warning},
                         needs_closest,
                         check};

} // namespace drawbead
