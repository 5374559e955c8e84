#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

struct Limit {
    const char* name;
    double value, other_end;
    const Cell* cell;
};

/// A taper to nothing is written with a tiny value, since a `_last` of 0 means constant (PAR005, PAR006 and
/// the split of LIN001 take 1e-6 of the other end).
bool stands_for_zero(const RuleContext& context, const Limit& limit) {
    return std::abs(limit.value) <= context.limits.PAR007_zero_ratio * std::abs(limit.other_end);
}

std::vector<Limit> limits_of(const Drawbead& b) {
    const DrawbeadCells c = cells_of(b);
    return {{"Fn", b.fn_first, b.fn_last, &c.fn},
            {"Ft", b.ft_first, b.ft_last, &c.ft},
            {"Fn_last", b.fn_last, b.fn_first, &c.fn_last},
            {"Ft_last", b.ft_last, b.ft_first, &c.ft_last}};
}

/// Median over the other beads of the deck of the larger of a limit's two ends; 0 when there are none.
double usual(const std::vector<const BeadAnalysis*>& beads, const BeadAnalysis* without, bool normal) {
    std::vector<double> values;
    for (const BeadAnalysis* a : beads) {
        const Drawbead& b = *a->bead;
        const double v = normal ? std::max(std::abs(b.fn_first), std::abs(b.fn_last))
                                : std::max(std::abs(b.ft_first), std::abs(b.ft_last));
        if (a != without && v != 0) values.push_back(v);
    }
    if (values.empty()) return 0;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

/// "a thousand times" or "a million times", when the ratio is that of a wrong unit.
const char* unit_slip(double ratio, double most) {
    const double decades = std::abs(std::log10(ratio));
    if (std::abs(decades - 3) < most) return "about a thousand times";
    if (std::abs(decades - 6) < most) return "about a million times";
    return nullptr;
}

void check(const RuleContext& context, FindingSink& sink) {
    const double smallest = context.limits.PAR007_least_n_per_mm,
                 largest = context.limits.PAR007_most_n_per_mm;
    const UnitSystem& units = context.deck.work_units();
    // Force per length in N/m is mass / time^2; per mm it is a thousandth.
    const double to_n_per_mm = units.mass / (units.time * units.time) / 1000;
    const std::vector<const BeadAnalysis*> beads = beads_with_nodes(context);
    for (const BeadAnalysis* a : beads)
        for (const Limit& limit : limits_of(*a->bead)) {
            const double value = std::abs(limit.value);
            if (value == 0 || stands_for_zero(context, limit)) continue;
            const double si = value * to_n_per_mm;
            const bool normal = limit.name[1] == 'n';
            const double others = usual(beads, a, normal);
            const char* slip =
                others > 0 ? unit_slip(value / others, context.limits.PAR007_slip_decades) : nullptr;
            const bool outside = si < smallest || si > largest;
            if (!outside && slip == nullptr) continue;
            Draft draft = draft_at(context, *a->bead, *limit.cell);
            draft.discriminator = limit.name;
            draft.message =
                std::string(limit.name) + " of " + bead_name(*a->bead) + " is " + number(si) + " N/mm";
            if (slip != nullptr)
                draft.message += std::string(", ") + slip + (value > others ? " more" : " less") +
                                 " than that of the other beads (" + number(others * to_n_per_mm) + " N/mm)";
            else
                draft.message += ", outside of what drawbeads reach (" + number(smallest) + " to " +
                                 number(largest) + " N/mm)";
            const double total = normal ? a->fn_total : a->ft_total;
            draft.message += "; over the bead it makes " + quantity(total, units, force_dimension) +
                             ", 100 % of its total";
            draft.measured.push_back({limit.name, si, "N/mm"});
            draft.measured.push_back({"total", total, unit_name(units, force_dimension)});
            draft.help = "look at the units of the deck and of this value (force per length)";
            sink.add(std::move(draft));
        }
}

} // namespace

extern const Rule PAR007{{.code = "PAR007",
                          .name = "implausible-force",
                          .summary = "Fn or Ft is far from what drawbeads reach, or from the other beads",
                          .severity = Severity::warning},
                         needs_lines,
                         check};

} // namespace drawbead
