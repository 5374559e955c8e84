#include "scene/deck_contact.h"

#include <algorithm>

namespace drawbead {

namespace {

bool has_positions(const Model& model) {
    return model.nodes().x.size() == model.nodes().size();
}

/// Why nothing can be said of the segments under a bead; empty when something can.
std::string reason(const InterfaceContact& one) {
    const Drawbead& bead = *one.bead;
    if (!one.group) return "node group " + std::to_string(bead.group_id) + " is not defined";
    if (!one.group->evaluated)
        return "node group " + std::to_string(one.group->id) + " is of a type that drawbead cannot expand";
    if (one.x.empty()) return "node group " + std::to_string(one.group->id) + " has no nodes";
    if (!one.surface) return "surface " + std::to_string(bead.surface_id) + " is not defined";
    if (!one.surface->evaluated)
        return "surface " + std::to_string(one.surface->id) + " is of a type that drawbead cannot expand";
    if (one.surface->segments.empty())
        return "surface " + std::to_string(one.surface->id) + " has no segments";
    return {};
}

InterfaceContact interface_of(const Model& model, const Drawbead& bead) {
    InterfaceContact one;
    one.bead = &bead;
    if (bead.group) one.group = &model.groups()[*bead.group];
    if (bead.surface) one.surface = &model.surfaces()[*bead.surface];
    if (one.group && has_positions(model))
        for (const NodeRow row : one.group->nodes)
            one.x.push_back(model.nodes()[row]);
    one.unknown = reason(one);
    return one;
}

BeadInput input_of(const Model& model, const InterfaceContact& one) {
    const int ipri = static_cast<int>(std::clamp<int64_t>(model.ipri(), 0, 100));
    return {one.x, one.bead->fn_first, one.bead->depth, ipri};
}

/// What the Starter says, with the places of 346; of an interface that lacks its group or surface it says
/// other things first.
StarterVerdict verdict(const Model& model, const InterfaceContact& one, const SurfaceStiffness* stiffness,
                       std::vector<uint32_t> places) {
    StarterInput in;
    in.group_ordered = !one.group || one.group->order != NodeGroup::Order::sorted;
    in.iform = one.bead->iform;
    in.admesh_idt = model.admesh() && model.admesh()->idt == 1;
    if (stiffness) {
        in.fn_first = one.bead->fn_first;
        in.depth = one.bead->depth;
        in.smallest_k = stiffness->smallest();
    }
    return starter_verdict(in, std::move(places));
}

/// Interfaces by the surface that their nodes meet.
std::vector<std::vector<std::size_t>> by_surface(const Model& model,
                                                 const std::vector<InterfaceContact>& interfaces) {
    std::vector<std::vector<std::size_t>> out(model.surfaces().size());
    for (std::size_t i = 0; i < interfaces.size(); ++i)
        if (interfaces[i].unknown.empty()) out[*interfaces[i].bead->surface].push_back(i);
    return out;
}

std::vector<BeadInput> inputs_of(const Model& model, const std::vector<InterfaceContact>& interfaces,
                                 const std::vector<std::size_t>& members) {
    std::vector<BeadInput> inputs;
    for (const std::size_t i : members)
        inputs.push_back(input_of(model, interfaces[i]));
    return inputs;
}

void take_line(InterfaceContact& one) {
    const Drawbead& bead = *one.bead;
    one.line = bead_line(one.x);
    for (const double s : one.line.s) {
        one.fn.push_back(normal_limit_along(bead.fn_first, bead.fn_last, s, one.line.length));
        one.ft.push_back(limit_along(bead.ft_first, bead.ft_last, s, one.line.length));
    }
}

} // namespace

DeckContact contact_of(const Model& model, const ContactOptions& options) {
    DeckContact out;
    out.surfaces.resize(model.surfaces().size());
    for (const Drawbead& bead : model.drawbeads()) {
        out.interfaces.push_back(interface_of(model, bead));
        take_line(out.interfaces.back());
    }
    for (InterfaceContact& one : out.interfaces)
        if (!one.unknown.empty()) one.starter = verdict(model, one, nullptr, {});

    const auto members = by_surface(model, out.interfaces);
    for (std::size_t s = 0; s < members.size(); ++s) {
        if (members[s].empty()) continue;
        const Surface& surface = model.surfaces()[s];
        SurfaceScene& scene = out.surfaces[s];
        scene.stiffness = std::make_unique<SurfaceStiffness>(model, surface, options.threads);
        const SurfaceStiffness& stiffness = *scene.stiffness;
        const std::vector<BeadInput> inputs = inputs_of(model, out.interfaces, members[s]);
        // The slope is read by the node's place in the list: as many entries as the longest list has nodes.
        std::size_t longest = 0;
        for (const BeadInput& input : inputs) {
            const Slope slope = choose_slope(input.fn_first, input.depth, stiffness.smallest()).kind;
            if (slope == Slope::reset || slope == Slope::depth_absent)
                longest = std::max(longest, input.x.size());
        }
        SurfaceContact contact = surface_contact(
            segment_mesh(model, surface), inputs, [&](uint32_t i) { return stiffness(i); },
            stiffness.smallest(), stiffness.in_storage_order(longest), options);
        scene.mesh = std::move(contact.mesh);
        scene.tree = std::move(contact.tree);
        for (std::size_t b = 0; b < members[s].size(); ++b) {
            InterfaceContact& one = out.interfaces[members[s][b]];
            one.contact = std::move(contact.bead[b]);
            one.track = std::move(contact.track[b]);
            one.starter = verdict(model, one, &stiffness, one.contact.nodes_346());
        }
    }
    return out;
}

std::vector<StarterVerdict> starter_of(const Model& model, unsigned threads) {
    std::vector<InterfaceContact> interfaces;
    std::vector<StarterVerdict> out;
    for (const Drawbead& bead : model.drawbeads()) {
        interfaces.push_back(interface_of(model, bead));
        out.push_back(verdict(model, interfaces.back(), nullptr, {}));
    }
    const auto members = by_surface(model, interfaces);
    for (std::size_t s = 0; s < members.size(); ++s) {
        if (members[s].empty()) continue;
        const Surface& surface = model.surfaces()[s];
        const SurfaceStiffness stiffness(model, surface, threads);
        auto places =
            nodes_346(segment_mesh(model, surface), inputs_of(model, interfaces, members[s]), threads);
        for (std::size_t b = 0; b < members[s].size(); ++b) {
            const std::size_t i = members[s][b];
            out[i] = verdict(model, interfaces[i], &stiffness, std::move(places[b]));
        }
    }
    return out;
}

} // namespace drawbead
