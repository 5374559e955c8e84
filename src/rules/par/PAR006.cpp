#include "rules/support.h"
#include "rules/text.h"

#include <cmath>

namespace drawbead {

namespace {

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
        draft.help =
            "give a small Fn at the first node, for instance " + number(bead.fn_last * 1e-6) +
            ", or list the nodes from the other end; the slope of the ramp is Fn/DEPTH of the first node";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule PAR006{
    {.code = "PAR006",
     .name = "first-normal-zero",
     .summary = "Fn is 0 at the first node, which switches the normal force off along the bead",
     .severity = Severity::error},
    Needs::coordinates,
    check};

} // namespace drawbead
