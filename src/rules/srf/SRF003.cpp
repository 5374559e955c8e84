#include "rules/lin/bead_report.h"
#include "rules/srf/surface_fix.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

/// A bead that has all of its judged nodes on one side of the surface.
struct OneSided {
    const BeadAnalysis* bead = nullptr;
    Facing facing = Facing::unknown;
};

Facing side_of(const BeadAnalysis& a) {
    std::size_t toward = 0, away = 0;
    for (const Facing facing : a.side.node) {
        toward += facing == Facing::toward;
        away += facing == Facing::away;
    }
    return toward > 0 && away == 0   ? Facing::toward
           : away > 0 && toward == 0 ? Facing::away
                                     : Facing::unknown;
}

std::vector<int64_t> ids_of(const std::vector<OneSided>& beads, Facing facing) {
    std::vector<int64_t> ids;
    for (const OneSided& b : beads)
        if (b.facing == facing) ids.push_back(b.bead->bead->id);
    return ids;
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const Surface& surface : context.model.surfaces()) {
        std::vector<OneSided> beads;
        for (const BeadAnalysis* a : beads_with_nodes(context))
            if (a->surface == &surface) beads.push_back({a, side_of(*a)});
        const std::vector<int64_t> good = ids_of(beads, Facing::toward), bad = ids_of(beads, Facing::away);
        if (good.empty() || bad.empty()) continue;
        const auto is_bad = [](const OneSided& b) { return b.facing == Facing::away; };
        const bool pulls = std::any_of(beads.begin(), beads.end(), [&](const OneSided& b) {
            return is_bad(b) && b.bead->bead->fn_first != 0;
        });
        double force = 0, total = 0;
        for (const OneSided& b : beads)
            if (is_bad(b)) {
                const double one = pulls ? b.bead->fn_total : b.bead->ft_total;
                force += one;
                total += std::abs(one);
            }
        const OneSided& first = *std::find_if(beads.begin(), beads.end(), is_bad);
        Draft draft = draft_at(context, *first.bead->bead, cells_of(*first.bead->bead).surface);
        draft.surface_id = surface.id;
        draft.discriminator = "surface " + std::to_string(surface.id);
        draft.message = "surface " + std::to_string(surface.id) +
                        " serves beads on both of its sides: it faces bead " + listed(good) +
                        " and looks away from bead " + listed(bad) + ", whose " +
                        (pulls ? "Fn pulls the blank: +" : "full Ft acts at any distance: +") +
                        quantity(force, context.deck.work_units(), force_dimension) + ", " +
                        number(total != 0 ? 100 * force / total : 0, 3) + " % of its total";
        draft.related.push_back(context.deck.blocks()[surface.block].header);
        draft.measured.push_back({pulls ? "normal force on the wrong side" : "restraint at any distance",
                                  force, unit_name(context.deck.work_units(), force_dimension)});
        draft.help = "let bead " + listed(bad) + " use a second surface of the same elements, reversed";
        if (offers_surface_fix(surface))
            draft.fixes.push_back({"a second, reversed surface", FixAvailability::safe});
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SRF003{{.code = "SRF003",
                          .name = "surface-used-from-both-sides",
                          .summary = "beads on both sides of the sheet share one surface",
                          .severity = Severity::error,
                          .fix = FixAvailability::safe},
                         needs_sides,
                         check,
                         surface_fix_needs,
                         fix_surface};

} // namespace drawbead
