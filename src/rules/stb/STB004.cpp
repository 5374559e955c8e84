#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/stb/blank.h"
#include "rules/stb/time_step.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    const double left = context.limits.STB004_step_share;
    const UnitSystem& units = context.deck.work_units();
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const auto risk = time_step_risk(context, *a);
        if (!risk || risk->ratio() >= left) continue;
        const bool ramp = risk->normal >= risk->stick;
        Draft draft = draft_at(context, *a->bead, ramp ? cells_of(*a->bead).depth : cells_of(*a->bead).ft);
        draft.entities.nodes.add(risk->node);
        const double fn = ramp ? a->fn_total : 0, ft = ramp ? 0 : a->ft_total;
        draft.message = bead_name(*a->bead) + " makes node " + std::to_string(risk->node) +
                        " of the sheet stiffer by " +
                        quantity(risk->contact(), units, force_per_length_dimension) + " (" +
                        (ramp ? "ramp of Fn" : "sticking restraint") +
                        "), which the solver's time step does not know: stable steps are " +
                        number(100 * risk->ratio(), 3) + " % of the elements'; at stake: " +
                        (ramp ? fn_force_text(context, *a, fn) : ft_force_text(context, *a, ft));
        const std::string time = unit_name(units, time_dimension);
        draft.measured.push_back({"step of the elements", risk->element_step, time});
        draft.measured.push_back({"step with the bead", risk->ratio() * risk->element_step, time});
        draft.measured.push_back({"share of the step", 100 * risk->ratio(), "%"});
        measure_cost(context, *a, fn, ft, draft);
        draft.notes.emplace_back("masses are those of the elements, without added mass");
        draft.help = "a scale factor of " + number(left * risk->ratio(), 2) + " in /DT keeps it stable" +
                     (ramp ? ", or a larger DEPTH" : ", or fewer bead nodes per element");
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule STB004{
    {.code = "STB004",
     .name = "time-step-at-risk",
     .summary = "the stiffness of the bead against the masses under it asks for a smaller step",
     .severity = Severity::warning},
    needs_sides | needs_first_cycle | Needs::element_thickness,
    check};

} // namespace drawbead
