#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const NodeGroup& group : context.model.groups()) {
        std::vector<Span> places;
        std::vector<int64_t> ids;
        for (const ListedNode& node : group.listed)
            if (node.written < 0) {
                places.push_back(node.place);
                ids.push_back(node.written);
            }
        if (places.empty()) continue;
        Draft draft;
        set_places(draft, places);
        draft.discriminator = std::to_string(group.id);
        for (const int64_t id : ids)
            draft.entities.nodes.add(id);
        draft.message = counted(ids.size(), "negative id") + " in node group " + std::to_string(group.id) +
                        " (" + listed(ids) + "): the solver leaves " + (ids.size() == 1 ? "it" : "them") +
                        (group.type == "SET" ? " out (warning 1902)" : " out without a message");
        draft.notes.push_back("the hop over a node that is left out counts as bead length");
        draft.help = "write the id without its sign, or take it out";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule REF007{
    {.code = "REF007",
     .name = "negative-id-in-list",
     .summary = "the node list of a drawbead holds negative ids, which the solver leaves out",
     .severity = Severity::warning},
    Needs::none,
    check};

} // namespace drawbead
