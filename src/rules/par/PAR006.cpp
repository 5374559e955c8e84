#include "rules/lin/list_repair.h"
#include "rules/support.h"
#include "rules/text.h"

#include <cmath>

namespace drawbead {

namespace {

constexpr const char* title = "the list and its limits from the other end";

/// The list can be turned round.
bool has_order(const RuleContext& context, const Drawbead& bead) {
    return bead.group && context.model.groups()[*bead.group].order == NodeGroup::Order::unsorted &&
           context.model.groups()[*bead.group].nodes.size() > 1;
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!cards_usable(context, bead)) continue;
        const DrawbeadCells cells = cells_of(bead);
        if (bead.fn_first != 0 || bead.fn_last == 0 || !readable(cells.fn)) continue;
        Draft draft = draft_at(context, bead, cells.fn);
        if (cells.fn_last.given()) draft.related.push_back(cells.fn_last.place);
        const UnitSystem& units = context.deck.work_units();
        draft.message = "Fn of " + bead_name(bead) + " is 0 at the first node and Fn_last is " +
                        quantity(bead.fn_last, units, force_per_length_dimension) +
                        ": there is no normal force along the whole bead";
        if (const std::string force = force_over_line(context, bead, std::abs(bead.fn_last) / 2);
            !force.empty())
            draft.notes.push_back("the linear normal force that the card describes is " + force +
                                  "; all of it is lost");
        measure_force(context, bead, "normal force lost", bead.fn_last / 2, draft);
        if (has_order(context, bead)) draft.fixes.push_back({title, FixAvailability::unsafe});
        draft.help =
            "give a small Fn at the first node, for instance " +
            number(in_units_of_block(context, bead, bead.fn_last * 1e-6)) +
            ", or list the nodes from the other end; the slope of the ramp is Fn/DEPTH of the first node";
        sink.add(std::move(draft));
    }
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const BeadAnalysis* a = analysed_bead(context, draft);
    if (!a || !has_order(context, *a->bead)) return planner.decline("the list has no order to turn round");
    const Drawbead& bead = *a->bead;
    const Block& block = context.deck.blocks()[bead.block];
    const DrawbeadCells cells = cells_of(bead);
    Fix fix{title, FixAvailability::unsafe, {}};
    fix.uncovers = {"PAR002"}; // a negative limit does nothing as long as there is no normal force
    std::vector<uint32_t> order;
    for (auto i = static_cast<uint32_t>(a->group->nodes.size()); i-- > 0;)
        order.push_back(i);
    if (!set_list(context, *a, order, planner, fix)) return std::nullopt;
    const auto text = [&](const Cell& cell, double value) {
        return cell.state == CellState::ok
                   ? std::string(cell.text)
                   : cell_text(context.deck, block, force_per_length_dimension, value);
    };
    const auto small = [&](double other) { // 0 would mean constant
        return cell_text(context.deck, block, force_per_length_dimension, never_zero(0, other));
    };
    CellEditor& editor = planner.cells();
    editor.set_cell(bead.cards[1], "Fn", text(cells.fn_last, bead.fn_last));
    editor.set_cell(bead.cards[2], "Fn_last", small(bead.fn_last));
    if (!bead.ft_varies()) return fix;
    editor.set_cell(bead.cards[1], "Ft", text(cells.ft_last, bead.ft_last));
    editor.set_cell(bead.cards[2], "Ft_last",
                    bead.ft_first == 0 ? small(bead.ft_last) : text(cells.ft, bead.ft_first));
    return fix;
}

} // namespace

extern const Rule PAR006{
    {.code = "PAR006",
     .name = "first-normal-zero",
     .summary = "Fn is 0 at the first node, which switches the normal force off along the bead",
     .severity = Severity::error,
     .fix = FixAvailability::unsafe},
    Needs::coordinates,
    check,
    needs_lines | needs_list_users,
    fix};

} // namespace drawbead
