#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_order(context)) {
        const std::vector<LineTurn>& folds = a->check.folds;
        if (folds.empty()) continue;
        double fn = 0, ft = 0;
        for (const LineTurn& fold : folds) {
            fn -= a->fn[fold.at] * fold.lost;
            ft -= a->ft[fold.at] * fold.lost;
        }
        const LineTurn& worst =
            *std::max_element(folds.begin(), folds.end(),
                              [](const LineTurn& p, const LineTurn& q) { return p.degrees < q.degrees; });
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, worst.at);
        draft.message = bead_name(*a->bead) + " turns by " + number(worst.degrees, 3) + " degrees at node " +
                        std::to_string(node_id(context, *a, worst.at));
        if (folds.size() > 1)
            draft.message += " (the sharpest of " + std::to_string(folds.size()) + " folds)";
        draft.message += "; the halves of its two steps cancel: " + cost_text(context, *a, fn, ft);
        for (const LineTurn& fold : folds) {
            if (&fold != &worst) draft.related.push_back(places[fold.at]);
            draft.entities.nodes.add(node_id(context, *a, fold.at));
        }
        draft.measured.push_back({"turn", worst.degrees, "degrees"});
        measure_cost(context, *a, fn, ft, draft);
        draft.help = "split the bead at the fold into two interfaces";
        draft.fixes.push_back({"one interface and group per arm", FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule LIN004{{.code = "LIN004",
                          .name = "line-folds-back",
                          .summary = "the bead turns back on itself, so that its tributary vectors cancel",
                          .severity = Severity::error,
                          .fix = FixAvailability::unsafe},
                         needs_closest,
                         check};

} // namespace drawbead
