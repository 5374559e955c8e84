#include "model/option_reader.h"
#include "rules/lin/list_repair.h"
#include "rules/support.h"

#include <algorithm>

namespace drawbead {

namespace {

constexpr const char* title = "remove the interface";

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!cards_usable(context, bead)) continue;
        const DrawbeadCells cells = cells_of(bead);
        const bool known =
            readable(cells.fn) && readable(cells.ft) && readable(cells.fn_last) && readable(cells.ft_last);
        if (known && bead.fn_first == 0 && bead.ft_first == 0 && bead.fn_last == 0 && bead.ft_last == 0) {
            Draft draft = draft_at_header(context, bead);
            draft.discriminator = "no force";
            if (bead.cards[1].present) draft.primary = bead.cards[1].line;
            draft.message = "Fn and Ft of " + bead_name(bead) + " are 0: it does nothing";
            draft.help = "give forces per length, or remove the interface";
            draft.fixes.push_back({title, FixAvailability::unsafe});
            sink.add(std::move(draft));
        }
        if (!bead.group) continue;
        const NodeGroup& group = context.model.groups()[*bead.group];
        if (!group.evaluated || !group.nodes.empty() || !group.listed.empty() ||
            group.order == NodeGroup::Order::sorted)
            continue;
        Draft draft = draft_at_header(context, bead);
        draft.discriminator = "no nodes";
        draft.primary = context.deck.blocks()[group.block].header;
        draft.message = "node group " + std::to_string(group.id) + " of " + bead_name(bead) +
                        " is empty: the bead has no nodes and does nothing";
        draft.help = "list the nodes along the bead, or remove the interface";
        note_lost_include(context, "what the group holds", draft);
        if (draft.notes.empty()) draft.fixes.push_back({title, FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

/// Takes the header and the data of a block away; comments and includes among them stay.
void remove_block(const Deck& deck, BlockIndex index, FixPlanner& planner) {
    const Block& block = deck.blocks()[index];
    planner.cells().delete_lines(block.header);
    DataLines lines(deck, block);
    std::vector<Span> data;
    for (Span line; lines.next(line);)
        data.push_back(line);
    while (!data.empty() && trim(deck.text(data.back())).empty())
        data.pop_back();
    for (const Span& line : data)
        planner.cells().delete_lines(line);
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const Deck& deck = context.deck;
    const Drawbead* bead = drawbead_of(context, draft);
    if (!bead) return planner.decline("the interface is not known");
    if (draft.discriminator == "no nodes" && !lost_include_note(deck).empty())
        return planner.decline("an include could not be read: its nodes may stand there");
    for (BlockIndex i = 0; i < deck.blocks().size(); ++i) {
        const Block& block = deck.blocks()[i];
        const int64_t offset = deck.scope(block.scope).offsets.general;
        const auto is_its_id = [&](int64_t written) { return Deck::global_id(written, offset) == bead->id; };
        if (is_option(block.keyword, "INTER/SUB")) {
            IssueLog unreported;
            OptionReader reader(deck, i, unreported);
            Span line;
            if (reader.line(line) &&
                is_its_id(read_cell(deck, block.scope, line, 1, 10, Kind::integer).integer))
                return planner.decline(header_name(block) + " is a part of the interface");
        }
        if (!is_interface_history(block)) continue;
        const std::vector<ListedNode> ids = listed_interfaces(deck, i);
        std::vector<const ListedNode*> dropped;
        for (const ListedNode& id : ids)
            if (is_its_id(id.written)) dropped.push_back(&id);
        if (!dropped.empty() && dropped.size() == ids.size())
            remove_block(deck, i, planner);
        else
            drop_entries(deck, i, ids, dropped, planner);
    }
    remove_block(deck, bead->block, planner);
    return Fix{title, FixAvailability::unsafe, {{bead->id, 0, 0}}};
}

} // namespace

extern const Rule REF006{{.code = "REF006",
                          .name = "dead-interface",
                          .summary = "a drawbead has neither Fn nor Ft, or no nodes",
                          .severity = Severity::warning,
                          .fix = FixAvailability::unsafe},
                         Needs::coordinates,
                         check,
                         Needs::none,
                         fix};

} // namespace drawbead
