#include "rules/stb/blank.h"

#include "geometry/segment_shape.h"
#include "rules/analysis.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drawbead {

namespace {

/// Property types whose shells take their thickness from the element, and their modulus from the layers.
bool layered(const Property& p) {
    return p.type == 11 || p.type == 17 || p.type == 51 || p.type == 52;
}

bool usable(const Material* m) {
    return m != nullptr &&
           (m->stiffness == Material::Stiffness::known || m->stiffness == Material::Stiffness::none);
}

std::optional<SegmentStiffness> of_shell_segment(const Model& model, const Segment& s) {
    const Material* material = model.material_of(s);
    const Property* property = model.property_of(s);
    if (!usable(material) || property == nullptr || !property->has_thickness || layered(*property))
        return std::nullopt;
    return of_shell(material->young, property->thickness);
}

/// Bricks alone: the volume of other solids depends on how the solver stores their corners.
std::optional<SegmentStiffness> of_face(const Model& model, const Segment& s, uint32_t solid) {
    Segment behind = s;
    behind.kind = ElementKind::solid;
    behind.element = solid;
    const Material* material = model.material_of(behind);
    if (!usable(material) || model.solids().kind[solid] != SolidKind::brick) return std::nullopt;
    std::array<Vec3, 8> corners;
    for (std::size_t k = 0; k < 8; ++k) {
        const NodeRow row = model.solids().nodes[solid][k];
        if (row == no_node) return std::nullopt;
        corners[k] = model.nodes()[row];
    }
    Corners face;
    for (std::size_t k = 0; k < 4; ++k) {
        if (s.n[k] == no_node) return std::nullopt;
        face[k] = model.nodes()[s.n[k]];
    }
    return of_solid_face(area(face), material->bulk, one_point_volume(corners));
}

/// Rows [begin, end) of shells with one stiffness: neighbours in a surface mostly come from one.
struct SameShells {
    ElementKind kind = ElementKind::none;
    uint32_t begin = 0, end = 0;
    bool holds(const Segment& s) const { return s.kind == kind && s.element >= begin && s.element < end; }
};

SameShells shells_like(const Model& model, const Segment& s) {
    if (s.kind != ElementKind::shell4 && s.kind != ElementKind::shell3) return {};
    const auto& ranges = (s.kind == ElementKind::shell4 ? model.shells4() : model.shells3()).ranges;
    const auto range =
        std::upper_bound(ranges.begin(), ranges.end(), s.element,
                         [](uint32_t row, const ElementRange& one) { return row < one.row_end; });
    if (range == ranges.end()) return {};
    return {s.kind, range->row_begin, range->row_end};
}

} // namespace

std::optional<SegmentStiffness> stiffness_of(const Model& model, const Surface& surface, uint32_t segment) {
    const Segment& s = surface.segments[segment];
    if (s.kind == ElementKind::none) return SegmentStiffness{};
    if (s.kind == ElementKind::solid) return of_face(model, s, s.element);
    const auto shell = of_shell_segment(model, s);
    const auto solid =
        std::lower_bound(surface.coated.begin(), surface.coated.end(), segment,
                         [](const CoatedSolid& one, uint32_t wanted) { return one.segment < wanted; });
    if (!shell || solid == surface.coated.end() || solid->segment != segment) return shell;
    const auto face = of_face(model, s, solid->solid);
    if (!face) return std::nullopt;
    return coated(*face, *shell);
}

SurfaceBlank blank_of(const Model& model, const Surface& surface, std::size_t most_nodes) {
    SurfaceBlank blank;
    const auto count = static_cast<uint32_t>(surface.segments.size());
    SameShells same;
    for (uint32_t i = 0; i < count; ++i) {
        if (surface.coated.empty() && same.holds(surface.segments[i])) continue;
        const auto stiffness = stiffness_of(model, surface, i);
        if (!stiffness) return blank;
        same = shells_like(model, surface.segments[i]);
        blank.smallest_k = std::min(blank.smallest_k, stiffness->smallest);
        blank.least_own_k = std::min(blank.least_own_k, stiffness->k);
        blank.largest_k = std::max(blank.largest_k, stiffness->k);
    }
    blank.known = count != 0;
    if (!blank.mixed()) return blank;
    std::vector<std::pair<uint64_t, uint32_t>> order(count);
    for (uint32_t i = 0; i < count; ++i)
        order[i] = {surface.in_storage_order ? i : model.storage_key(surface, i), i};
    const std::size_t wanted = std::min<std::size_t>(most_nodes, count);
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(wanted), order.end());
    for (std::size_t i = 0; i < wanted; ++i)
        blank.in_storage_order.push_back(
            stiffness_of(model, surface, order[i].second).value_or(SegmentStiffness{}).k);
    return blank;
}

double BeadRamp::end_force(const BeadAnalysis& a) const {
    double force = 0;
    for (std::size_t i = 0; i < node.size(); ++i)
        force += node[i].slope * a.bead->depth * a.line.tributary[i];
    return force;
}

std::optional<BeadRamp> ramp_of(const RuleContext& context, const BeadAnalysis& a) {
    if (a.surface == nullptr || a.hit.empty()) return std::nullopt;
    const SurfaceBlank& blank = context.analysis.surfaces[*a.bead->surface].blank;
    if (!blank.known) return std::nullopt;
    const std::size_t segments = a.surface->segments.size();
    BeadRamp ramp;
    ramp.slope = choose_slope(a.bead->fn_first, a.bead->depth, blank.smallest_k);
    for (std::size_t i = 0; i < a.hit.size(); ++i) {
        BeadRamp::Node node;
        const auto stiffness = stiffness_of(context.model, *a.surface, a.hit[i].segment);
        if (!stiffness) return std::nullopt;
        node.k = stiffness->k;
        node.slope = ramp.slope.of(node.k);
        if (i < segments)
            node.read =
                blank.in_storage_order.empty() ? node.slope : ramp.slope.of(blank.in_storage_order[i]);
        ramp.node.push_back(node);
    }
    return ramp;
}

std::optional<MisreadSlopes> misread_slopes(const RuleContext& context, const BeadAnalysis& a) {
    if (a.bead->fn_first == 0 || a.bead->depth <= 0) return std::nullopt; // the slope is not used
    const auto ramp = ramp_of(context, a);
    if (!ramp) return std::nullopt;
    MisreadSlopes misread;
    misread.mixed =
        ramp->slope.kind == Slope::reset && context.analysis.surfaces[*a.bead->surface].blank.mixed();
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
