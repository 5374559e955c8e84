#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

using Missing = CardLines::Missing;

constexpr const char* blank_line = "a blank line in its place";
constexpr const char* comment = "'#' before what is not read";
constexpr const char* comment_shift = "'#' before the line that shifts the cards";

/// Whether a blank line is all that is missing: what stood on the other cards only their author knows.
bool blank_is_enough(Missing missing) {
    return missing == Missing::title || missing == Missing::card_3 || missing == Missing::blank_card;
}

/// Lines after the last card that hold something.
std::vector<Span> extra_lines(const Deck& deck, const CardLines& cards) {
    std::vector<Span> extra;
    for (std::size_t i = 4; i < cards.lines.size(); ++i)
        if (!trim(deck.text(cards.lines[i])).empty()) extra.push_back(cards.lines[i]);
    return extra;
}

void report_missing(const RuleContext& context, const Drawbead& bead, const CardLines& cards,
                    FindingSink& sink) {
    Draft draft = draft_at_header(context, bead);
    const std::string name = bead_name(bead);
    const std::string version = std::to_string(scope_of(context.deck, bead).version);
    const auto line = [&](std::size_t i) {
        if (cards.lines.empty()) return draft.primary;
        return i < cards.lines.size() ? cards.lines[i] : cards.lines.back();
    };
    draft.help = "give the title and all cards, a blank line where a card has no values";
    switch (cards.missing) {
    case Missing::nothing:
        return;
    case Missing::all:
        draft.message = name + " has neither a title nor cards";
        break;
    case Missing::title:
        draft.primary = line(0);
        draft.message =
            name + " has no title line: its first card is taken as the title, and every other card as the "
                   "one before it";
        draft.help = "put a title line below the header; it may be blank";
        break;
    case Missing::card_1:
        draft.primary = line(1);
        draft.message = name + " has no card with the node group, the surface and Iform";
        if (cards.lines.size() > 1) draft.message += ": forces are read as ids";
        break;
    case Missing::card_2:
        draft.primary = line(cards.lines.size() - 1);
        draft.message = name + " has no card with Fn, Ft, DEPTH and times: all of them are read as 0";
        break;
    case Missing::card_2_or_3:
        draft.primary = line(2);
        draft.message =
            name + " has 2 of the 3 cards of version " + version +
            ": the last one is read as Fn and Ft, whether it was meant as that or as Fn_last and Ft_last";
        break;
    case Missing::card_3:
        draft.primary = line(2);
        draft.message =
            name + " has no third card: Fn_last and Ft_last are read as 0, so Fn and Ft are constant along "
                   "the bead";
        draft.help = "add the third card; a blank line keeps Fn and Ft constant";
        break;
    case Missing::blank_card:
        draft.primary = line(2);
        draft.severity = Severity::info;
        draft.message = name + " has no third card; it is blank in version " + version +
                        ", and the solver reads on "
                        "without it";
        draft.help = "add a blank line";
        break;
    }
    if (blank_is_enough(cards.missing)) draft.fixes.push_back({blank_line, FixAvailability::safe});
    sink.add(std::move(draft));
}

void report_extra(const RuleContext& context, const Drawbead& bead, const CardLines& cards,
                  FindingSink& sink) {
    if (cards.lines.size() <= 4) return;
    Draft draft = draft_at_header(context, bead);
    draft.discriminator = "extra";
    if (cards.shifted) {
        draft.primary = cards.lines[1];
        draft.message = bead_name(bead) +
                        " has a line too many above its first card: it is read as the first card, and "
                        "every card as the one after it";
        draft.help = "keep one title line, or write '#' before the line";
        draft.fixes.push_back({comment_shift, FixAvailability::safe});
        sink.add(std::move(draft));
        return;
    }
    const std::vector<Span> extra = extra_lines(context.deck, cards);
    if (extra.empty()) return;
    set_places(draft, extra);
    draft.message = counted(extra.size(), "line") + " after the last card of " + bead_name(bead) +
                    (extra.size() == 1 ? " is" : " are") + " not read";
    draft.help = "remove " + std::string(extra.size() == 1 ? "it" : "them") + ", or write '#' before it";
    draft.fixes.push_back({comment, FixAvailability::safe});
    sink.add(std::move(draft));
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        const CardLines& cards = cards_of(context, bead);
        report_missing(context, bead, cards, sink);
        report_extra(context, bead, cards, sink);
    }
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const Drawbead* bead = drawbead_of(context, draft);
    if (!bead) return planner.decline("the interface is not known");
    const Deck& deck = context.deck;
    const CardLines cards = card_lines(deck, *bead);
    const auto begin_of = [](const Span& line) { return Span{line.file, line.begin, line.begin}; };
    Fix fix{blank_line, FixAvailability::safe, {{bead->id, 0, 0}}};
    fix.uncovers = hidden_by_cards();
    if (draft.discriminator == "extra") {
        fix.title = cards.shifted ? comment_shift : comment;
        if (cards.shifted) {
            planner.cells().replace(begin_of(cards.lines[1]), "#");
        } else {
            for (const Span& line : extra_lines(deck, cards))
                planner.cells().replace(begin_of(line), "#");
        }
        return fix;
    }
    if (!blank_is_enough(cards.missing))
        return planner.decline("what stood on the missing card is not known");
    const BlockEnd end = block_end(deck, bead->block);
    if (cards.missing == Missing::title)
        planner.cells().replace(begin_of(cards.lines[0]), end.line_end);
    else
        planner.add_after(bead->block, end.unended ? end.line_end + end.line_end : end.line_end);
    return fix;
}

} // namespace

extern const Rule SYN001{
    {.code = "SYN001",
     .name = "card-missing",
     .summary = "the title or a card of a drawbead is absent, or data follow its last card",
     .severity = Severity::error,
     .fix = FixAvailability::sometimes_safe},
    Needs::none,
    check,
    Needs::none,
    fix};

} // namespace drawbead
