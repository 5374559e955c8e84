#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        if (a->bead->depth <= 0 && a->bead->fn_first == 0) continue; // no force depends on the side
        double fn = 0, ft = 0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < a->side.node.size(); ++i) {
            if (a->side.node[i] != Facing::away) continue;
            ++count;
            fn += a->fn_force(i);
            ft += a->ft_force(i);
        }
        if (count == 0) continue;
        Draft draft = draft_at_header(context, *a->bead);
        draft.message =
            "reversed segments under " + counted(count, "node") + " of " + bead_name(*a->bead) +
            ": by the manual normals must look at the bead; the solver runs, with all of the force "
            "at any distance" +
            (a->bead->fn_first != 0 ? " and Fn pulling: " : ": ") + force_text(context, *a, fn, ft);
        measure_cost(context, *a, fn, ft, draft);
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule ENG005{{.code = "ENG005",
                          .name = "reversed-normals-run",
                          .summary = "segments that look away from the bead run without an error",
                          .severity = Severity::info},
                         needs_sides,
                         check};

} // namespace drawbead
