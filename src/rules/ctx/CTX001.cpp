#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        std::vector<std::size_t> loose;
        for (std::size_t i = 0; i < a->x.size(); ++i)
            if (context.model.attachments(a->group->nodes[i]).empty()) loose.push_back(i);
        if (loose.empty()) continue;
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, loose.front());
        std::vector<int64_t> ids;
        for (const std::size_t i : loose) {
            ids.push_back(node_id(context, *a, i));
            draft.entities.nodes.add(ids.back());
            if (i != loose.front() && draft.related.size() < 99) draft.related.push_back(places[i]);
        }
        draft.place_count = loose.size();
        const bool all = loose.size() == a->x.size();
        draft.message =
            (all ? "none of the " + counted(a->x.size(), "node") + " of " + bead_name(*a->bead) + " is"
                 : counted(loose.size(), "node") + " of " + bead_name(*a->bead) +
                       (loose.size() == 1 ? " is not" : " are not")) +
            " held or moved by a rigid body, a boundary condition or an imposed motion (" + listed(ids) +
            "); the reaction of the blank throws them away";
        note_lost_include(context, "what holds them", draft);
        draft.help = "add the nodes to the rigid body of their tool";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule CTX001{{.code = "CTX001",
                          .name = "bead-not-attached",
                          .summary = "bead nodes that nothing holds or moves",
                          .severity = Severity::error},
                         needs_lines | Needs::attachments,
                         check};

} // namespace drawbead
