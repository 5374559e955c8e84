#include "rules/lin/bead_report.h"
#include "rules/stb/blank.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const Drawbead& bead = *a->bead;
        if (bead.depth <= 0 || a->ft_total == 0) continue;
        double ft = 0; // at the start of the ramp
        if (bead.fn_first == 0) {
            ft = a->ft_total;
        } else if (const auto ramp = ramp_of(context, *a)) {
            for (std::size_t i = 0; i < ramp->node.size(); ++i)
                if (ramp->node[i].read.value_or(ramp->node[i].slope) >= ramp->node[i].k) ft += a->ft_force(i);
        }
        if (ft == 0) continue;
        Draft draft = draft_at(context, bead, cells_of(bead).ft);
        draft.message = "restraint of " + bead_name(bead) +
                        " on the ramp: the manual is silent; the solver lets it grow with the "
                        "depth only where Fn is not 0 and its slope is below the stiffness of the sheet, " +
                        (bead.fn_first == 0 ? "here Fn is 0" : "here the slope is not") +
                        "; it begins with: " + ft_force_text(context, *a, ft);
        measure_cost(context, *a, 0, ft, draft);
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule ENG004{{.code = "ENG004",
                          .name = "restraint-without-gradual-start",
                          .summary = "the restraint does not grow along the ramp as the normal force does",
                          .severity = Severity::info},
                         needs_first_cycle,
                         check};

} // namespace drawbead
