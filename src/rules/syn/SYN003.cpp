#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

constexpr int first_layout_with_iform = 100, first_layout_with_iform_in_31 = 110,
              first_layout_with_last = 2022;
constexpr int default_iform = 2;

bool has_value(const Cell& cell) {
    return cell.given() && cell.real != 0;
}

/// Columns of card 1 behind the surface that the layout leaves blank.
std::vector<std::string_view> blank_columns(int layout) {
    std::vector<std::string_view> columns{"41-50", "51-60", "61-70", "71-80", "81-90", "91-100"};
    if (layout >= first_layout_with_iform_in_31 || layout < first_layout_with_iform)
        columns.insert(columns.begin(), "21-30");
    if (layout < first_layout_with_iform_in_31) columns.push_back("31-40");
    return columns;
}

void check_card_1(const RuleContext& context, const Drawbead& bead, const Span& line, FindingSink& sink) {
    const Scope& scope = scope_of(context.deck, bead);
    const Card card = all_columns(context.deck, bead, line, 1);
    const std::string version = "version " + std::to_string(scope.version);
    const std::string_view own = scope.layout >= first_layout_with_iform_in_31 ? "31-40" : "21-30";
    const bool has_iform = scope.layout >= first_layout_with_iform;
    for (const std::string_view columns : blank_columns(scope.layout)) {
        const Cell& cell = card[columns];
        if (!has_value(cell)) continue;
        Draft draft = draft_at(context, bead, cell);
        draft.discriminator = columns;
        const std::string value = number(cell.real);
        const bool could_be_iform = cell.integer == 1 || cell.integer == 2;
        if (!has_iform) {
            draft.message = version + " has no Iform, but columns " + std::string(columns) + " hold " +
                            value + ": Iform " + std::to_string(default_iform) + " is used";
            if (cell.integer == default_iform) draft.severity = Severity::warning;
            draft.help = "leave the columns blank, or raise the version on /BEGIN to 110 or later";
        } else if (could_be_iform && !has_value(card[own])) {
            draft.message = "Iform is read from columns " + std::string(own) + " in " + version +
                            ", but columns " + std::string(columns) + " hold " + value + ": Iform " +
                            std::to_string(default_iform) + ", the default, is used";
            draft.help = "move it to columns " + std::string(own);
        } else {
            draft.message = "columns " + std::string(columns) + " of the first card of " + bead_name(bead) +
                            " hold " + value + ", but " + version + " reads nothing there";
            draft.help = "move the value to its columns, or remove it";
        }
        sink.add(std::move(draft));
    }
}

void check_card_3(const RuleContext& context, const Drawbead& bead, const Span& line, FindingSink& sink) {
    const Scope& scope = scope_of(context.deck, bead);
    const Card card = all_columns(context.deck, bead, line, 3);
    for (const std::string_view columns : {"41-60", "61-80", "81-100"}) {
        const Cell& cell = card[columns];
        if (!has_value(cell)) continue;
        Draft draft = draft_at(context, bead, cell);
        draft.discriminator = "card 3 " + std::string(columns);
        draft.message = "columns " + std::string(columns) + " of the third card of " + bead_name(bead) +
                        " hold " + number(cell.real) + ", but version " + std::to_string(scope.version) +
                        " reads nothing there";
        draft.help = scope.layout >= first_layout_with_last
                         ? "Fn_last is read from columns 1-20, Ft_last from columns 21-40"
                         : "the third card is blank in this version";
        sink.add(std::move(draft));
    }
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        const CardLines cards = card_lines(context.deck, bead);
        if (!cards.usable()) continue;
        if (cards.has_card(1)) check_card_1(context, bead, cards.lines[1], sink);
        if (cards.has_card(3)) check_card_3(context, bead, cards.lines[3], sink);
    }
}

} // namespace

extern const Rule SYN003{
    {.code = "SYN003",
     .name = "value-in-wrong-column",
     .summary = "a value of a drawbead stands in columns that the version on /BEGIN leaves blank",
     .severity = Severity::error},
    Needs::none,
    check};

} // namespace drawbead
