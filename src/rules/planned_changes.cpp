#include "rules/planned_changes.h"

#include "rules/text.h"

#include <algorithm>

namespace drawbead {

FileChange change_of(const SourceFile& file, const EditList& edits) {
    FileChange change{file.path(), {}};
    for (const Edit& e : edits) {
        FileEdit made;
        made.offset = e.at.begin;
        made.removed = e.at.size();
        made.text = e.text;
        const SourceFile::Position begin = file.at(e.at.begin), end = file.at(e.at.end);
        made.where.line = begin.line;
        made.where.column = begin.column;
        made.end_line = end.line;
        made.where.end_column = end.column;
        const auto characters = [&](uint64_t offset, uint32_t column) {
            const uint64_t line = offset - (column - 1);
            const auto in_characters = static_cast<uint32_t>(character_count(file.text(line, offset))) + 1;
            return in_characters == column ? 0 : in_characters;
        };
        made.where.character_column = characters(e.at.begin, begin.column);
        made.where.end_character_column = characters(e.at.end, end.column);
        change.edits.push_back(std::move(made));
    }
    return change;
}

ChangePlanner::ChangePlanner(const CheckedDeck& checked)
    : checked_(checked), options_(*checked.deck, unreported_), ids_(*checked.deck, options_, checked.model) {}

void ChangePlanner::add_changes(const RuleDraft& one, std::vector<FixOffer>& offers) const {
    const Deck& deck = *checked_.deck;
    FreeIds ids = ids_;
    FixPlanner planner(deck, options_, ids, {});
    const std::optional<Fix> fix = one.rule->fix(checked_.context(), one.draft, planner);
    if (!fix || planner.failed()) return;
    const auto offer =
        std::find_if(offers.begin(), offers.end(), [&](const FixOffer& o) { return o.title == fix->title; });
    if (offer == offers.end()) return;
    const EditList edits = planner.edits();
    std::size_t bytes = 0;
    for (const Edit& e : edits)
        bytes += e.text.size();
    if (edits.size() > most_edits || bytes > most_bytes) return;
    for (std::size_t i = 0; i < deck.files().size(); ++i) {
        const SourceFile& file = *deck.files()[i];
        const EditList mine = minimal(file.bytes(), of_file(edits, FileId{static_cast<uint32_t>(i)}));
        if (!mine.empty()) offer->changes.push_back(change_of(file, mine));
    }
}

} // namespace drawbead
