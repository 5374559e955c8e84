#include "cli/audit_deck.h"

#include "geometry/segment_shape.h"
#include "scene/main_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace drawbead {

namespace {

double thickness(const Model& model, const Segment& segment) {
    if (segment.kind != ElementKind::shell4 && segment.kind != ElementKind::shell3) return 0;
    if (const double own = model.own_thickness(segment); own > 0) return own;
    const Property* property = model.property_of(segment);
    return property ? property->thickness : 0;
}

/// Masses of all nodes as the solver gives shells and bricks theirs (observed on solver runs); NaN where the
/// tool does not know an element's share. Other things may add mass, so these are a pattern and no law.
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

/// What the solver counts as an interface: sub-interfaces are for output.
bool is_interface(std::string_view keyword) {
    return keyword.substr(0, 6) == "INTER/" && keyword != "INTER/SUB";
}

AuditSurface audit_surface(const Model& model, const Surface& surface, const std::vector<double>& mass,
                           unsigned threads) {
    AuditSurface out;
    out.mesh = near_mesh(segment_mesh(model, surface), {}, whole_surface, threads);
    const SurfaceStiffness stiffness(model, surface, threads);
    const bool known = stiffness.doubts().empty();
    for (const uint32_t segment : out.mesh.segment_index) {
        out.segment.push_back(known ? std::optional(stiffness(segment)) : std::nullopt);
        out.thickness.push_back(thickness(model, surface.segments[segment]));
    }
    for (const uint32_t row : out.mesh.node_row)
        out.mass.push_back(std::isfinite(mass[row]) ? mass[row] : 0);
    return out;
}

} // namespace

Result<AuditDeck> audit_deck(const Model& model, unsigned threads) {
    AuditDeck out;
    out.adaptive = model.admesh().has_value();
    std::map<uint32_t, std::size_t> surfaces; // of the model -> of the audit
    const std::string& path = model.deck().path();
    if (model.drawbeads().empty()) return Error{"the deck has no drawbead (/INTER/TYPE8)", path, 0, 0, ""};
    const std::vector<double> mass = nodal_masses(model);
    std::vector<uint32_t> interfaces; // blocks of all types
    for (uint32_t i = 0; i < model.deck().blocks().size(); ++i)
        if (is_interface(model.deck().blocks()[i].keyword)) interfaces.push_back(i);
    for (const Drawbead& bead : model.drawbeads()) {
        const std::string name = "interface " + std::to_string(bead.id);
        if (!bead.group || !model.groups()[*bead.group].evaluated)
            return Error{"the node group " + std::to_string(bead.group_id) + " of " + name +
                             (bead.group ? " is of a type that cannot be expanded" : " does not exist"),
                         path, 0, 0, ""};
        if (!bead.surface || !model.surfaces()[*bead.surface].evaluated)
            return Error{"the surface " + std::to_string(bead.surface_id) + " of " + name +
                             (bead.surface ? " is of a type that cannot be expanded" : " does not exist"),
                         path, 0, 0, ""};
        AuditInterface one;
        one.id = bead.id;
        one.rank =
            1 + std::lower_bound(interfaces.begin(), interfaces.end(), bead.block) - interfaces.begin();
        one.iform = bead.iform;
        one.law = {bead.fn_first, bead.fn_last, bead.ft_first, bead.ft_last, bead.depth};
        one.t_start = bead.t_start;
        one.t_stop = bead.t_stop;
        for (const NodeRow row : model.groups()[*bead.group].nodes) {
            one.nodes.push_back(value(model.nodes().user_id(row)));
            one.start.push_back(model.nodes()[row]);
        }
        const auto [at, is_new] = surfaces.emplace(*bead.surface, out.surfaces.size());
        if (is_new)
            out.surfaces.push_back(audit_surface(model, model.surfaces()[*bead.surface], mass, threads));
        one.surface = at->second;
        out.interfaces.push_back(std::move(one));
    }
    return out;
}

} // namespace drawbead
