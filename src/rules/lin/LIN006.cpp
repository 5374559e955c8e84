#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_order(context)) {
        if (!a->check.loop_open) continue;
        const LineHop& closing = a->check.closing;
        const std::size_t last = a->x.size() - 1;
        const double fn = -(a->fn.front() + a->fn[last]) / 2 * closing.length;
        const double ft = -(a->ft.front() + a->ft[last]) / 2 * closing.length;
        const UnitSystem& units = context.deck.work_units();
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, last);
        draft.related.push_back(places.front());
        draft.message = "the ends of " + bead_name(*a->bead) + ", nodes " +
                        std::to_string(node_id(context, *a, 0)) + " and " +
                        std::to_string(node_id(context, *a, last)) + ", are only " +
                        quantity(closing.length, units, length_dimension) +
                        " apart but the loop is not closed; the step between them is missing: " +
                        cost_text(context, *a, fn, ft);
        draft.entities.nodes.add(node_id(context, *a, 0));
        draft.entities.nodes.add(node_id(context, *a, last));
        draft.measured.push_back({"open step", closing.length, unit_name(units, length_dimension)});
        measure_cost(context, *a, fn, ft, draft);
        draft.help =
            "end the list with a new node at the place of the first one; repeating the first id stops the "
            "Engine";
        draft.fixes.push_back({"a new node at the place of the first one", FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule LIN006{{.code = "LIN006",
                          .name = "loop-not-closed",
                          .summary = "the ends of the bead nearly meet, and the step between them is missing",
                          .severity = Severity::warning,
                          .fix = FixAvailability::unsafe},
                         needs_closest,
                         check};

} // namespace drawbead
