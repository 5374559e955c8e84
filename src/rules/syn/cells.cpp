#include "rules/syn/cells.h"

#include "rules/support.h"

#include <algorithm>
#include <map>

namespace drawbead {

namespace {

std::optional<ReadIssue::Kind> kind_of(CellState state) {
    switch (state) {
    case CellState::garbage:
        return ReadIssue::Kind::not_a_number;
    case CellState::not_finite:
        return ReadIssue::Kind::not_finite;
    case CellState::unknown_parameter:
        return ReadIssue::Kind::unknown_parameter;
    default:
        return std::nullopt;
    }
}

bool wanted(std::span<const ReadIssue::Kind> kinds, ReadIssue::Kind kind) {
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

} // namespace

std::vector<CellTrouble> cell_troubles(const RuleContext& context, std::span<const ReadIssue::Kind> kinds) {
    std::vector<CellTrouble> troubles;
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!cards_usable(context, bead)) continue;
        for (std::size_t i = 0; i < bead.cards.size(); ++i) {
            const Card& card = bead.cards[i];
            for (std::size_t k = 0; k < card.cells.size(); ++k) {
                const Cell& cell = card.cells[k];
                const auto kind = kind_of(cell.state);
                if (!kind || !wanted(kinds, *kind)) continue;
                troubles.push_back({*kind,
                                    {cell.place},
                                    1,
                                    std::string(cell.text),
                                    std::string(card.schema->fields[k].name) + " of " + bead_name(bead),
                                    true,
                                    bead.id});
            }
        }
    }
    BlockFinder blocks(context.deck);
    std::map<std::pair<const Block*, ReadIssue::Kind>, std::size_t> known;
    for (const ReadIssue& issue : context.model.issues()) {
        if (!wanted(kinds, issue.kind)) continue;
        const Block* block = blocks.at(issue.place);
        if (block && block->keyword.substr(0, 11) == "INTER/TYPE8") continue; // told above
        const auto [at, added] = known.emplace(std::pair(block, issue.kind), troubles.size());
        if (added)
            troubles.push_back({issue.kind,
                                {},
                                0,
                                issue.subject,
                                block ? header_name(*block) : "the deck",
                                block && concerns_drawbeads(*block),
                                std::nullopt});
        troubles[at->second].places.push_back(issue.place);
        troubles[at->second].count += issue.count;
    }
    return troubles;
}

} // namespace drawbead
