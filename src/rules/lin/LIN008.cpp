#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_order(context)) {
        const std::vector<uint32_t>& branches = a->check.walk.branches;
        if (branches.empty()) continue;
        const double fn = a->line.length > 0 ? a->fn_total * (1 - a->check.walk.length / a->line.length) : 0;
        const double ft = a->line.length > 0 ? a->ft_total * (1 - a->check.walk.length / a->line.length) : 0;
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, branches.front());
        for (const uint32_t i : branches) {
            draft.entities.nodes.add(node_id(context, *a, i));
            if (i != branches.front()) draft.related.push_back(places[i]);
        }
        // Nodes strewn over an area were not meant as arms of anything: what was meant cannot be told.
        if (static_cast<double>(branches.size()) > context.limits.LIN008_error_branches)
            draft.severity = Severity::warning;
        draft.message = "three or more arms of " + bead_name(*a->bead) + " meet at node " +
                        std::to_string(node_id(context, *a, branches.front()));
        if (branches.size() > 1)
            draft.message += " (and at " + std::to_string(branches.size() - 1) + " more)";
        draft.message +=
            "; no order of the list is a line, and the way back from an arm counts as bead: about " +
            cost_text(context, *a, fn, ft);
        measure_cost(context, *a, fn, ft, draft);
        draft.help = "give each arm an interface and a group of its own";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule LIN008{{.code = "LIN008",
                          .name = "line-branches",
                          .summary = "the nodes of the bead form a T or a Y, for which no list order exists",
                          .severity = Severity::error},
                         needs_closest,
                         check};

} // namespace drawbead
