#include "rules/support.h"
#include "rules/text.h"

#include <cmath>

namespace drawbead {

namespace {

void report(const RuleContext& context, const Drawbead& bead, const char* name, double first,
            const Cell& cell, const char* varying, FindingSink& sink) {
    if (!readable(cell)) return;
    Draft draft = draft_at(context, bead, cell);
    draft.discriminator = name;
    const UnitSystem& units = context.deck.work_units();
    draft.message = std::string(name) + "_last of " + bead_name(bead) + " is 0, beside an " + varying +
                    "_last that is not: " + name + " stays " +
                    quantity(first, units, force_per_length_dimension) +
                    " along the whole bead and does not taper to 0";
    if (const std::string force = force_over_line(context, bead, std::abs(first) / 2); !force.empty()) {
        draft.notes.push_back("a taper to 0 would have been " + force + " less, 50 % of the bead");
        measure_force(context, bead, "difference from a taper", first / 2, draft);
    }
    const auto as_written = [&](double value) { return number(in_units_of_block(context, bead, value)); };
    draft.help = "for a taper write a small number, for instance " + as_written(first * 1e-6) +
                 "; for a constant " + name + " write " + as_written(first) + " at both ends";
    sink.add(std::move(draft));
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!cards_usable(context, bead)) continue;
        const DrawbeadCells cells = cells_of(bead);
        if (bead.fn_first != 0 && bead.fn_last == 0 && bead.ft_last != 0)
            report(context, bead, "Fn", bead.fn_first, cells.fn_last, "Ft", sink);
        if (bead.ft_first != 0 && bead.ft_last == 0 && bead.fn_last != 0)
            report(context, bead, "Ft", bead.ft_first, cells.ft_last, "Fn", sink);
    }
}

} // namespace

extern const Rule PAR005{{.code = "PAR005",
                          .name = "last-zero-is-constant",
                          .summary = "a _last of 0 beside one that varies means constant, not a taper to 0",
                          .severity = Severity::warning},
                         Needs::coordinates,
                         check};

} // namespace drawbead
