#include "rules/stb/time_step.h"

#include "rules/analysis.h"
#include "rules/stb/blank.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
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

    struct Sum {
        double normal = 0, stick = 0;
    };
    std::map<uint32_t, Sum> by_id; // user ids of nodes of the sheet
    const BeadContact& contact = first_cycle(context, a)->contact;
    for (const BeadNodeContact& n : contact.node) {
        if (!n.inside) continue;
        for (std::size_t k = 0; k < 4; ++k) {
            if (n.h[k] == 0) continue;
            Sum& sum =
                by_id[static_cast<uint32_t>(value(context.model.nodes().user_id(NodeRow{n.nodes[k]})))];
            if (ramp) sum.normal += n.slope_read.value_or(n.slope) * n.solver_tributary * n.h[k];
            if (sticks) sum.stick += n.k * n.h[k];
        }
    }

    const NearMesh& near = context.analysis.surfaces[*bead.surface].near;
    std::vector<std::optional<double>> steps(near.segment.size()); // each serves four nodes; 0: not known
    std::optional<TimeStepRisk> worst;
    for (const auto& [id, sum] : by_id) {
        const auto at = std::lower_bound(near.node_id.begin(), near.node_id.end(), id);
        if (at == near.node_id.end() || *at != id) continue;
        const auto local = static_cast<uint32_t>(at - near.node_id.begin());
        if (!near.is_complete(local)) continue;
        TimeStepRisk one;
        one.node = id;
        one.normal = std::abs(sum.normal);
        one.stick = sum.stick;
        one.element_step = std::numeric_limits<double>::infinity();
        for (const uint32_t around : near.segments_around(local)) {
            std::optional<double>& step = steps[around];
            if (!step)
                step = step_of(context, a.surface->segments[near.segment_index[around]], near.corners(around))
                           .value_or(0);
            if (*step == 0) return std::nullopt;
            one.element_step = std::min(one.element_step, *step);
        }
        const auto mass = node_mass(context.model, *a.surface, near, local);
        if (!mass || !(*mass > 0)) return std::nullopt;
        one.mass = *mass;
        if (!worst || one.ratio() < worst->ratio()) worst = one;
    }
    return worst;
}

} // namespace drawbead
