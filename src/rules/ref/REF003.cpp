#include "rules/lin/list_repair.h"
#include "rules/support.h"

namespace drawbead {

namespace {

constexpr const char* title = "the nodes in order, in a /GRNOD/NODENS";

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!bead.group || !cards_usable(context, bead)) continue;
        const NodeGroup& group = context.model.groups()[*bead.group];
        if (group.order != NodeGroup::Order::sorted) continue;
        Draft draft = draft_at_header(context, bead);
        draft.primary = context.deck.blocks()[group.block].header;
        const Cell& cell = cells_of(bead).group;
        if (cell.given()) draft.related.push_back(cell.place);
        const bool set = group.type.substr(0, 3) == "SET";
        draft.message =
            "node group " + std::to_string(group.id) + " of " + bead_name(bead) + " is a /" +
            (set ? "SET without a NODENS clause" : "GRNOD/" + group.type) +
            ", which the solver sorts by id: the order along the bead is lost and the Starter stops";
        draft.help = set ? "list the nodes along the bead in one NODENS clause"
                         : "list the nodes in the order along the bead in a /GRNOD/NODENS";
        if (const BeadAnalysis* a = analysed_bead(context, draft))
            if (const SortedOrder sorted = order_of_sorted(*a); !sorted.order.empty())
                draft.fixes.push_back({title, sorted.safe ? FixAvailability::safe : FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const BeadAnalysis* a = analysed_bead(context, draft);
    const SortedOrder sorted = a ? order_of_sorted(*a) : SortedOrder{};
    if (sorted.order.empty()) return planner.decline("the nodes do not lie along one line");
    Fix fix{title, sorted.safe ? FixAvailability::safe : FixAvailability::unsafe, {}};
    fix.uncovers = hidden_by_list(); // rules about lists keep quiet where the order is not the author's
    if (!make_ordered(context, *a, sorted, planner, fix)) return std::nullopt;
    return fix;
}

} // namespace

extern const Rule REF003{{.code = "REF003",
                          .name = "node-group-sorted",
                          .summary = "the node group of a drawbead is of a type that the solver sorts",
                          .severity = Severity::error,
                          .fix = FixAvailability::sometimes_safe,
                          .starter_message = 112},
                         needs_closest,
                         check,
                         needs_list_users,
                         fix};

} // namespace drawbead
