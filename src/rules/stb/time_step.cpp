#include "rules/stb/time_step.h"

#include "rules/analysis.h"
#include "rules/stb/blank.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace drawbead {

namespace {

/// Size over speed of sound of the shell behind a segment; empty when it is none or not known.
std::optional<double> step_of(const RuleContext& context, const Segment& s, const Corners& c) {
    if (s.kind != ElementKind::shell4 && s.kind != ElementKind::shell3) return std::nullopt;
    const Material* material = context.model.material_of(s);
    if (material == nullptr || material->stiffness != Material::Stiffness::known) return std::nullopt;
    if (!(material->young > 0) || !(material->density > 0) || !(material->bulk > 0)) return std::nullopt;
    double longest = 0;
    for (std::size_t k = 0; k < 4; ++k)
        longest = std::max(longest, distance(c[k], c[(k + 1) % 4]));
    const double size = area(c) * (s.kind == ElementKind::shell3 ? 2 : 1) / longest;
    const double poisson = 0.5 - material->young / (6 * material->bulk);
    return size * std::sqrt(material->density * (1 - poisson * poisson) / material->young);
}

} // namespace

double TimeStepRisk::ratio() const {
    return 1 / std::sqrt(1 + contact() * element_step * element_step / (4 * mass));
}

std::optional<TimeStepRisk> time_step_risk(const RuleContext& context, const BeadAnalysis& a) {
    const SurfaceStiffness* stiffness = known_stiffness(context, a);
    if (stiffness == nullptr) return std::nullopt;
    const Drawbead& bead = *a.bead;
    const bool ramp = bead.fn_first != 0 && bead.depth > 0;
    const bool sticks = bead.iform != 1 && a.ft_total != 0;
    if (!ramp && !sticks) return std::nullopt;

    struct Share {
        uint32_t node; ///< of the sheet, user id
        double normal, stick;
    };
    std::vector<Share> shares;
    const BeadContact& contact = first_cycle(context, a)->contact;
    shares.reserve(4 * contact.node.size());
    for (const BeadNodeContact& n : contact.node) {
        if (!n.inside) continue;
        for (std::size_t k = 0; k < 4; ++k) {
            if (n.h[k] == 0) continue;
            const auto id = static_cast<uint32_t>(value(context.model.nodes().user_id(NodeRow{n.nodes[k]})));
            shares.push_back({id, ramp ? n.slope_read.value_or(n.slope) * n.solver_tributary * n.h[k] : 0,
                              sticks ? n.k * n.h[k] : 0});
        }
    }
    std::stable_sort(shares.begin(), shares.end(),
                     [](const Share& p, const Share& q) { return p.node < q.node; });

    const NearMesh& near = context.analysis.surfaces[*bead.surface].near;
    std::vector<std::optional<double>> steps(near.segment.size()); // each serves four nodes; 0: not known
    NodeMasses masses(context.model, *a.surface, near);
    std::optional<TimeStepRisk> worst;
    auto at = near.node_id.begin();
    for (auto share = shares.begin(); share != shares.end();) {
        TimeStepRisk one;
        one.node = share->node;
        for (; share != shares.end() && share->node == one.node; ++share) {
            one.normal += share->normal;
            one.stick += share->stick;
        }
        one.normal = std::abs(one.normal);
        at = std::lower_bound(at, near.node_id.end(), one.node);
        if (at == near.node_id.end()) break;
        const auto local = static_cast<uint32_t>(at - near.node_id.begin());
        if (*at != one.node || !near.is_complete(local)) continue;
        one.element_step = std::numeric_limits<double>::infinity();
        for (const uint32_t around : near.segments_around(local)) {
            std::optional<double>& step = steps[around];
            if (!step)
                step = step_of(context, a.surface->segments[near.segment_index[around]], near.corners(around))
                           .value_or(0);
            if (*step == 0) return std::nullopt;
            one.element_step = std::min(one.element_step, *step);
        }
        const auto mass = masses.of(local);
        if (!mass || !(*mass > 0)) return std::nullopt;
        one.mass = *mass;
        if (!worst || one.ratio() < worst->ratio()) worst = one;
    }
    return worst;
}

} // namespace drawbead
