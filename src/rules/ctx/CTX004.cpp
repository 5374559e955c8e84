#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    // A distance is made of differences of coordinates: each of them is off by up to half a unit of its last
    // place, for the bead node and for the point under it, in three directions.
    constexpr double per_coordinate = 3 * std::numeric_limits<float>::epsilon() / 2;
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const double depth = a->bead->depth;
        if (depth <= 0 || a->x.empty()) continue;
        double farthest = 0;
        std::size_t node = 0;
        for (std::size_t i = 0; i < a->x.size(); ++i) {
            const double most = std::max({std::abs(a->x[i].x), std::abs(a->x[i].y), std::abs(a->x[i].z)});
            if (most > farthest) farthest = most, node = i;
        }
        const double off = per_coordinate * farthest;
        if (!(off > context.limits.CTX004_least_share * depth)) continue;
        const double share = std::min(off / depth, 1.0);
        const UnitSystem& units = context.deck.work_units();
        Draft draft = draft_at_position(context, *a, list_places(context, *a), node);
        draft.entities.nodes.add(node_id(context, *a, node));
        draft.message =
            "node " + std::to_string(node_id(context, *a, node)) + " of " + bead_name(*a->bead) + " lies " +
            quantity(farthest, units, length_dimension) +
            " from the origin; in single precision its distance from the sheet is off by up to " +
            quantity(off, units, length_dimension, 3) + ", " + number(100 * share, 3) + " % of DEPTH: " +
            force_text(context, *a, share * a->fn_total, a->bead->fn_first != 0 ? share * a->ft_total : 0);
        draft.measured.push_back({"error of the distance", off, unit_name(units, length_dimension)});
        measure_cost(context, *a, share * a->fn_total, a->bead->fn_first != 0 ? share * a->ft_total : 0,
                     draft);
        draft.notes.emplace_back("the solver in double precision is not concerned");
        draft.help = "move the model to the origin, or run it in double precision";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule CTX004{{.code = "CTX004",
                          .name = "single-precision-distance",
                          .summary = "the bead lies so far out that single precision loses its distance",
                          .severity = Severity::warning},
                         needs_lines,
                         check};

} // namespace drawbead
