#include "rules/stb/blank.h"

#include "geometry/segment_shape.h"
#include "rules/analysis.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

/// Whether the segments of a surface differ in stiffness, by more than rounding.
bool mixed(const SurfaceStiffness& stiffness, std::size_t segments) {
    const double first = stiffness(0).k;
    for (uint32_t i = 1; i < segments; ++i)
        if (std::abs(stiffness(i).k - first) > 1e-9 * first) return true;
    return false;
}

/// What the element behind a segment gives to each of its nodes; empty where that is not known.
std::optional<double> mass_per_node(const Model& model, const Segment& s, const Corners& c) {
    const Material* material = model.material_of(s);
    const Property* property = model.property_of(s);
    if (s.kind == ElementKind::none || s.kind == ElementKind::solid) return std::nullopt;
    if (material == nullptr || property == nullptr || !property->has_thickness) return std::nullopt;
    const double own = model.own_thickness(s);
    const double mass = material->density * area(c) * (own > 0 ? own : property->thickness);
    return mass / (s.kind == ElementKind::shell3 ? 3 : 4);
}

} // namespace

double NodeMasses::share_of(uint32_t local) const {
    const uint32_t segment = near_.segment_index[local];
    const auto coated = std::lower_bound(surface_.coated.begin(), surface_.coated.end(), segment,
                                         [](const CoatedSolid& c, uint32_t s) { return c.segment < s; });
    if (coated != surface_.coated.end() && coated->segment == segment)
        return not_known; // the solid behind has mass too
    return mass_per_node(model_, surface_.segments[segment], near_.corners(local)).value_or(not_known);
}

std::optional<double> NodeMasses::of(uint32_t local) {
    double sum = 0;
    for (const uint32_t around : near_.segments_around(local)) {
        double& share = share_[around];
        if (share == not_yet) share = share_of(around);
        if (share == not_known) return std::nullopt;
        sum += share;
    }
    return sum;
}

const InterfaceContact* first_cycle(const RuleContext& context, const BeadAnalysis& a) {
    const std::vector<InterfaceContact>& all = context.analysis.contact.interfaces;
    const auto at = static_cast<std::size_t>(&a - context.analysis.beads.data());
    return at < all.size() && all[at].unknown.empty() && all[at].contact.node.size() == a.x.size() ? &all[at]
                                                                                                   : nullptr;
}

const SurfaceStiffness* known_stiffness(const RuleContext& context, const BeadAnalysis& a) {
    if (first_cycle(context, a) == nullptr) return nullptr;
    const auto& stiffness = context.analysis.contact.surfaces[*a.bead->surface].stiffness;
    return stiffness && stiffness->doubts().empty() ? stiffness.get() : nullptr;
}

double BeadRamp::end_force(const BeadAnalysis& a) const {
    double force = 0;
    for (std::size_t i = 0; i < node.size(); ++i)
        force += node[i].slope * a.bead->depth * a.line.tributary[i];
    return force;
}

std::optional<BeadRamp> ramp_of(const RuleContext& context, const BeadAnalysis& a) {
    const SurfaceStiffness* stiffness = known_stiffness(context, a);
    if (stiffness == nullptr) return std::nullopt;
    const BeadContact& contact = first_cycle(context, a)->contact;
    BeadRamp ramp;
    ramp.smallest_k = stiffness->smallest();
    ramp.slope = contact.slope;
    for (const BeadNodeContact& n : contact.node)
        ramp.node.push_back({n.k, n.slope, n.slope_read});
    return ramp;
}

std::optional<MisreadSlopes> misread_slopes(const RuleContext& context, const BeadAnalysis& a) {
    if (a.bead->fn_first == 0 || a.bead->depth <= 0) return std::nullopt; // the slope is not used
    const auto ramp = ramp_of(context, a);
    if (!ramp) return std::nullopt;
    MisreadSlopes misread;
    misread.mixed =
        ramp->slope.kind == Slope::reset && mixed(*known_stiffness(context, a), a.surface->segments.size());
    if (!misread.mixed && a.x.size() <= a.surface->segments.size()) return std::nullopt;
    for (std::size_t i = 0; i < ramp->node.size(); ++i) {
        const BeadRamp::Node& node = ramp->node[i];
        if (node.read && *node.read == node.slope) continue;
        misread.node.push_back(i);
        if (node.read) {
            misread.difference += std::abs(*node.read - node.slope) * a.bead->depth * a.line.tributary[i];
        } else {
            ++misread.beyond_count;
            misread.beyond += std::abs(a.fn_force(i));
        }
    }
    return misread;
}

} // namespace drawbead
