#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/stb/blank.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

/// Whether the solver drops a node beside the rim, where its margin is the smaller one. Inside of the
/// surface ENG010 speaks.
bool dropped(const InterfaceContact* first, const BeadHit& hit, std::size_t i) {
    return first != nullptr && hit.closest.on_free_edge && !first->contact.node[i].inside;
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        if (a->hit.empty()) continue;
        const InterfaceContact* first = first_cycle(context, *a);
        std::vector<std::size_t> beside;
        double fn = 0, ft = 0, covered = 0, length = 0;
        for (std::size_t i = 0; i < a->hit.size(); ++i) {
            length += a->line.tributary[i];
            if (a->hit[i].closest.in_contact_range() && !dropped(first, a->hit[i], i)) {
                covered += a->line.tributary[i];
                continue;
            }
            beside.push_back(i);
            fn -= a->fn_force(i);
            ft -= a->ft_force(i);
        }
        if (beside.empty()) continue;
        const double share = length > 0 ? 100 * covered / length : 0;
        const double spared = context.limits.SRF009_uncovered_share;
        if (spared > 0 && 100 - share <= 100 * spared) continue;
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, beside.front());
        for (const std::size_t i : beside) {
            draft.entities.nodes.add(node_id(context, *a, i));
            if (i != beside.front() && draft.related.size() < 99) draft.related.push_back(places[i]);
        }
        draft.place_count = beside.size();
        draft.message = counted(beside.size(), "node") + " of " + std::to_string(a->x.size()) + " of " +
                        bead_name(*a->bead) + (beside.size() == 1 ? " stands" : " stand") +
                        " over no segment of surface " + std::to_string(a->surface->id) +
                        "; the surface covers " + number(share, 3) +
                        " % of the bead's length: " + cost_text(context, *a, fn, ft);
        if (a->bead->depth <= 0 && a->bead->fn_first != 0)
            draft.notes.emplace_back(
                "without DEPTH the normal force acts beside the surface, too, on its rim");
        draft.measured.push_back({"covered length", share, "%"});
        measure_cost(context, *a, fn, ft, draft);
        note_lost_include(context, "more of the surface", draft);
        draft.help = "end the bead where the blank ends, or choose the surface that lies under it";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SRF009{{.code = "SRF009",
                          .name = "bead-not-over-surface",
                          .summary = "bead nodes stand beside their main surface",
                          .severity = Severity::warning},
                         needs_first_cycle,
                         check};

} // namespace drawbead
