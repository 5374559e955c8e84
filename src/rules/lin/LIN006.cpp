#include "model/attachments.h"
#include "model/members.h"
#include "rules/lin/bead_report.h"
#include "rules/lin/list_repair.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <set>

namespace drawbead {

namespace {

constexpr const char* title = "a new node at the place of the first one";

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_order(context)) {
        if (!a->check.loop_open || a->check.closed_by_repeat) continue; // of the latter LIN003 speaks first
        const LineHop& closing = a->check.closing;
        const std::size_t last = a->x.size() - 1;
        const double fn = -(a->fn.front() + a->fn[last]) / 2 * closing.length;
        const double ft = -(a->ft.front() + a->ft[last]) / 2 * closing.length;
        const UnitSystem& units = context.deck.work_units();
        const std::vector<Span> places = list_places(context, *a);
        Draft draft = draft_at_position(context, *a, places, last);
        draft.related.push_back(places.front());
        draft.message = "the ends of " + bead_name(*a->bead) + ", nodes " +
                        std::to_string(node_id(context, *a, 0)) + " and " +
                        std::to_string(node_id(context, *a, last)) + ", are only " +
                        quantity(closing.length, units, length_dimension) +
                        " apart but the loop is not closed; the step between them is missing: " +
                        cost_text(context, *a, fn, ft);
        draft.entities.nodes.add(node_id(context, *a, 0));
        draft.entities.nodes.add(node_id(context, *a, last));
        draft.measured.push_back({"open step", closing.length, unit_name(units, length_dimension)});
        measure_cost(context, *a, fn, ft, draft);
        draft.help =
            "end the list with a new node at the place of the first one; repeating the first id stops the "
            "Engine";
        draft.fixes.push_back({title, FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

/// The line of a node under another id.
std::string line_with_id(const Deck& deck, const Span& line, int layout, int64_t written) {
    std::string text(deck.text(line)), id = std::to_string(written);
    if (const std::size_t comma = text.find(','); comma != std::string::npos)
        return text.replace(0, comma, id);
    const std::size_t width = layout < 45 ? 8 : 10;
    if (id.size() > width || text.size() < width) return {};
    return text.replace(0, width, std::string(width - id.size(), ' ') + id);
}

/// Adds a node to every list that holds another one, and says which lists these are.
std::set<BlockIndex> add_beside(const RuleContext& context, int64_t node, int64_t added, const NodeGroup& own,
                                FixPlanner& planner) {
    const Deck& deck = context.deck;
    std::set<BlockIndex> lists;
    IssueLog unreported;
    for (const Option& option : planner.options().all(Family::node_group)) {
        const Block& block = deck.blocks()[option.block];
        if (option.block == own.block || !is_node_list(block.keyword)) continue;
        const bool of_a_bead = std::any_of(
            context.model.groups().begin(), context.model.groups().end(), [&](const NodeGroup& group) {
                return group.block == option.block && group.order == NodeGroup::Order::unsorted &&
                       group.users.empty();
            });
        if (of_a_bead) continue;
        const int64_t offset = deck.scope(block.scope).offsets.node;
        const std::vector<WrittenId> ids = read_ids(deck, block, unreported);
        if (std::none_of(ids.begin(), ids.end(),
                         [&](const WrittenId& id) { return Deck::global_id(id.id, offset) == node; }))
            continue;
        if (added - offset <= 0) continue;
        append_entry(deck, option.block, ids.back().place, 0, added - offset, planner);
        lists.insert(option.block);
    }
    return lists;
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const BeadAnalysis* a = analysed_bead(context, draft);
    if (!a || !a->check.loop_open) return planner.decline("the bead is no open loop");
    const Deck& deck = context.deck;
    const NodeGroup& group = *a->group;
    const bool listed = group.order == NodeGroup::Order::unsorted && !group.listed.empty() &&
                        group.listed.back().row == group.nodes.back();
    if (!listed) return planner.decline("the nodes of the bead are not listed in its own group");
    const NodeRow first = group.nodes.front();
    const int64_t id = node_id(context, *a, 0);
    const Span line = context.model.node_line(first);
    BlockFinder blocks(deck);
    const Block* table = blocks.at(line);
    if (!table) return planner.decline("the line of the first node is not known");
    const auto table_index = static_cast<BlockIndex>(table - deck.blocks().data());
    const Scope& scope = deck.scope(table->scope);
    if (instances_of(deck, table_index).size() > 1 || instances_of(deck, group.block).size() > 1)
        return planner.decline("the nodes stand in a file that is included more than once");

    const int64_t written = planner.free_node_id(table_index);
    if (written == 0) return std::nullopt;
    const int64_t added = Deck::global_id(written, scope.offsets.node);
    const std::string text = line_with_id(deck, line, scope.layout, written);
    if (text.empty()) return planner.decline("the line of the first node cannot be copied");
    planner.add_after(table_index, text + block_end(deck, table_index).line_end);

    const int64_t in_list = added - deck.scope(deck.blocks()[group.block].scope).offsets.node;
    if (in_list <= 0) return planner.decline("the list cannot name the new node");
    append_entry(deck, group.block, group.listed.back().place, group.type == "SET" ? 1 : 0, in_list, planner);
    std::set<BlockIndex> lists = add_beside(context, id, added, group, planner);
    lists.insert(group.block);

    // What holds or moves the first node has to hold the new one, too.
    IssueLog unreported;
    const std::span<const Attachment> held = context.model.attachments(first);
    for (const Holder& holder : read_holders(deck, planner.options(), unreported)) {
        const Attachment& by = holder.attachment;
        if (std::none_of(held.begin(), held.end(), [&](const Attachment& h) { return h.block == by.block; }))
            continue;
        if (holder.group &&
            (lists.count(*holder.group) != 0 || deck.blocks()[*holder.group].keyword == "GRNOD/GRNOD"))
            continue;
        return planner.decline(header_name(deck.blocks()[by.block]) +
                               " holds the first node, but not by a list that can take a new one");
    }
    for (const Block& block : deck.blocks()) {
        if (!is_option(block.keyword, "TRANSFORM")) continue;
        const auto index = static_cast<BlockIndex>(&block - deck.blocks().data());
        OptionReader reader(deck, index, unreported);
        Span card;
        if (!reader.line(card)) continue;
        const int64_t moved = read_cell(deck, block.scope, card, 1, 10, Kind::integer).integer;
        const auto of = planner.options().find(
            Family::node_group, Deck::global_id(moved, deck.scope(block.scope).offsets.general));
        if (moved != 0 && (!of || lists.count(*of) == 0))
            return planner.decline("a /TRANSFORM moves nodes, and may not move the new one");
    }
    return Fix{title, FixAvailability::unsafe, {{a->bead->id, 0, 1}}};
}

} // namespace

extern const Rule LIN006{{.code = "LIN006",
                          .name = "loop-not-closed",
                          .summary = "the ends of the bead nearly meet, and the step between them is missing",
                          .severity = Severity::warning,
                          .fix = FixAvailability::unsafe},
                         needs_closest,
                         check,
                         needs_list_users | Needs::attachments,
                         fix};

} // namespace drawbead
