#include "rules/support.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    if (!context.model.admesh() || context.model.admesh()->idt != 1) return;
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (bead.iform != 1 || !cards_usable(context, bead)) continue;
        Draft draft = draft_at(context, bead, cells_of(bead).iform);
        draft.message =
            "Iform 1 of " + bead_name(bead) +
            " together with Idt 1 in /ADMESH/GLOBAL: the Starter stops with error 703, and the bead "
            "has none of its force, 100 % of its total";
        draft.related.push_back(context.deck.blocks()[context.model.admesh()->block].header);
        draft.help = "set Iform to 2, or Idt to 0";
        draft.fixes.push_back({iform_2_title, FixAvailability::unsafe});
        sink.add(std::move(draft));
    }
}

constexpr auto fix = write_iform_2;

} // namespace

extern const Rule STB006{{.code = "STB006",
                          .name = "viscous-with-admesh",
                          .summary = "the viscous form together with Idt = 1 of adaptive meshing",
                          .severity = Severity::error,
                          .fix = FixAvailability::unsafe,
                          .starter_message = 703},
                         Needs::none,
                         check,
                         Needs::none,
                         fix};

} // namespace drawbead
