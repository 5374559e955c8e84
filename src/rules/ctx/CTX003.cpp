#include "rules/analysis.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    const RunFacts& run = context.analysis.run;
    std::string option;
    std::optional<Span> place;
    if (run.engine && !run.engine->mass_scaling.empty()) option = run.engine->mass_scaling;
    for (const Block& block : context.deck.blocks())
        if (block.keyword == "AMS" && option.empty()) {
            option = "/AMS";
            place = block.header;
        }
    if (option.empty()) return;
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        if (a->ft_total == 0) continue;
        const bool viscous = a->bead->iform == 1;
        Draft draft = draft_at_header(context, *a->bead);
        if (place) draft.related.push_back(*place);
        draft.message =
            option + " adds mass; the restraint of " + bead_name(*a->bead) +
            (viscous ? " is v·√(k·m) up to its limit, so that it grows with the added mass"
                     : " sticks with a damper of √(k·m), which grows with the added mass; its limit "
                       "does not change") +
            ": up to " + ft_force_text(context, *a, a->ft_total);
        measure_cost(context, *a, 0, a->ft_total, draft);
        draft.help = viscous ? "set Iform to 2, whose limit does not depend on the mass"
                             : "compare the added mass in the listing with that of the sheet";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule CTX003{{.code = "CTX003",
                          .name = "mass-scaling-with-beads",
                          .summary = "mass scaling changes the masses that the restraint is made of",
                          .severity = Severity::info},
                         needs_lines | analysis_run,
                         check};

} // namespace drawbead
