#include "rules/lin/list_repair.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

constexpr const char* title = "blank columns in their place";

bool is_zero(const RuleContext& context, const ListedNode& node) {
    return node.written == 0 && trim(context.deck.text(node.place)).substr(0, 1) == "0";
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const NodeGroup& group : context.model.groups()) {
        std::vector<Span> places;
        for (const ListedNode& node : group.listed)
            if (is_zero(context, node)) places.push_back(node.place);
        if (places.empty()) continue;
        Draft draft;
        set_places(draft, places);
        draft.discriminator = std::to_string(group.id);
        draft.message = "the list of node group " + std::to_string(group.id) + " holds " +
                        counted(places.size(), "zero") + ", which the solver skips" +
                        (group.type == "SET" ? " (warning 1902)" : "");
        draft.help = "leave the columns blank, or write the node that was meant";
        draft.fixes.push_back({title, FixAvailability::safe});
        sink.add(std::move(draft));
    }
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    for (const NodeGroup& group : context.model.groups()) {
        if (std::to_string(group.id) != draft.discriminator) continue;
        std::vector<const ListedNode*> zeros;
        for (const ListedNode& node : group.listed)
            if (is_zero(context, node)) zeros.push_back(&node);
        drop_listed(context.deck, group, zeros, planner);
    }
    return Fix{title, FixAvailability::safe, {}};
}

} // namespace

extern const Rule SYN008{{.code = "SYN008",
                          .name = "stray-zero-in-list",
                          .summary = "the node list of a drawbead holds zeros, which the solver skips",
                          .severity = Severity::info,
                          .fix = FixAvailability::safe},
                         Needs::none,
                         check,
                         Needs::none,
                         fix};

} // namespace drawbead
