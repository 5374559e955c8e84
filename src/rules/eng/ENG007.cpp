#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/stb/viscous.h"
#include "rules/support.h"
#include "rules/text.h"

#include <cmath>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const auto bead = viscous_bead(context, *a);
        if (!bead) continue;
        const UnitSystem& units = context.deck.work_units();
        const bool in_mm = std::abs(units.length / 1e-3 - 1) < 1e-9;
        const double press =
            context.limits.STB005_speed_m_per_s * units.time; // its number in m and the deck's unit of time
        const double here = bead->restraint(press / units.length),
                     there = bead->restraint(in_mm ? press : press * 1000), difference = there - here;
        Draft draft = draft_at(context, *a->bead, cells_of(*a->bead).iform);
        draft.message =
            "viscous form of " + bead_name(*a->bead) +
            ": by the manual it is limited by Ft; the solver limits a force by a force per length, so "
            "that the unit of length decides: at " +
            number(context.limits.STB005_speed_m_per_s) + " m/s it holds with " +
            quantity(here, units, force_dimension) + ", in a deck in " + (in_mm ? "m" : "mm") + " with " +
            quantity(there, units, force_dimension) + ": " + ft_cost_text(context, *a, difference);
        measure_cost(context, *a, 0, difference, draft);
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule ENG007{{.code = "ENG007",
                          .name = "viscous-form-depends-on-units",
                          .summary = "the viscous form compares a force with a force per length",
                          .severity = Severity::info},
                         needs_sides | needs_first_cycle | Needs::element_thickness,
                         check};

} // namespace drawbead
