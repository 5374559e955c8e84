#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const NodeGroup& group : context.model.groups()) {
        std::vector<Span> places;
        for (const ListedNode& node : group.listed)
            if (node.written == 0 && trim(context.deck.text(node.place)).substr(0, 1) == "0")
                places.push_back(node.place);
        if (places.empty()) continue;
        Draft draft;
        set_places(draft, places);
        draft.discriminator = std::to_string(group.id);
        draft.message = "the list of node group " + std::to_string(group.id) + " holds " +
                        counted(places.size(), "zero") + ", which the solver skips";
        draft.help = "leave the columns blank, or write the node that was meant";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SYN008{{.code = "SYN008",
                          .name = "stray-zero-in-list",
                          .summary = "the node list of a drawbead holds zeros, which the solver skips",
                          .severity = Severity::info},
                         Needs::none,
                         check};

} // namespace drawbead
