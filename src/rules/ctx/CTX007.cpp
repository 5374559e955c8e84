#include "rules/analysis.h"
#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drawbead {

namespace {

constexpr std::array<double Vec3::*, 3> axes{&Vec3::x, &Vec3::y, &Vec3::z};

/// A plane of nodes of the blank that are held in its normal and in the turns out of it.
struct Plane {
    const MotionCondition* held = nullptr;
    std::size_t axis = 0;
    double at = 0;
};

/// The axis whose plane a condition mirrors at; empty when it is no mirror.
std::optional<std::size_t> mirror_axis(const MotionCondition& c) {
    if (c.kind != MotionCondition::Kind::fixed) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k)
        if (c.translation[k] && !c.translation[(k + 1) % 3] && !c.translation[(k + 2) % 3] &&
            !c.rotation[k] && c.rotation[(k + 1) % 3] && c.rotation[(k + 2) % 3])
            return k;
    return std::nullopt;
}

std::vector<Plane> planes_of(const RuleContext& context, const NearMesh& mesh) {
    const DeckMotion& motion = context.model.motion();
    std::vector<Plane> planes;
    for (const MotionCondition& c : motion.conditions) {
        const auto axis = mirror_axis(c);
        if (!axis) continue;
        const auto number = static_cast<uint32_t>(&c - motion.conditions.data());
        double low = std::numeric_limits<double>::infinity(), high = -low;
        std::size_t count = 0;
        for (std::size_t i = 0; i < mesh.x.size(); ++i) {
            const std::vector<uint32_t>& acting = motion.classes[motion.of_node[mesh.node_row[i]]];
            if (std::find(acting.begin(), acting.end(), number) == acting.end()) continue;
            low = std::min(low, mesh.x[i].*axes[*axis]);
            high = std::max(high, mesh.x[i].*axes[*axis]);
            ++count;
        }
        const double size = 1e-6 * (1 + std::max(std::abs(low), std::abs(high)));
        if (count >= 2 && high - low <= size) planes.push_back({&c, *axis, low});
    }
    return planes;
}

void check(const RuleContext& context, FindingSink& sink) {
    if (context.model.motion().of_node.empty()) return;
    const UnitSystem& units = context.deck.work_units();
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        if (a->x.size() < 2 || a->surface == nullptr || !a->order_is_the_authors) continue;
        const std::vector<Plane> planes =
            planes_of(context, context.analysis.surfaces[*a->bead->surface].near);
        for (const bool first : {true, false}) {
            const std::size_t end = first ? 0 : a->x.size() - 1, next = first ? 1 : end - 1;
            const double step = distance(a->x[end], a->x[next]);
            const auto on = std::find_if(planes.begin(), planes.end(), [&](const Plane& p) {
                const double height = a->x[end].*axes[p.axis] - p.at;
                const double rise = a->x[next].*axes[p.axis] - p.at;
                return std::abs(height) <= context.limits.CTX007_on_plane_steps * step &&
                       std::abs(rise) >= 0.5 * step; // it goes away from it
            });
            if (on == planes.end()) continue;
            Draft draft = draft_at_position(context, *a, list_places(context, *a), end);
            draft.entities.nodes.add(node_id(context, *a, end));
            draft.related.push_back(context.deck.blocks()[on->held->block].header);
            draft.message = bead_name(*a->bead) + " ends at node " +
                            std::to_string(node_id(context, *a, end)) + " on the plane " + "xyz"[on->axis] +
                            " = " + quantity(on->at, units, length_dimension) + ", which /BCS/" +
                            std::to_string(on->held->id) +
                            " makes one of symmetry: the node carries half a step there, as it should, and "
                            "the whole tool "
                            "has twice " +
                            force_text(context, *a, a->fn_total, a->ft_total);
            measure_cost(context, *a, a->fn_total, a->ft_total, draft);
            sink.add(std::move(draft));
        }
    }
}

} // namespace

extern const Rule CTX007{{.code = "CTX007",
                          .name = "symmetry-half",
                          .summary = "a bead ends on a plane of symmetry: its totals are those of one half",
                          .severity = Severity::info},
                         needs_closest | Needs::motion,
                         check};

} // namespace drawbead
