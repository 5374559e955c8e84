#include "cli/audit_deck.h"

#include "scene/interface_rank.h"
#include "scene/main_surface.h"
#include "scene/nodal_mass.h"

#include <cmath>
#include <map>

namespace drawbead {

namespace {

AuditSurface audit_surface(const Model& model, const Surface& surface, const std::vector<double>& mass,
                           unsigned threads) {
    AuditSurface out;
    out.mesh = near_mesh(segment_mesh(model, surface), {}, whole_surface, threads);
    const SurfaceStiffness stiffness(model, surface, threads);
    const bool known = stiffness.doubts().empty();
    for (const uint32_t segment : out.mesh.segment_index) {
        out.segment.push_back(known ? std::optional(stiffness(segment)) : std::nullopt);
        out.thickness.push_back(segment_thickness(model, surface.segments[segment]));
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
    const std::vector<int64_t> ranks = interface_ranks(model);
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
        one.rank = ranks[out.interfaces.size()];
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
