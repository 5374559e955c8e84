#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

namespace {

constexpr int first_layout_of_tens = 51;

struct Fault {
    ColumnFault what;
    Span line;
    Span place() const { return {line.file, line.begin + what.begin, line.begin + what.end}; }
};

std::string explain(const RuleContext& context, const Fault& fault) {
    const std::string text = quoted(context.deck.text(fault.place()));
    const std::string cell = std::to_string(fault.what.cell);
    switch (fault.what.kind) {
    case ColumnFault::Kind::straddle:
        return text + " crosses the border of two fields, and is read as two numbers";
    case ColumnFault::Kind::several:
        return text + " is the second number in the field that begins at column " + cell +
               ", and is not read";
    case ColumnFault::Kind::tab:
        return "a tab counts as one column, so that the values are not in the fields that an editor shows";
    case ColumnFault::Kind::decimal_comma:
        return "the comma in " + text + " separates fields instead of decimals";
    case ColumnFault::Kind::over_width:
        return text + " stands behind column " + std::to_string(card_width) + ", and is not read";
    case ColumnFault::Kind::too_many:
        return text + " stands behind the last field of a line in free format, and is not read";
    }
    return {};
}

const char* remedy(ColumnFault::Kind kind) {
    switch (kind) {
    case ColumnFault::Kind::straddle:
    case ColumnFault::Kind::several:
        return "put each value into its own columns";
    case ColumnFault::Kind::tab:
        return "replace tabs by blanks";
    case ColumnFault::Kind::decimal_comma:
        return "write a decimal point";
    case ColumnFault::Kind::over_width:
    case ColumnFault::Kind::too_many:
        return "continue on the next line";
    }
    return "";
}

constexpr const char* title = "each number in its own columns";

/// Lines of one block that are of a kind.
struct Lines {
    std::string where;
    std::optional<InterfaceId> interface_id;
    BlockIndex block = 0;
    std::vector<Fault> faults;
    std::span<const uint32_t> ends;
    std::vector<uint32_t> read;  ///< cells that the layout reads; empty for a list
    bool order_is_enough = true; ///< of a list
};

/// What each line should be; empty when that is not clear for one of them.
std::vector<std::vector<std::string>> fitted(const Deck& deck, const Lines& lines) {
    std::vector<std::vector<std::string>> all;
    for (const Fault& fault : lines.faults) {
        std::vector<std::string> one = fitted_line(deck.text(fault.line), lines.ends, card_width, lines.read);
        const bool moved = fault.what.kind != ColumnFault::Kind::tab;
        if (one.empty() || (moved && !lines.order_is_enough)) return {};
        all.push_back(std::move(one));
    }
    return all;
}

/// The list of a group or surface: every line behind the title.
Lines lines_of_list(const RuleContext& context, std::string where, BlockIndex index, bool order_is_enough) {
    Lines found{std::move(where), std::nullopt, index, {}, columns_of_ten, {}, order_is_enough};
    const Block& block = context.deck.blocks()[index];
    if (context.deck.scope(block.scope).layout < first_layout_of_tens) return found;
    DataLines lines(context.deck, block);
    Span line;
    lines.next(line);
    while (lines.next(line))
        if (const auto what = column_fault(lines.text(line), columns_of_ten, card_width))
            found.faults.push_back({*what, line});
    return found;
}

/// The cells of a card that hold something in a layout.
std::vector<uint32_t> cells_read(const Card& card, std::span<const uint32_t> ends) {
    std::vector<uint32_t> cells;
    for (std::size_t i = 0; i < card.cells.size(); ++i)
        if (card.cells[i].state != CellState::absent)
            for (uint32_t cell = 0; cell < ends.size(); ++cell)
                if (card.schema->fields[i].column == (cell == 0 ? 1 : ends[cell - 1] + 1))
                    cells.push_back(cell);
    std::sort(cells.begin(), cells.end());
    return cells;
}

/// Whether the data of a surface are whole numbers in columns of ten.
bool is_list(std::string_view type) {
    for (const std::string_view start :
         {"SEG", "PART", "SUBSET", "MAT", "PROP", "GR", "SURF", "DSURF", "SUBMODEL"})
        if (type.substr(0, start.size()) == start) return true;
    return false;
}

/// Everything that has a fault, in a fixed order.
std::vector<Lines> faulty_lines(const RuleContext& context) {
    std::vector<Lines> all;
    const auto add = [&](Lines lines) {
        if (!lines.faults.empty()) all.push_back(std::move(lines));
    };
    for (const Drawbead& bead : context.model.drawbeads()) {
        const CardLines& cards = cards_of(context, bead);
        if (!cards.complete()) continue;
        for (std::size_t i = 0; i < cards.fault.size(); ++i) {
            if (!cards.fault[i]) continue;
            const std::span<const uint32_t> ends = i == 0 ? std::span<const uint32_t>(columns_of_ten)
                                                          : std::span<const uint32_t>(columns_of_twenty);
            std::vector<uint32_t> read = cells_read(bead.cards[i], ends);
            const bool any = !read.empty();
            if (!any) read.push_back(0);
            add({"card " + std::to_string(i + 1) + " of " + bead_name(bead),
                 bead.id,
                 bead.block,
                 {{*cards.fault[i], cards.lines[i + 1]}},
                 ends,
                 std::move(read),
                 any});
        }
    }
    for (const NodeGroup& group : context.model.groups())
        add(lines_of_list(context, "node group " + std::to_string(group.id), group.block,
                          group.type != "SET"));
    for (const Surface& surface : context.model.surfaces())
        if (is_list(surface.type))
            add(lines_of_list(context, "surface " + std::to_string(surface.id), surface.block,
                              surface.type != "SEG"));
    return all;
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const Lines& lines : faulty_lines(context)) {
        Draft draft;
        draft.interface_id = lines.interface_id;
        draft.discriminator = lines.where;
        std::vector<Span> places;
        for (const Fault& fault : lines.faults)
            places.push_back(fault.place());
        set_places(draft, places);
        draft.message = lines.where + ": " + explain(context, lines.faults.front());
        if (lines.faults.size() > 1)
            draft.message += " (first of " + counted(lines.faults.size(), "line") + ")";
        draft.help = remedy(lines.faults.front().what.kind);
        if (!fitted(context.deck, lines).empty()) draft.fixes.push_back({title, FixAvailability::safe});
        sink.add(std::move(draft));
    }
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    for (const Lines& lines : faulty_lines(context)) {
        if (lines.where != draft.discriminator) continue;
        const std::vector<std::vector<std::string>> meant = fitted(context.deck, lines);
        if (meant.empty()) return planner.decline("it is not clear which number belongs where");
        const std::string line_end = block_end(context.deck, lines.block).line_end;
        for (std::size_t i = 0; i < meant.size(); ++i) {
            std::string text;
            for (const std::string& one : meant[i])
                text += (text.empty() ? "" : line_end) + one;
            planner.cells().replace(lines.faults[i].line, std::move(text));
        }
        Fix fix{title, FixAvailability::safe, {}};
        fix.uncovers = hidden_by_cards(); // what the numbers bring is the author's
        for (const Drawbead& bead : context.model.drawbeads())
            fix.changes.push_back({bead.id, 0, 0});
        return fix;
    }
    return planner.decline("the lines are not known");
}

} // namespace

extern const Rule SYN004{
    {.code = "SYN004",
     .name = "field-straddles-columns",
     .summary =
         "a number crosses the border of two fields, shares one with another, or is not read for its place",
     .severity = Severity::error,
     .fix = FixAvailability::sometimes_safe},
    Needs::none,
    check,
    Needs::none,
    fix};

} // namespace drawbead
