#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <string_view>

namespace drawbead {

namespace {

constexpr int first_layout_with_normal = 130, first_layout_with_last = 2022;

constexpr const char* title = "the version on /BEGIN that reads them";
constexpr int first_layout_with_units = 100; // on /BEGIN: below, more than the number has to change

/// The /BEGIN whose version holds for a scope; nullptr where it cannot be raised.
const Block* begin_of(const Deck& deck, const Scope& scope) {
    const Block* begin = nullptr;
    for (const Block& block : deck.blocks())
        if (block.keyword == "BEGIN" && deck.scope(block.scope).version == scope.version &&
            (block.header.file == scope.file || !begin))
            begin = &block;
    return scope.layout < first_layout_with_units ? nullptr : begin;
}

struct Dropped {
    std::string_view name;
    Cell cell;
};

void collect(const Card& card, std::string_view column, std::string_view name,
             std::vector<Dropped>& dropped) {
    const Cell& cell = card[column];
    if (cell.given()) dropped.push_back({name, cell});
}

double written(const std::vector<Dropped>& dropped, std::string_view name) {
    for (const Dropped& one : dropped)
        if (one.name == name) return one.cell.real;
    return 0;
}

/// What a limit adds up to along the line as it is read, and as the card describes it; forces per length.
void compare(const RuleContext& context, const Drawbead& bead, const char* what, double read, double meant,
             Draft& draft) {
    const double length = line_length(context.model, bead);
    if (read == meant || length == 0) return;
    const UnitSystem& units = context.deck.work_units();
    std::string note = std::string("the ") + what + " is " + quantity(read * length, units, force_dimension) +
                       " instead of " + force_over_line(context, bead, meant);
    if (meant != 0)
        note += " (" + std::string(read > meant ? "+" : "") + number(100 * (read / meant - 1), 2) + " %)";
    draft.notes.push_back(std::move(note));
    draft.measured.push_back({std::string(what) + " as read minus as written", (read - meant) * length,
                              unit_name(units, force_dimension)});
}

void add_cost(const RuleContext& context, const Drawbead& bead, const std::vector<Dropped>& dropped,
              Draft& draft) {
    const Block& block = context.deck.blocks()[bead.block];
    const double factor =
        context.deck.factor(block.scope, block.unit, force_per_length_dimension).value_or(1);
    const auto mean = [](double first, double last) { return last == 0 ? first : (first + last) / 2; };
    const double fn = bead.fn_first != 0 ? bead.fn_first : factor * written(dropped, "Fn");
    if (fn != 0)
        compare(context, bead, "normal force", bead.fn_first, mean(fn, factor * written(dropped, "Fn_last")),
                draft);
    compare(context, bead, "restraint", bead.ft_first,
            mean(bead.ft_first, factor * written(dropped, "Ft_last")), draft);
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        const CardLines& cards = cards_of(context, bead);
        const Scope& scope = scope_of(context.deck, bead);
        if (!cards.usable() || scope.layout >= first_layout_with_last) continue;
        std::vector<Dropped> dropped;
        if (cards.has_card(2) && scope.layout < first_layout_with_normal) {
            const Card card = all_columns(context.deck, bead, cards.lines[2], 2);
            collect(card, "1-20", "Fn", dropped);
            collect(card, "41-60", "DEPTH", dropped);
        }
        if (cards.has_card(3)) {
            const Card card = all_columns(context.deck, bead, cards.lines[3], 3);
            collect(card, "1-20", "Fn_last", dropped);
            collect(card, "21-40", "Ft_last", dropped);
        }
        if (dropped.empty()) continue;

        const bool any =
            std::any_of(dropped.begin(), dropped.end(), [](const Dropped& d) { return d.cell.real != 0; });
        if (any) std::erase_if(dropped, [](const Dropped& d) { return d.cell.real == 0; });

        Draft draft = draft_at_header(context, bead);
        std::vector<Span> places;
        std::string names;
        for (const Dropped& one : dropped) {
            places.push_back(one.cell.place);
            if (!names.empty()) names += &one == &dropped.back() ? " and " : ", ";
            names += std::string(one.name) + (any ? " = " + number(one.cell.real) : "");
        }
        set_places(draft, places);
        draft.message = "version " + std::to_string(scope.version) + " does not read " + names + " of " +
                        bead_name(bead) + ": ";
        if (!any) {
            draft.severity = Severity::info;
            draft.discriminator =
                "zeros"; // another finding than that of values: raising the version ends in it
            draft.message += "with 0 nothing is lost";
            draft.help = "leave the columns blank, or raise the version on /BEGIN";
            sink.add(std::move(draft));
            continue;
        }
        const bool normal = dropped.front().name == "Fn" || dropped.front().name == "DEPTH";
        draft.message += normal ? "no normal force, and the restraint acts at any distance"
                                : "the limits are constant along the bead";
        add_cost(context, bead, dropped, draft);
        draft.notes.emplace_back(
            "the solver says nothing: it cuts the card by the layout of the version on /BEGIN");
        draft.help = "raise the version on /BEGIN to " +
                     std::to_string(dropped.back().name.find("_last") != std::string_view::npos
                                        ? first_layout_with_last
                                        : first_layout_with_normal) +
                     " or later, after a look at what it changes elsewhere; or take the values out";
        if (begin_of(context.deck, scope)) draft.fixes.push_back({title, FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const Drawbead* bead = drawbead_of(context, draft);
    if (!bead || draft.severity == Severity::info) return planner.decline("with 0 nothing is lost");
    const Deck& deck = context.deck;
    const Scope& scope = scope_of(deck, *bead);
    const Block* begin = begin_of(deck, scope);
    if (!begin) return planner.decline("below version 100 the whole of /BEGIN would have to change");
    DataLines lines(deck, *begin);
    Span line;
    if (!lines.next(line) || !lines.next(line)) return planner.decline("/BEGIN has no version");
    const bool normal_alone = draft.message.find("_last") == std::string::npos;
    const int version = normal_alone ? first_layout_with_normal : first_layout_with_last;
    planner.cells().set_columns(line, 1, 10, std::to_string(version));
    Fix fix{title, FixAvailability::unsafe, {}};
    for (const Drawbead& other : context.model.drawbeads())
        if (&scope_of(deck, other) == &scope || scope_of(deck, other).version == scope.version)
            fix.changes.push_back({other.id, 0, 0});
    fix.uncovers = hidden_by_cards(); // Iform of version 100 stands in other columns, for one
    return fix;
}

} // namespace

extern const Rule SYN002{
    {.code = "SYN002",
     .name = "value-ignored-by-version",
     .summary = "Fn, DEPTH, Fn_last or Ft_last are given, but the version on /BEGIN has no such fields",
     .severity = Severity::error,
     .fix = FixAvailability::unsafe},
    Needs::coordinates,
    check,
    Needs::none,
    fix};

} // namespace drawbead
