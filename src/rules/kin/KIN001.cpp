#include "rules/analysis.h"
#include "rules/kin/path_report.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    const std::optional<double> end = context.analysis.run.end();
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const Drawbead& bead = *a->bead;
        const bool empty = bead.t_stop <= bead.t_start, before = bead.t_stop <= 0;
        const bool late = !empty && end && bead.t_start >= *end;
        if (!empty && !before && !late) continue;
        const DrawbeadCells cells = cells_of(bead);
        Draft draft = draft_at(context, bead, late ? cells.t_start : cells.t_stop);
        draft.message = "the time window of " + bead_name(bead) + ", " + time_text(context, bead.t_start) +
                        " to " + time_text(context, bead.t_stop) +
                        (late     ? ", opens when the run is over"
                         : before ? ", ends before the run begins"
                                  : ", is empty") +
                        "; the bead never acts: " + cost_text(context, *a, -a->fn_total, -a->ft_total);
        if (late) draft.notes.push_back(end_text(context));
        measure_cost(context, *a, -a->fn_total, -a->ft_total, draft);
        draft.help =
            late ? "let Tstart lie within the run" : "let Tstop be later than Tstart, or 0 for no end";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule KIN001{{.code = "KIN001",
                          .name = "window-empty",
                          .summary = "the time window of a bead holds no time of the run",
                          .severity = Severity::error},
                         needs_lines | analysis_run,
                         check};

} // namespace drawbead
