#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!cards_usable(context, bead)) continue;
        const DrawbeadCells cells = cells_of(bead);
        // Without DEPTH there is no distance at which it could switch on, and Fn_last alone is another
        // defect.
        if (bead.fn_first != 0 || bead.fn_last != 0 || !(bead.depth > 0) || !readable(cells.fn)) continue;
        const double restraint = std::max(std::abs(bead.ft_first), std::abs(bead.ft_last));
        if (restraint == 0) continue;
        Draft draft = draft_at(context, bead, cells.fn);
        const UnitSystem& units = context.deck.work_units();
        draft.message = "Fn of " + bead_name(bead) +
                        " is 0: the restraint has no ramp and switches on at once where a "
                        "node comes within DEPTH + t/2 (DEPTH = " +
                        quantity(bead.depth, units, length_dimension) + ")";
        if (const std::string force = force_over_line(context, bead, restraint); !force.empty())
            draft.notes.push_back("the jump is up to " + force);
        measure_force(context, bead, "restraint", restraint, draft);
        draft.help = "give an Fn, even a small one: the restraint then grows with the penetration";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule PAR004{{.code = "PAR004",
                          .name = "restraint-without-ramp",
                          .summary = "Fn is 0 beside a restraint, which then switches on at once",
                          .severity = Severity::warning},
                         Needs::coordinates,
                         check};

} // namespace drawbead
