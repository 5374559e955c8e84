#include "rules/analysis.h"
#include "rules/kin/path_report.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <limits>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const BeadPath* path = path_of(context, *a);
        if (path == nullptr || !path->blank_known() || !path->whole_run || !path->opens) continue;
        if (a->bead->depth <= 0) continue; // no distance is too large
        double nearest = std::numeric_limits<double>::infinity();
        for (const NodePath& node : path->node)
            nearest = std::min(nearest, node.nearest);
        if (!(nearest >= 0)) continue;
        Draft draft = draft_at_header(context, *a->bead);
        const bool over = nearest < std::numeric_limits<double>::infinity();
        draft.message =
            bead_name(*a->bead) + " never engages: from " +
            time_text(context, std::max(a->bead->t_start, 0.0)) + " to " +
            time_text(context, std::min(a->bead->t_stop, path->end)) +
            (over ? " it stays " + length_text(context, nearest) + " beyond DEPTH and half the thickness"
                  : std::string(" it stands beside the sheet")) +
            ": " + cost_text(context, *a, -a->fn_total, -a->ft_total);
        if (!path->bead_moves && !path->blank_moves)
            draft.notes.emplace_back("neither the bead nor the blank under it moves");
        else if (const std::string end = end_text(context); !end.empty())
            draft.notes.push_back(end);
        if (over)
            draft.measured.push_back(
                {"out of reach by", nearest, unit_name(context.deck.work_units(), length_dimension)});
        measure_cost(context, *a, -a->fn_total, -a->ft_total, draft);
        draft.help = "close the tool farther, or place the bead nodes nearer to the sheet";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule KIN004{{.code = "KIN004",
                          .name = "never-engages",
                          .summary = "no bead node comes within reach of the sheet while the window is open",
                          .severity = Severity::warning},
                         needs_motion,
                         check};

} // namespace drawbead
