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

constexpr const char* title = "move it to its columns";

/// The columns of Iform.
std::string_view iform_columns(int layout) {
    return layout >= first_layout_with_iform_in_31 ? "31-40" : "21-30";
}

/// Whether a value on card 1 can only be Iform.
bool is_stray_iform(const Card& card, std::string_view columns, int layout) {
    const Cell& cell = card[columns];
    return layout >= first_layout_with_iform && (cell.integer == 1 || cell.integer == 2) &&
           !has_value(card[iform_columns(layout)]);
}

/// Whether the values on card 3 are those of the two fields, in columns too far to the right.
bool are_shifted_limits(const Card& card, int layout) {
    if (layout < first_layout_with_last || has_value(card["1-20"]) || has_value(card["21-40"])) return false;
    const bool third = has_value(card["41-60"]), fourth = has_value(card["61-80"]),
               fifth = has_value(card["81-100"]);
    return fourth && third != fifth; // two neighbours
}

/// Columns of card 1 behind the surface that the layout leaves blank.
std::vector<std::string_view> blank_columns(int layout) {
    std::vector<std::string_view> columns{"41-50", "51-60", "61-70", "71-80", "81-90", "91-100"};
    if (layout >= first_layout_with_iform_in_31 || layout < first_layout_with_iform)
        columns.insert(columns.begin(), "21-30");
    if (layout < first_layout_with_iform_in_31) columns.emplace_back("31-40");
    return columns;
}

void check_card_1(const RuleContext& context, const Drawbead& bead, const Span& line, FindingSink& sink) {
    const Scope& scope = scope_of(context.deck, bead);
    const Card card = all_columns(context.deck, bead, line, 1);
    const std::string version = "version " + std::to_string(scope.version);
    const std::string_view own = iform_columns(scope.layout);
    const bool has_iform = scope.layout >= first_layout_with_iform;
    for (const std::string_view columns : blank_columns(scope.layout)) {
        const Cell& cell = card[columns];
        if (!has_value(cell)) continue;
        Draft draft = draft_at(context, bead, cell);
        draft.discriminator = columns;
        const std::string value = number(cell.real);
        if (!has_iform) {
            draft.message.append(version).append(" has no Iform, but columns ").append(columns);
            draft.message.append(" hold ").append(value).append(": Iform ");
            draft.message.append(std::to_string(default_iform)).append(" is used");
            if (cell.integer == default_iform) draft.severity = Severity::warning;
            draft.help = "leave the columns blank, or raise the version on /BEGIN to 110 or later";
        } else if (is_stray_iform(card, columns, scope.layout)) {
            draft.fixes.push_back({title, FixAvailability::safe});
            draft.message.append("Iform is read from columns ").append(own).append(" in ").append(version);
            draft.message.append(", but columns ").append(columns).append(" hold ").append(value);
            draft.message.append(": Iform ").append(std::to_string(default_iform));
            draft.message.append(", the default, is used");
            draft.help = "move it to columns " + std::string(own);
        } else {
            draft.message.append("columns ").append(columns).append(" of the first card of ");
            draft.message.append(bead_name(bead)).append(" hold ").append(value).append(", but ");
            draft.message.append(version).append(" reads nothing there");
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
        if (are_shifted_limits(card, scope.layout)) draft.fixes.push_back({title, FixAvailability::safe});
        sink.add(std::move(draft));
    }
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        const CardLines& cards = cards_of(context, bead);
        if (!cards.usable()) continue;
        if (cards.has_card(1)) check_card_1(context, bead, cards.lines[1], sink);
        if (cards.has_card(3)) check_card_3(context, bead, cards.lines[3], sink);
    }
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const Drawbead* bead = drawbead_of(context, draft);
    if (!bead) return planner.decline("the interface is not known");
    const Deck& deck = context.deck;
    const CardLines cards = card_lines(deck, *bead);
    const int layout = scope_of(deck, *bead).layout;
    Fix fix{title, FixAvailability::safe, {{bead->id, 0, 0}}};
    fix.uncovers = hidden_by_cards(); // what the values bring is the author's
    CellEditor& editor = planner.cells();
    constexpr std::string_view of_card_3 = "card 3 ";
    if (draft.discriminator.starts_with(of_card_3)) {
        const Card card = all_columns(deck, *bead, cards.lines[3], 3);
        if (!are_shifted_limits(card, layout))
            return planner.decline("it is not clear which field the value belongs to");
        const bool far = has_value(card["81-100"]);
        const std::string fn(card[far ? "61-80" : "41-60"].text), ft(card[far ? "81-100" : "61-80"].text);
        for (const std::string_view columns : {"41-60", "61-80", "81-100"})
            editor.set_cell(card, columns, "");
        editor.set_cell(card, "1-20", fn);
        editor.set_cell(card, "21-40", ft);
        return fix;
    }
    const Card card = all_columns(deck, *bead, cards.lines[1], 1);
    if (!is_stray_iform(card, draft.discriminator, layout))
        return planner.decline("it is not clear which field the value belongs to");
    const std::string value(card[draft.discriminator].text);
    editor.set_cell(card, draft.discriminator, "");
    editor.set_cell(card, iform_columns(layout), value);
    return fix;
}

} // namespace

extern const Rule SYN003{
    {.code = "SYN003",
     .name = "value-in-wrong-column",
     .summary = "a value of a drawbead stands in columns that the version on /BEGIN leaves blank",
     .severity = Severity::error,
     .fix = FixAvailability::sometimes_safe},
    Needs::none,
    check,
    Needs::none,
    fix};

} // namespace drawbead
