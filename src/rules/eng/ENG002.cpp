#include "rules/lin/bead_report.h"
#include "rules/stb/blank.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const auto ramp = ramp_of(context, *a);
        if (!ramp || ramp->slope.kind != Slope::reset) continue;
        const double jump = a->fn_total - ramp->end_force(*a);
        double longest = 0;
        for (const double length : a->line.tributary)
            longest = std::max(longest, length);
        Draft draft = draft_at(context, *a->bead, cells_of(*a->bead).depth);
        draft.message =
            "reset of " + bead_name(*a->bead) +
            ": by the manual the time step stays as it is; the solver ramps with the stiffness of "
            "the sheet times the number of the node's length (up to " +
            number(longest) + ") and jumps at DEPTH: " + fn_cost_text(context, *a, jump);
        measure_cost(context, *a, jump, 0, draft);
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule ENG002{
    {.code = "ENG002",
     .name = "reset-ramp-jumps",
     .summary = "the ramp after a stiffness reset ends in a jump that the manual does not have",
     .severity = Severity::info},
    needs_first_cycle,
    check};

} // namespace drawbead
