#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        double fn = 0, ft = 0;
        std::vector<std::size_t> own;
        for (std::size_t i = 0; i < a->hit.size(); ++i) {
            if (a->hit[i].segment == no_segment) continue;
            // A node of the surface is its own closest point; segments around it hold it.
            const auto& n = a->surface->segments[a->hit[i].segment].n;
            if (std::find(n.begin(), n.end(), a->group->nodes[i]) == n.end()) continue;
            own.push_back(i);
            fn += a->fn_force(i);
            ft += a->ft_force(i);
        }
        if (own.empty()) continue;
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, own.front());
        std::vector<int64_t> ids;
        for (const std::size_t i : own) {
            ids.push_back(node_id(context, *a, i));
            draft.entities.nodes.add(ids.back());
            if (i != own.front() && draft.related.size() < 99) draft.related.push_back(places[i]);
        }
        draft.place_count = own.size();
        draft.message = counted(own.size(), "node") + " of " + bead_name(*a->bead) +
                        (own.size() == 1 ? " belongs" : " belong") + " to its main surface " +
                        std::to_string(a->surface->id) + " (" + listed(ids) +
                        "); bead and blank are mixed up, and the bead presses on itself: " +
                        force_text(context, *a, fn, ft);
        measure_cost(context, *a, fn, ft, draft);
        draft.help = "the group holds the nodes of the tool, the surface the segments of the blank";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SRF005{{.code = "SRF005",
                          .name = "roles-swapped",
                          .summary = "the main surface holds nodes of the bead itself",
                          .severity = Severity::error},
                         needs_closest,
                         check};

} // namespace drawbead
