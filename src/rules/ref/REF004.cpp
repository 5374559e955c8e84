#include "model/sets.h"
#include "rules/lin/list_repair.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <set>

namespace drawbead {

namespace {

constexpr const char* title = "all nodes in one list";

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!bead.group || !cards_usable(context, bead)) continue;
        const NodeGroup& group = context.model.groups()[*bead.group];
        if (group.order != NodeGroup::Order::lost_in_set) continue;
        Draft draft = draft_at_header(context, bead);
        set_places(draft, group.nodens_clauses);
        if (group.nodens_clauses.empty()) draft.primary = context.deck.blocks()[group.block].header;
        draft.message =
            "set " + std::to_string(group.id) + " of " + bead_name(bead) +
            (group.nodens_clauses.size() > 1 ? " has " + counted(group.nodens_clauses.size(), "NODENS clause")
                                             : " deletes from a NODENS clause or intersects it") +
            ": the solver merges them as if they were sorted, and the order along the bead is lost";
        draft.notes.push_back("tributary lengths follow from the order; no message tells of the loss");
        draft.help = "put all nodes of the bead into one NODENS clause with continuation lines";
        draft.fixes.push_back({title, FixAvailability::safe});
        sink.add(std::move(draft));
    }
}

/// The nodes that the clauses name, in the order in which they stand.
std::vector<NodeRow> meant(const std::vector<SetClause>& clauses, const NodeGroup& group) {
    std::vector<NodeRow> nodes;
    std::size_t next = 0; // of group.listed, which runs over all NODENS clauses
    for (const SetClause& clause : clauses) {
        if (clause.key != "NODENS") continue;
        std::vector<NodeRow> here;
        for (std::size_t k = 0; k < clause.nodes.size() && next < group.listed.size(); ++k, ++next)
            if (group.listed[next].row != no_node) here.push_back(group.listed[next].row);
        const std::set<NodeRow> these(here.begin(), here.end());
        if (clause.remove)
            std::erase_if(nodes, [&](NodeRow node) { return these.count(node) != 0; });
        else if (clause.intersect)
            std::erase_if(nodes, [&](NodeRow node) { return these.count(node) == 0; });
        else
            nodes.insert(nodes.end(), here.begin(), here.end());
    }
    return nodes;
}

/// Whether all NODENS clauses add nodes and stand one after the other in one block: then the first key is
/// enough.
bool are_one_run(const Deck& deck, const std::vector<SetClause>& clauses, const Block& block) {
    std::size_t first = clauses.size(), last = 0, count = 0;
    for (std::size_t i = 0; i < clauses.size(); ++i) {
        if (clauses[i].key != "NODENS") continue;
        if (clauses[i].remove || clauses[i].intersect) return false;
        const Span& at = clauses[i].place;
        if (at.file != block.text.file || at.begin < block.text.begin || at.end > block.text.end)
            return false;
        if (deck.text(at) != "NODENS") return false; // with a suffix
        first = std::min(first, i);
        last = i;
        ++count;
    }
    return count == last - first + 1;
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const BeadAnalysis* a = analysed_bead(context, draft);
    if (!a || !a->group) return planner.decline("the set is not known");
    const Deck& deck = context.deck;
    const NodeGroup& group = *a->group;
    const Block& block = deck.blocks()[group.block];
    IssueLog unreported;
    const std::vector<SetClause> clauses = read_set(deck, planner.options(), group.block, unreported);
    Fix fix{title, FixAvailability::safe, {{a->bead->id, 0, 0}}};
    fix.uncovers = hidden_by_list(); // rules about lists keep quiet where the order is not the author's
    if (are_one_run(deck, clauses, block)) {
        bool first = true;
        for (const SetClause& clause : clauses) {
            if (clause.key != "NODENS") continue;
            if (!first) planner.cells().replace(clause.place, std::string(clause.place.size(), ' '));
            first = false;
        }
        return fix;
    }
    const std::vector<NodeRow> nodes = meant(clauses, group);
    if (nodes.size() < 2) return planner.decline("the clauses leave fewer than two nodes");
    const std::string name = group.title.empty() ? "nodes of " + bead_name(*a->bead) : group.title;
    const int64_t own = add_ordered_group(context, *a, nodes, name + ", along the bead", planner);
    if (own == 0 || !use_group(context, *a, own, planner.cells())) return std::nullopt;
    return fix;
}

} // namespace

extern const Rule REF004{
    {.code = "REF004",
     .name = "node-order-lost-in-set",
     .summary = "a /SET with several NODENS clauses, or one that deletes or intersects, loses the "
                "order along the bead",
     .severity = Severity::error,
     .fix = FixAvailability::safe},
    Needs::none,
    check,
    needs_lines | needs_list_users,
    fix};

} // namespace drawbead
