#include "rules/srf/surface_fix.h"

#include "fix/surface_repair.h"
#include "rules/analysis.h"
#include "rules/support.h"

namespace drawbead {

namespace {

/// What a bead says of the segments around it. Segments of solids are left out: the Starter turns them.
BeadVotes votes_of(const RuleContext& context, const BeadAnalysis& a, const NearMesh& near) {
    BeadVotes votes{a.bead->id, a.bead->block, {}};
    if (!cards_usable(context, *a.bead)) return votes;
    for (const ZoneSegment& z : a.side.zone) {
        const uint32_t segment = near.segment_index[z.segment];
        if (z.facing == Facing::unknown || a.surface->segments[segment].solid_backed) continue;
        votes.votes.push_back({segment, z.facing == Facing::away, z.start});
    }
    return votes;
}

} // namespace

std::optional<Fix> fix_surface(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    for (uint32_t s = 0; s < context.model.surfaces().size(); ++s) {
        if (context.model.surfaces()[s].id != draft.surface_id) continue;
        std::vector<BeadVotes> votes;
        for (const BeadAnalysis& a : context.analysis.beads)
            if (a.bead->surface == s)
                votes.push_back(votes_of(context, a, context.analysis.surfaces[s].near));
        std::optional<Fix> fix = repair_surface(context.model, s, votes, planner);
        // A bead on the wrong side never touches, holds nothing and is not told about what it does then.
        if (fix) fix->uncovers = {"KIN", "STB", "ENG"};
        return fix;
    }
    return planner.decline("the surface is not there");
}

bool offers_surface_fix(const Surface& surface) {
    return surface.evaluated && surface.type != "DSURF" && !has_solid_faces(surface);
}

} // namespace drawbead
