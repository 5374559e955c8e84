#include "rules/lin/list_repair.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

constexpr const char* title = "drop the entries of nodes that do not exist";

void check(const RuleContext& context, FindingSink& sink) {
    for (const NodeGroup& group : context.model.groups()) {
        const Block& block = context.deck.blocks()[group.block];
        const int64_t offset = context.deck.scope(block.scope).offsets.node;
        Draft draft;
        std::vector<Span> places;
        for (const ListedNode& node : group.listed) {
            if (node.row != no_node || node.written <= 0) continue;
            places.push_back(node.place);
            draft.entities.nodes.add(Deck::global_id(node.written, offset));
        }
        if (places.empty()) continue;
        set_places(draft, places);
        const EntityList& nodes = draft.entities.nodes;
        draft.message = (nodes.count == 1 ? "node " + listed(nodes.ids) + " of node group "
                                          : counted(nodes.count, "node") + " of node group ") +
                        std::to_string(group.id) +
                        (nodes.count == 1 ? " does not exist" : " do not exist (" + listed(nodes.ids) + ")");
        if (group.type == "SET") {
            draft.severity = Severity::warning;
            draft.message += nodes.count == 1 ? ": the Starter leaves it out (warning 1902)"
                                              : ": the Starter leaves them out (warning 1902)";
            draft.notes.emplace_back("the hop over a node that is left out counts as bead length");
        } else {
            draft.message += ": the Starter stops";
        }
        const bool may_exist = !lost_include_note(context.deck).empty();
        note_lost_include(context, "it", draft);
        draft.help = "define the node, or take it out of the list";
        for (const Drawbead& bead : context.model.drawbeads())
            if (bead.group && &context.model.groups()[*bead.group] == &group) {
                draft.interface_id = bead.id;
                break;
            }
        if (draft.interface_id && !may_exist && places.size() < group.listed.size())
            draft.fixes.push_back({title, FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const BeadAnalysis* a = analysed_bead(context, draft);
    if (!a || !a->group) return planner.decline("no bead uses the list");
    if (!lost_include_note(context.deck).empty())
        return planner.decline("an include could not be read: the nodes may stand there");
    const NodeGroup& group = *a->group;
    std::vector<const ListedNode*> dropped;
    for (const ListedNode& node : group.listed)
        if (node.row == no_node && node.written > 0) dropped.push_back(&node);
    if (dropped.size() >= group.listed.size()) return planner.decline("no node of the list exists");
    Fix fix{title, FixAvailability::unsafe, {{a->bead->id, 0, dropped.size()}}};
    fix.uncovers = hidden_by_list();
    drop_listed(context.deck, group, dropped, planner);
    return fix;
}

} // namespace

extern const Rule REF005{{.code = "REF005",
                          .name = "node-undefined",
                          .summary = "the node group of a drawbead lists nodes that do not exist",
                          .severity = Severity::error,
                          .fix = FixAvailability::unsafe},
                         Needs::coordinates,
                         check,
                         needs_lines,
                         fix};

} // namespace drawbead
