#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    const auto& admesh = context.model.admesh();
    if (!admesh) return;
    const std::vector<const BeadAnalysis*> beads = beads_with_nodes(context);
    if (beads.empty()) return;
    Draft draft;
    draft.primary = context.deck.blocks()[admesh->block].header;
    std::vector<int64_t> ids;
    double fn = 0, ft = 0;
    for (const BeadAnalysis* a : beads) {
        ids.push_back(a->bead->id);
        fn += a->fn_total;
        ft += a->ft_total;
        if (draft.related.size() < 99) draft.related.push_back(context.deck.blocks()[a->bead->block].header);
    }
    const UnitSystem& units = context.deck.work_units();
    draft.message = "the run refines the mesh under " + std::string(ids.size() == 1 ? "bead " : "beads ") +
                    listed(ids) +
                    ", and beads draw the refinement on; all that is said here of segments, "
                    "distances and stiffness holds for the mesh of the deck, the limits of " +
                    quantity(fn, units, force_dimension) + " of Fn and " +
                    quantity(ft, units, force_dimension) + " of Ft stay: 0 N, 0 % of their total";
    sink.add(std::move(draft));
}

} // namespace

extern const Rule CTX006{{.code = "CTX006",
                          .name = "mesh-refines",
                          .summary = "with adaptive meshing the findings hold for the first mesh only",
                          .severity = Severity::info},
                         needs_lines,
                         check};

} // namespace drawbead
