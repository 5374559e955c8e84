#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/stb/blank.h"
#include "rules/support.h"
#include "rules/text.h"
#include "scene/holding_force.h"

#include <algorithm>
#include <map>

namespace drawbead {

namespace {

/// Beads that one rigid body carries, and what they push it with.
struct Tool {
    std::vector<const BeadAnalysis*> beads;
    Vec3 lift; ///< of all plateaus, along the normals of the sheet
};

void check(const RuleContext& context, FindingSink& sink) {
    std::map<int64_t, Tool> tools;
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const InterfaceContact* first = first_cycle(context, *a);
        if (first == nullptr || a->fn_total <= 0) continue;
        std::optional<int64_t> body;
        for (const Attachment& held : context.model.attachments(a->group->nodes.front()))
            if (held.kind == Attachment::Kind::rigid_body) body = held.id;
        if (!body) continue;
        Tool& tool = tools[*body];
        tool.beads.push_back(a);
        for (std::size_t i = 0; i < a->x.size(); ++i)
            tool.lift += a->fn_force(i) * first->contact.node[i].normal;
    }
    const UnitSystem& units = context.deck.work_units();
    for (const auto& [id, tool] : tools) {
        const auto held = holding_force(context.model, id);
        const double lift = norm(tool.lift);
        if (!held || !held->unknown.empty() || !(lift > 0)) continue;
        double holding = 0; // at its strongest
        for (const double t : held->times())
            holding = std::max(holding, -dot(held->at(t), tool.lift) / lift);
        if (!(holding > 0)) continue; // it presses another way
        const double share = lift / holding;
        if (share <= context.limits.CTX005_least_share) continue;
        Draft draft;
        draft.primary = context.deck.blocks()[held->blocks.front()].header;
        draft.discriminator = "tool " + std::to_string(id);
        std::vector<int64_t> ids;
        for (const BeadAnalysis* a : tool.beads) {
            ids.push_back(a->bead->id);
            draft.related.push_back(context.deck.blocks()[a->bead->block].header);
        }
        if (tool.beads.size() == 1) draft.interface_id = ids.front();
        if (share < 1) draft.severity = Severity::info;
        draft.message = "the beads on rigid body " + std::to_string(id) + " (" + listed(ids) +
                        ") push it with " + quantity(lift, units, force_dimension) +
                        " when they are closed, " + number(100 * share, 3) + " % of the " +
                        quantity(holding, units, force_dimension) + " that hold it" +
                        (share < 1 ? "; so much less is left for the sheet" : "; they lift it off the sheet");
        const std::string unit = unit_name(units, force_dimension);
        draft.measured.push_back({"force of the beads", lift, unit});
        draft.measured.push_back({"holding force", holding, unit});
        draft.measured.push_back({"share of the holding force", 100 * share, "%"});
        draft.help = "raise the holding force by what the beads take, or move the tool by its travel";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule CTX005{{.code = "CTX005",
                          .name = "beads-lift-the-binder",
                          .summary = "the normal forces of a tool's beads against the force that holds it",
                          .severity = Severity::warning},
                         needs_first_cycle | Needs::attachments | Needs::motion,
                         check};

} // namespace drawbead
