#include "rules/lin/bead_report.h"
#include "rules/stb/blank.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const auto misread = misread_slopes(context, *a);
        if (!misread) continue;
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = misread->node.empty() ? draft_at_header(context, *a->bead)
                                            : draft_at_position(context, *a, places, misread->node.front());
        for (const std::size_t i : misread->node) {
            draft.entities.nodes.add(node_id(context, *a, i));
            if (i != misread->node.front() && draft.related.size() < 99) draft.related.push_back(places[i]);
        }
        draft.place_count = misread->node.size();
        draft.message = "the solver reads the ramp slope of " + bead_name(*a->bead) +
                        " with the node's place in the list, not with its segment: ";
        if (const std::size_t beyond = misread->beyond_count; beyond != 0)
            draft.message += counted(beyond, "node") + (beyond == 1 ? " reads" : " read") + " past the " +
                             counted(a->surface->segments.size(), "segment") + " of surface " +
                             std::to_string(a->surface->id) +
                             " (any value): " + fn_force_text(context, *a, misread->beyond);
        if (const std::size_t wrong = misread->node.size() - misread->beyond_count; wrong != 0)
            draft.message += (misread->beyond_count != 0 ? "; " : "") + counted(wrong, "node") +
                             (wrong == 1 ? " takes" : " take") + " the slope of another segment: " +
                             fn_force_text(context, *a, misread->difference);
        if (misread->node.empty()) {
            draft.severity = Severity::warning;
            draft.message += "at the start all slopes are right (0 N, 0 % of its total), but not those of "
                             "segments of another stiffness that the blank brings under the bead";
        }
        measure_cost(context, *a, misread->beyond + misread->difference, 0, draft);
        draft.help = misread->mixed
                         ? "a larger DEPTH avoids the reset (STB001); or use a surface of one stiffness"
                         : "use the whole blank as main surface, or fewer bead nodes";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule STB003{{.code = "STB003",
                          .name = "slope-index-mismatch",
                          .summary = "bead nodes read the ramp slope of another segment, or none",
                          .severity = Severity::error},
                         needs_first_cycle,
                         check};

} // namespace drawbead
