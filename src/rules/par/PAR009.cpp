#include "rules/support.h"
#include "rules/text.h"

#include <string>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    const Deck& deck = context.deck;
    for (const Notice& notice : deck.notices()) {
        if (notice.kind != Notice::Kind::unit_not_understood) continue;
        Draft draft;
        draft.primary = notice.place;
        draft.discriminator = notice.subject;
        // Without a drawbead there is nothing that the tool would convert wrongly.
        if (context.model.drawbeads().empty()) draft.severity = Severity::warning;
        draft.message = "the unit " + quoted(notice.subject) + " is not understood, and taken as the SI unit";
        draft.help = "write a prefix and g, m or s (Mg, mm, s), or a factor to kg, m or s";
        sink.add(std::move(draft));
    }
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (bead.unit_known) continue;
        Draft draft = draft_at_header(context, bead);
        const Block& block = deck.blocks()[bead.block];
        const int64_t unit = block.unit != 0 ? block.unit : deck.scope(block.scope).unit_id;
        draft.message = bead_name(bead) + " names unit system " + std::to_string(unit) +
                        ", which no /UNIT defines: the Starter stops";
        draft.notes.push_back("its values are shown as if they were in work units");
        note_lost_include(context, "the unit", draft);
        draft.help = "define /UNIT/" + std::to_string(unit) + ", or take the unit id off the header";
        sink.add(std::move(draft));
    }
    BlockFinder blocks(deck);
    for (const ReadIssue& issue : context.model.issues()) {
        if (issue.kind != ReadIssue::Kind::unknown_unit) continue;
        const Block* block = blocks.at(issue.place);
        if (block && block->keyword.substr(0, 11) == "INTER/TYPE8") continue; // said above
        Draft draft;
        draft.primary = issue.place;
        draft.discriminator = issue.subject + (block ? header_name(*block) : "");
        if (context.model.drawbeads().empty()) draft.severity = Severity::warning;
        draft.message = (block ? header_name(*block) : issue.detail) + " names unit system " + issue.subject +
                        ", which no /UNIT defines: the Starter stops";
        note_lost_include(context, "the unit", draft);
        draft.help = "define /UNIT/" + issue.subject + ", or take the unit id off the header";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule PAR009{
    {.code = "PAR009",
     .name = "unit-missing",
     .summary = "an option names a unit system that is not defined, or a unit is not understood",
     .severity = Severity::error},
    Needs::none,
    check};

} // namespace drawbead
