#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

constexpr int first_layout_with_depth = 130;

double largest(double first, double last) {
    return std::max(std::abs(first), std::abs(last));
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!cards_usable(context, bead) || bead.depth > 0) continue;
        const DrawbeadCells cells = cells_of(bead);
        if (!readable(cells.depth)) continue;
        const double normal = bead.fn_first == 0 ? 0 : largest(bead.fn_first, bead.fn_last);
        const double restraint = largest(bead.ft_first, bead.ft_last);
        if (normal == 0 && restraint == 0) continue; // a dead interface, not at any distance

        Draft draft = draft_at(context, bead, cells.depth);
        const UnitSystem& units = context.deck.work_units();
        const Scope& scope = scope_of(context.deck, bead);
        const bool no_field = scope.layout < first_layout_with_depth;
        if (no_field) {
            draft.severity = Severity::warning;
            if (bead.cards[1].present) draft.primary = bead.cards[1].line;
            draft.message = "version " + std::to_string(scope.version) + " has no DEPTH: ";
        } else {
            draft.message =
                "DEPTH of " + bead_name(bead) + " is " + quantity(bead.depth, units, length_dimension) + ": ";
        }
        const char* forces = normal != 0 && restraint != 0 ? "Fn and Ft" : normal != 0 ? "Fn" : "Ft";
        draft.message += "the full " + std::string(forces) + (no_field ? " of " + bead_name(bead) : "") +
                         " act" + (normal != 0 && restraint != 0 ? "" : "s") + " at any distance";
        std::string cost;
        if (normal != 0) cost = "normal force up to " + force_over_line(context, bead, normal);
        if (restraint != 0)
            cost +=
                (cost.empty() ? "" : ", ") + ("restraint up to " + force_over_line(context, bead, restraint));
        if (line_length(context.model, bead) != 0) draft.notes.push_back(cost + ", 100 % of the bead");
        if (normal != 0) {
            measure_force(context, bead, "normal force", normal, draft);
            draft.notes.push_back(
                "the manual says that only the slope is replaced; the Starter warns of that (1043)");
        }
        if (restraint != 0) measure_force(context, bead, "restraint", restraint, draft);
        draft.help = no_field ? "raise the version on /BEGIN to 130 or later and give a DEPTH"
                              : "give the depth of the bead, the distance at which the forces begin";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule PAR003{{.code = "PAR003",
                          .name = "depth-not-positive",
                          .summary = "DEPTH is 0 or negative, so that the forces act at any distance",
                          .severity = Severity::error,
                          .starter_message = 1043},
                         Needs::coordinates,
                         check};

} // namespace drawbead
