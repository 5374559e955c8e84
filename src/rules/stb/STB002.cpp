#include "rules/lin/bead_report.h"
#include "rules/stb/blank.h"
#include "rules/support.h"
#include "rules/text.h"

#include <cmath>

namespace drawbead {

namespace {

struct LengthUnit {
    double metres;
    const char* name;
};
constexpr LengthUnit millimetre{1e-3, "mm"}, metre{1, "m"};

/// (Fn/DEPTH) / k is 1/length: its number in a deck of this unit.
double ratio_in(const LengthUnit& unit, double ratio, const UnitSystem& units) {
    return ratio * unit.metres / units.length;
}

/// What the normal force jumps by at DEPTH in a deck of this unit, in this deck's unit of force.
double jump_in(const LengthUnit& unit, const BeadRamp& ramp, const BeadAnalysis& a, const UnitSystem& units) {
    double reached = 0; // k DEPTH L in the numbers of that deck is a force times a length
    for (std::size_t i = 0; i < ramp.node.size(); ++i)
        reached += ramp.node[i].k * a.bead->depth * a.line.tributary[i] * units.length / unit.metres;
    return a.fn_total - reached;
}

void check(const RuleContext& context, FindingSink& sink) {
    const UnitSystem& units = context.deck.work_units();
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const auto ramp = ramp_of(context, *a);
        if (!ramp || (ramp->slope.kind != Slope::reset && ramp->slope.kind != Slope::ramp)) continue;
        const double smallest = ramp->smallest_k;
        if (!(smallest > 0) || std::isinf(smallest)) continue;
        const double ratio = ramp->slope.ramp / smallest;
        const bool here = ramp->slope.kind == Slope::reset;
        const bool in_mm = ratio_in(millimetre, ratio, units) > 1, in_m = ratio_in(metre, ratio, units) > 1;
        if (in_mm == here && in_m == here) continue;
        const LengthUnit& other = in_mm != here ? millimetre : metre;
        Draft draft = draft_at(context, *a->bead, cells_of(*a->bead).depth);
        draft.message =
            here ? "the stiffness reset of " + bead_name(*a->bead) + " comes from the unit of length: "
                 : "in " + std::string(other.name) + " the ramp of " + bead_name(*a->bead) +
                       " would be reset: ";
        draft.message += "Fn/DEPTH over the stiffness of the sheet is " + number(ratio) +
                         " in this deck and " + number(ratio_in(other, ratio, units)) + " in one in " +
                         other.name + "; ";
        const double jump = here ? a->fn_total - ramp->end_force(*a) : jump_in(other, *ramp, *a, units);
        draft.message += (here ? "without it Fn would not jump at DEPTH by " : "Fn would jump at DEPTH by ") +
                         fn_cost_text(context, *a, jump);
        if (!here) draft.severity = Severity::info;
        draft.measured.push_back({"ratio here", ratio, ""});
        draft.measured.push_back({std::string("ratio in ") + other.name, ratio_in(other, ratio, units), ""});
        draft.measured.push_back({"jump", jump, unit_name(units, force_dimension)});
        draft.help = here ? "choose DEPTH so that the ramp is kept, or run the deck in mm"
                          : "do not compare this bead with a run of the same model in other units";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule STB002{{.code = "STB002",
                          .name = "reset-depends-on-units",
                          .summary = "the stiffness reset would be decided otherwise in a deck in mm or in m",
                          .severity = Severity::warning},
                         needs_first_cycle,
                         check};

} // namespace drawbead
