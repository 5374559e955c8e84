#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        std::vector<std::size_t> open;
        std::size_t in_surface = 0, beside = 0;
        double fn = 0, ft = 0;
        for (std::size_t i = 0; i < a->side.node.size(); ++i) {
            if (a->side.node[i] != Facing::unknown) continue;
            // The Starter turns the faces of coated solids outward, and so toward the bead.
            if (a->surface->segments[a->hit[i].segment].solid_backed) continue;
            open.push_back(i);
            fn += a->fn_force(i);
            ft += a->ft_force(i);
            if (a->hit[i].closest.in_contact_range())
                in_surface += !a->side.decides[i];
            else
                ++beside;
        }
        if (open.empty()) continue;
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, open.front());
        for (const std::size_t i : open) {
            draft.entities.nodes.add(node_id(context, *a, i));
            if (i != open.front() && draft.related.size() < 99) draft.related.push_back(places[i]);
        }
        draft.place_count = open.size();
        const bool crossing = in_surface + beside < open.size();
        draft.message = "the side of surface " + std::to_string(a->surface->id) + " on which " +
                        bead_name(*a->bead) + " stands cannot be told for " + counted(open.size(), "node") +
                        " of " + std::to_string(a->x.size()) + " (" +
                        (crossing          ? "it crosses the surface"
                         : beside == 0     ? "it lies in the surface"
                         : in_surface == 0 ? "it lies beside the surface"
                                           : "it lies in the surface or beside it") +
                        "); if the segments look away, " + force_text(context, *a, fn, ft) +
                        ", acts at any distance and to the wrong side";
        measure_cost(context, *a, fn, ft, draft);
        if (beside > 0) note_lost_include(context, "more of the surface", draft);
        draft.help = "place the bead clearly on the tool's side of the blank";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SRF004{{.code = "SRF004",
                          .name = "side-undecidable",
                          .summary = "the bead lies in its main surface, beside it or across it",
                          .severity = Severity::warning},
                         needs_sides,
                         check};

} // namespace drawbead
