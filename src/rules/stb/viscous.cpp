#include "rules/stb/viscous.h"

#include "rules/analysis.h"
#include "rules/stb/blank.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

/// Mean mass of the four nodes of a segment, from the shells of the surface around them.
std::optional<double> mean_mass(NodeMasses& masses, const SegmentNodes& nodes) {
    double sum = 0;
    for (const uint32_t node : nodes) {
        const auto mass = masses.of(node);
        if (!mass) return std::nullopt;
        sum += *mass;
    }
    return sum / 4;
}

} // namespace

double ViscousBead::speed_to_limit() const {
    double speed = 0;
    for (const Node& n : node)
        speed = std::max(speed, n.limit / n.damping);
    return speed;
}

double ViscousBead::restraint(double speed) const {
    double force = 0;
    for (const Node& n : node)
        force += std::min(speed * n.damping, n.limit) * n.length;
    return force;
}

double ViscousBead::limit() const {
    double force = 0;
    for (const Node& n : node)
        force += n.limit * n.length;
    return force;
}

std::optional<ViscousBead> viscous_bead(const RuleContext& context, const BeadAnalysis& a) {
    if (a.bead->iform != 1 || a.hit.empty()) return std::nullopt;
    const SurfaceStiffness* stiffness = known_stiffness(context, a);
    if (stiffness == nullptr) return std::nullopt;
    const NearMesh& near = context.analysis.surfaces[*a.bead->surface].near;
    NodeMasses masses(context.model, *a.surface, near);
    ViscousBead bead;
    for (std::size_t i = 0; i < a.hit.size(); ++i) {
        if (!a.hit[i].closest.in_contact_range()) continue;
        const double k = (*stiffness)(a.hit[i].segment).k;
        const auto mass = mean_mass(masses, near.segment[a.hit[i].closest.segment]);
        if (!mass || !(k > 0) || !(*mass > 0)) return std::nullopt;
        bead.node.push_back({std::sqrt(k * *mass), std::abs(a.ft[i]), a.line.tributary[i]});
    }
    if (!(bead.limit() > 0)) return std::nullopt;
    return bead;
}

} // namespace drawbead
