#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/stb/viscous.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    const UnitSystem& units = context.deck.work_units();
    const double press = context.limits.STB005_speed_m_per_s * units.time / units.length;
    const std::string speed_unit =
        unit_name(units, length_dimension) + "/" + unit_name(units, time_dimension);
    const auto speed = [&](double v) { return number(v) + " " + speed_unit; };
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const auto bead = viscous_bead(context, *a);
        if (!bead) continue;
        const double needed = bead->speed_to_limit(), reached = bead->restraint(press),
                     share = 100 * reached / bead->limit();
        Draft draft = draft_at(context, *a->bead, cells_of(*a->bead).iform);
        if (share > 100 * context.limits.STB005_info_share) draft.severity = Severity::info;
        draft.message =
            "the viscous form of " + bead_name(*a->bead) + " reaches Ft only where the sheet slides at " +
            speed(needed) + "; at " + speed(press) + ", the speed of a press, it holds with " +
            quantity(reached, units, force_dimension) + ", " + number(share, 3) + " % of its total";
        draft.notes.emplace_back("masses are those of the shells of the surface, without added mass");
        draft.measured.push_back({"speed to reach Ft", needed, speed_unit});
        draft.measured.push_back({"speed", press, speed_unit});
        draft.measured.push_back({"restraint", reached, unit_name(units, force_dimension)});
        draft.measured.push_back({"share of restraint", share, "%"});
        draft.help = "set Iform to 2, whose restraint does not depend on the speed";
        draft.fixes.push_back({iform_2_title, FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

constexpr auto fix = write_iform_2;

} // namespace

extern const Rule STB005{{.code = "STB005",
                          .name = "viscous-below-limit",
                          .summary = "the viscous form reaches Ft only at a high speed of the sheet",
                          .severity = Severity::warning,
                          .fix = FixAvailability::unsafe},
                         needs_sides | needs_first_cycle | Needs::element_thickness,
                         check,
                         Needs::none,
                         fix};

} // namespace drawbead
