#include "rules/lin/bead_report.h"
#include "rules/stb/blank.h"
#include "rules/support.h"
#include "rules/text.h"

#include <cmath>

namespace drawbead {

namespace {

/// The smallest DEPTH of four digits, not below `least`, that the Starter does not reset.
double depth_without_reset(double fn_first, double smallest_k) {
    const double least = fn_first / smallest_k;
    const double unit_of_last_digit = std::pow(10.0, std::floor(std::log10(least)) - 3);
    double depth = std::ceil(least / unit_of_last_digit) * unit_of_last_digit;
    while (choose_slope(fn_first, depth, smallest_k).kind == Slope::reset)
        depth += unit_of_last_digit;
    return depth;
}

void check(const RuleContext& context, FindingSink& sink) {
    const UnitSystem& units = context.deck.work_units();
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const auto ramp = ramp_of(context, *a);
        if (!ramp || ramp->slope.kind != Slope::reset) continue;
        const double smallest = ramp->smallest_k;
        const double reached = ramp->end_force(*a), jump = a->fn_total - reached;
        const double needed = depth_without_reset(a->bead->fn_first, smallest);
        Draft draft = draft_at(context, *a->bead, cells_of(*a->bead).depth);
        draft.message = "Fn/DEPTH of " + bead_name(*a->bead) + " is " +
                        quantity(ramp->slope.ramp, units, pressure_dimension) +
                        ", over the smallest stiffness of surface " + std::to_string(a->surface->id) + ", " +
                        quantity(smallest, units, force_per_length_dimension) +
                        ": the ramp of Fn gets the stiffness of each segment, and at DEPTH the force jumps "
                        "from " +
                        quantity(reached, units, force_dimension) + " to " +
                        quantity(a->fn_total, units, force_dimension) + ": " +
                        fn_cost_text(context, *a, jump);
        if (a->ft_total != 0)
            draft.notes.push_back("on such a ramp Ft acts in full from the first touch, " +
                                  quantity(a->ft_total, units, force_dimension));
        const std::string length = unit_name(units, length_dimension);
        draft.measured.push_back({"Fn/DEPTH", ramp->slope.ramp, unit_name(units, pressure_dimension)});
        draft.measured.push_back(
            {"smallest stiffness", smallest, unit_name(units, force_per_length_dimension)});
        draft.measured.push_back({"DEPTH without reset", needed, length});
        draft.measured.push_back({"jump", jump, unit_name(units, force_dimension)});
        draft.help = "a DEPTH of at least " + quantity(needed, units, length_dimension) + " keeps the ramp";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule STB001{
    {.code = "STB001",
     .name = "stiffness-reset",
     .summary = "Fn/DEPTH is over the stiffness of the sheet, so that the ramp is replaced",
     .severity = Severity::warning,
     .starter_message = 1040},
    needs_first_cycle,
    check};

} // namespace drawbead
