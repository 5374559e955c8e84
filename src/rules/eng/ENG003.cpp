#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/stb/blank.h"
#include "rules/support.h"
#include "rules/text.h"

#include <cmath>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const Drawbead& bead = *a->bead;
        if (bead.fn_first == 0 || !bead.fn_varies() || bead.depth <= 0) continue;
        const auto ramp = ramp_of(context, *a);
        if (!ramp || ramp->slope.kind != Slope::ramp) continue; // a reset: ENG002
        double sum = 0, worst = 0;
        std::size_t worst_node = 0;
        for (std::size_t i = 0; i < a->fn.size(); ++i) {
            const double jump = (a->fn[i] - bead.fn_first) * a->line.tributary[i];
            sum += std::abs(jump);
            if (std::abs(jump) > std::abs(worst)) worst = jump, worst_node = i;
        }
        if (sum == 0) continue;
        const UnitSystem& units = context.deck.work_units();
        Draft draft = draft_at(context, bead, cells_of(bead).fn_last);
        if (sum < context.limits.ENG003_warning_share * std::abs(a->fn_total))
            draft.severity = Severity::info;
        draft.message =
            "linear Fn of " + bead_name(bead) +
            ": by the manual the force varies along the bead; in the solver the ramp of every node "
            "keeps Fn_first/DEPTH, and at DEPTH the force jumps to its own limit (node " +
            std::to_string(node_id(context, *a, worst_node)) + ": " + (worst > 0 ? "+" : "") +
            quantity(worst, units, force_dimension) + "), together: " + fn_force_text(context, *a, sum);
        draft.measured.push_back({"largest jump", worst, unit_name(units, force_dimension)});
        measure_cost(context, *a, sum, 0, draft);
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule ENG003{{.code = "ENG003",
                          .name = "linear-force-over-constant-ramp",
                          .summary = "with Fn_last the plateau varies along the bead, the ramp does not",
                          .severity = Severity::warning},
                         needs_first_cycle,
                         check};

} // namespace drawbead
