#include "rules/support.h"
#include "rules/text.h"

#include <cmath>

namespace drawbead {

namespace {

void report(const RuleContext& context, const Drawbead& bead, const Cell& cell, const char* name,
            double value, FindingSink& sink) {
    if (!cell.given() || !(value < 0)) return;
    Draft draft = draft_at(context, bead, cell);
    draft.discriminator = name;
    const UnitSystem& units = context.deck.work_units();
    draft.message = std::string(name) + " of " + bead_name(bead) + " is " +
                    quantity(value, units, force_per_length_dimension) +
                    ": it pulls the blank towards the bead instead of pressing it away";
    if (const std::string force = force_over_line(context, bead, std::abs(value)); !force.empty())
        draft.notes.push_back("the pull is up to " + force);
    measure_force(context, bead, "normal force", value, draft);
    draft.help = "give the normal force per length as a positive number";
    draft.fixes.push_back({positive_title, FixAvailability::unsafe});
    sink.add(std::move(draft));
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!cards_usable(context, bead)) continue;
        report(context, bead, cells_of(bead).fn, "Fn", bead.fn_first, sink);
        // Without an Fn there is no normal force along the bead, of which PAR006 speaks.
        if (bead.fn_first != 0) report(context, bead, cells_of(bead).fn_last, "Fn_last", bead.fn_last, sink);
    }
}

constexpr auto fix = write_positive;

} // namespace

extern const Rule PAR002{{.code = "PAR002",
                          .name = "negative-normal-force",
                          .summary = "Fn is negative at an end of the bead",
                          .severity = Severity::error,
                          .fix = FixAvailability::unsafe},
                         Needs::coordinates,
                         check,
                         Needs::none,
                         fix};

} // namespace drawbead
