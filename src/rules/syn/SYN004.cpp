#include "rules/support.h"
#include "rules/text.h"

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
        return "continue on the next line";
    }
    return "";
}

void report(const RuleContext& context, const std::string& where, std::optional<InterfaceId> interface_id,
            const std::vector<Fault>& faults, FindingSink& sink) {
    if (faults.empty()) return;
    Draft draft;
    draft.interface_id = interface_id;
    draft.discriminator = where;
    std::vector<Span> places;
    for (const Fault& fault : faults)
        places.push_back(fault.place());
    set_places(draft, places);
    draft.message = where + ": " + explain(context, faults.front());
    if (faults.size() > 1) draft.message += " (first of " + counted(faults.size(), "line") + ")";
    draft.help = remedy(faults.front().what.kind);
    sink.add(std::move(draft));
}

/// The list of a group or surface: every line behind the title.
void check_list(const RuleContext& context, const std::string& where, const Block& block, FindingSink& sink) {
    if (context.deck.scope(block.scope).layout < first_layout_of_tens) return;
    std::vector<Fault> faults;
    DataLines lines(context.deck, block);
    Span line;
    lines.next(line);
    while (lines.next(line))
        if (const auto what = column_fault(lines.text(line), columns_of_ten, card_width))
            faults.push_back({*what, line});
    report(context, where, std::nullopt, faults, sink);
}

/// Whether the data of a surface are whole numbers in columns of ten.
bool is_list(std::string_view type) {
    for (const std::string_view start :
         {"SEG", "PART", "SUBSET", "MAT", "PROP", "GR", "SURF", "DSURF", "SUBMODEL"})
        if (type.substr(0, start.size()) == start) return true;
    return false;
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        const CardLines cards = card_lines(context.deck, bead);
        if (!cards.complete()) continue;
        for (std::size_t i = 0; i < cards.fault.size(); ++i)
            if (cards.fault[i])
                report(context, "card " + std::to_string(i + 1) + " of " + bead_name(bead), bead.id,
                       {{*cards.fault[i], cards.lines[i + 1]}}, sink);
    }
    const auto blocks = context.deck.blocks();
    for (const NodeGroup& group : context.model.groups())
        check_list(context, "node group " + std::to_string(group.id), blocks[group.block], sink);
    for (const Surface& surface : context.model.surfaces())
        if (is_list(surface.type))
            check_list(context, "surface " + std::to_string(surface.id), blocks[surface.block], sink);
}

} // namespace

extern const Rule SYN004{
    {.code = "SYN004",
     .name = "field-straddles-columns",
     .summary =
         "a number crosses the border of two fields, shares one with another, or is not read for its place",
     .severity = Severity::error},
    Needs::none,
    check};

} // namespace drawbead
