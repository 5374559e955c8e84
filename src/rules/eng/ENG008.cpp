#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        if (!a->order_is_the_authors || a->check.gaps.empty()) continue;
        const Forces pieces = forces_of_pieces(*a, list_pieces(*a));
        const double fn = a->fn_total - pieces.fn, ft = a->ft_total - pieces.ft;
        Draft draft = draft_at_header(context, *a->bead);
        draft.message =
            counted(a->check.gaps.size(), "gap") + " in " + bead_name(*a->bead) +
            ": by the manual each continuous bead is an interface of its own; the solver counts the "
            "hop as length of both its ends: " +
            cost_text(context, *a, fn, ft);
        measure_cost(context, *a, fn, ft, draft);
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule ENG008{{.code = "ENG008",
                          .name = "gap-counts-as-length",
                          .summary = "a gap in the list of a bead is part of its length",
                          .severity = Severity::info},
                         needs_closest,
                         check};

} // namespace drawbead
