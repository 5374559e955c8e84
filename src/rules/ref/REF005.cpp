#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

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
                        (nodes.count == 1 ? " does not exist" : " do not exist (" + listed(nodes.ids) + ")") +
                        ": the Starter stops";
        if (std::string note = lost_include_note(context.deck); !note.empty())
            draft.notes.push_back(std::move(note));
        draft.help = "define the node, or take it out of the list";
        for (const Drawbead& bead : context.model.drawbeads())
            if (bead.group && &context.model.groups()[*bead.group] == &group) {
                draft.interface_id = bead.id;
                break;
            }
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule REF005{{.code = "REF005",
                          .name = "node-undefined",
                          .summary = "the node group of a drawbead lists nodes that do not exist",
                          .severity = Severity::error},
                         Needs::coordinates,
                         check};

} // namespace drawbead
