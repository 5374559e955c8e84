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
                    quantity(value, units, force_per_length_dimension) + ": ";
    draft.message += bead.iform == 1
                         ? "the viscous form then pushes the blank along instead of holding it"
                         : "the incremental form takes it as +" + number(-value) + ", even at rest";
    if (const std::string force = force_over_line(context, bead, std::abs(value)); !force.empty())
        draft.notes.push_back("the restraint is up to " + force);
    measure_force(context, bead, "restraint", std::abs(value), draft);
    draft.help = "give the restraint as a positive force per length";
    draft.fixes.push_back({positive_title, FixAvailability::unsafe});
    sink.add(std::move(draft));
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!cards_usable(context, bead)) continue;
        report(context, bead, cells_of(bead).ft, "Ft", bead.ft_first, sink);
        report(context, bead, cells_of(bead).ft_last, "Ft_last", bead.ft_last, sink);
    }
}

constexpr auto fix = write_positive;

} // namespace

extern const Rule PAR001{{.code = "PAR001",
                          .name = "negative-restraint",
                          .summary = "Ft is negative at an end of the bead",
                          .severity = Severity::error,
                          .fix = FixAvailability::unsafe},
                         Needs::coordinates,
                         check,
                         Needs::none,
                         fix};

} // namespace drawbead
