#include "scene/nodal_mass.h"

#include "geometry/segment_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace drawbead {

double segment_thickness(const Model& model, const Segment& segment) {
    if (segment.kind != ElementKind::shell4 && segment.kind != ElementKind::shell3) return 0;
    if (const double own = model.own_thickness(segment); own > 0) return own;
    const Property* property = model.property_of(segment);
    return property ? property->thickness : 0;
}

std::vector<double> nodal_masses(const Model& model) {
    std::vector<double> mass(model.nodes().size(), 0.0);
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    const auto density = [&](const Part* part) {
        const Material* material = part ? model.material(part->material) : nullptr;
        return material && material->density > 0 ? material->density : unknown;
    };
    const auto add = [&](NodeRow row, double share) {
        if (row != no_node) mass[index(row)] += share;
    };
    for (const ShellTable* shells : {&model.shells4(), &model.shells3()}) {
        const bool triangles = shells == &model.shells3();
        for (uint32_t i = 0; i < shells->nodes.size(); ++i) {
            const auto& n = shells->nodes[i];
            if (std::find(n.begin(), n.end(), no_node) != n.end()) continue;
            Corners x;
            for (std::size_t k = 0; k < 4; ++k)
                x[k] = model.nodes()[n[k]];
            const Part* part = model.part(shells->part(i));
            const Property* property = part ? model.property(part->property) : nullptr;
            double t = shells->own_thickness(i);
            if (t == 0) t = property && property->has_thickness ? property->thickness : unknown;
            const double whole = density(part) * t * area(x);
            for (std::size_t k = 0; k < (triangles ? 3 : 4); ++k) {
                if (!triangles) {
                    add(n[k], 0.25 * whole);
                    continue;
                }
                const Vec3 a = x[(k + 1) % 3] - x[k], b = x[(k + 2) % 3] - x[k];
                add(n[k], whole * std::atan2(norm(cross(a, b)), dot(a, b)) / std::numbers::pi);
            }
        }
    }
    for (uint32_t i = 0; i < model.solids().nodes.size(); ++i) {
        const auto& n = model.solids().nodes[i];
        const bool brick =
            model.solids().kind[i] == SolidKind::brick && std::find(n.begin(), n.end(), no_node) == n.end();
        double share = unknown;
        if (brick) {
            std::array<Vec3, 8> x;
            for (std::size_t k = 0; k < 8; ++k)
                x[k] = model.nodes()[n[k]];
            share = density(model.part(model.solids().part(i))) * one_point_volume(x) / 8;
        }
        for (const NodeRow row : n)
            add(row, share);
    }
    return mass;
}

} // namespace drawbead
