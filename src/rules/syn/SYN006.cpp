#include "rules/support.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!cards_usable(context, bead)) continue;
        const Cell& cell = cells_of(bead).iform;
        if (!cell.given() || (cell.integer >= 0 && cell.integer <= 2)) continue;
        Draft draft = draft_at(context, bead, cell);
        draft.message = "Iform of " + bead_name(bead) + " is " + std::to_string(cell.integer) +
                        ": the solver knows 1 (viscous) and 2 (incremental) only and computes no restraint";
        measure_force(context, bead, "restraint lost", bead.ft_first, draft);
        draft.notes.push_back("the solver does not check the value; the normal force is not defined either");
        draft.fixes.push_back({iform_2_title, FixAvailability::unsafe});
        draft.help = "write 2, or leave the columns blank";
        sink.add(std::move(draft));
    }
}

constexpr auto fix = write_iform_2;

} // namespace

extern const Rule SYN006{{.code = "SYN006",
                          .name = "iform-unknown",
                          .summary = "Iform is not 0, 1 or 2, so that no restraint is computed",
                          .severity = Severity::error,
                          .fix = FixAvailability::unsafe},
                         Needs::coordinates,
                         check,
                         Needs::none,
                         fix};

} // namespace drawbead
