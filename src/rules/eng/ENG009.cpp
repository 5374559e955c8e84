#include "rules/lin/bead_report.h"
#include "rules/stb/blank.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const auto misread = misread_slopes(context, *a);
        if (!misread) continue;
        const double fn = misread->beyond + misread->difference;
        Draft draft = draft_at_header(context, *a->bead);
        draft.message =
            "slopes of " + bead_name(*a->bead) +
            ": the manual gives each segment its own; the solver reads them with the place of the "
            "bead node, " +
            counted(misread->node.size(), "node") + (misread->node.size() == 1 ? " differs" : " differ") +
            ": " + fn_force_text(context, *a, fn);
        measure_cost(context, *a, fn, 0, draft);
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule ENG009{{.code = "ENG009",
                          .name = "slope-read-by-node",
                          .summary = "the ramp slope of a segment is read with the place of the bead node",
                          .severity = Severity::info},
                         needs_first_cycle,
                         check};

} // namespace drawbead
