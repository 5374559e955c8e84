#include "rules/lin/bead_report.h"
#include "rules/lin/list_repair.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

namespace {

constexpr const char* title = "one interface and group per arm";

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
        draft.fixes.push_back({title, FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const BeadAnalysis* a = analysed_bead(context, draft);
    if (!a) return planner.decline("the interface has no list of nodes");
    // The tip is the end of both arms: half a step of each, as the solver takes the ends of a line.
    const std::vector<std::vector<uint32_t>> arms = cut_at_nodes(*a, a->check.folds);
    Fix fix{title, FixAvailability::unsafe, {}};
    fix.uncovers = {"LIN"};
    if (!split_bead(context, *a, arms, present_limits(*a, arms), planner, fix)) return std::nullopt;
    return fix;
}

} // namespace

extern const Rule LIN004{{.code = "LIN004",
                          .name = "line-folds-back",
                          .summary = "the bead turns back on itself, so that its tributary vectors cancel",
                          .severity = Severity::error,
                          .fix = FixAvailability::unsafe},
                         needs_closest,
                         check,
                         needs_list_users,
                         fix};

} // namespace drawbead
