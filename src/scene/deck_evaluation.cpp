#include "scene/deck_evaluation.h"

#include "scene/class_motion.h"
#include "scene/interface_rank.h"
#include "scene/nodal_mass.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

namespace drawbead {

namespace {

/// Motions of the scene, equal ones once.
class MotionTable {
public:
    explicit MotionTable(EvaluationScene& scene) : scene_(scene) {}

    uint32_t add(const ClassMotion& known) {
        const auto [at, is_new] = index_.emplace(known.key, static_cast<uint32_t>(scene_.motions.size()));
        if (is_new) scene_.motions.push_back(*known.motion);
        return at->second;
    }

private:
    EvaluationScene& scene_;
    std::map<std::string, uint32_t> index_;
};

/// Farthest that a motion brings a node from where it starts.
double farthest(const Motion& motion, const std::vector<double>& time) {
    if (motion.turn) return std::numeric_limits<double>::infinity();
    Vec3 most; // along the axes: they need not be farthest at the same time
    const auto take = [&](double t) {
        const Vec3 way = motion.displacement(t);
        most = {std::max(most.x, std::abs(way.x)), std::max(most.y, std::abs(way.y)),
                std::max(most.z, std::abs(way.z))};
    };
    for (const double t : time)
        take(t);
    for (const double t : motion.corners(time.front(), time.back()))
        take(t);
    return norm(most);
}

EvaluationBead bead_of(const Model& model, const InterfaceContact& one) {
    EvaluationBead bead;
    bead.id = one.bead->id;
    bead.title = one.bead->title;
    bead.iform = one.bead->iform;
    bead.law = {one.bead->fn_first, one.bead->fn_last, one.bead->ft_first, one.bead->ft_last,
                one.bead->depth};
    bead.t_start = one.bead->t_start;
    bead.t_stop = one.bead->t_stop;
    bead.x = one.x;
    for (const NodeRow row : one.group->nodes)
        bead.nodes.push_back(value(model.nodes().user_id(row)));
    bead.track = one.track;
    bead.slope = one.contact.slope;
    for (const BeadNodeContact& node : one.contact.node)
        bead.slope_read.push_back(node.slope_read);
    return bead;
}

} // namespace

Result<DeckEvaluation> evaluation_of(const Model& model, const EvaluationRequest& request) {
    const std::string& path = model.deck().path();
    const std::vector<Drawbead>& drawbeads = model.drawbeads();
    if (drawbeads.empty()) return Error{"the deck has no drawbead (/INTER/TYPE8)", path, 0, 0, ""};
    for (const InterfaceId id : request.interfaces)
        if (std::none_of(drawbeads.begin(), drawbeads.end(), [&](const Drawbead& b) { return b.id == id; }))
            return Error{"no /INTER/TYPE8 with id " + std::to_string(id), path, 0, 0, ""};

    DeckEvaluation out;
    EvaluationScene& scene = out.scene;
    scene.time = request.time;
    scene.dt = request.dt;
    ClassMotions classes(model, request.prescribed, request.time.empty() ? 0 : request.time.back());
    MotionTable motions(scene);

    // How far anything goes, before the part of the surface near the beads is cut out.
    double travel = 0;
    for (uint32_t c = 0; c < model.motion().classes.size(); ++c)
        if (const ClassMotion& known = classes.of_class(c); known.motion)
            travel = std::max(travel, farthest(*known.motion, request.time));
    ContactOptions options;
    options.layer_ratio = 0;
    options.threads = request.threads;
    options.travel = out.travel = std::max(2 * travel, request.travel);
    DeckContact contact = contact_of(model, options);

    const std::vector<double> mass = nodal_masses(model);
    const std::vector<int64_t> ranks = interface_ranks(model);
    std::map<std::size_t, std::pair<std::size_t, std::string>> surfaces; // of the model: place, or why not
    for (std::size_t b = 0; b < drawbeads.size(); ++b) {
        const InterfaceContact& one = contact.interfaces[b];
        const InterfaceId id = one.bead->id;
        if (!request.interfaces.empty() &&
            std::find(request.interfaces.begin(), request.interfaces.end(), id) == request.interfaces.end())
            continue;
        std::string why = one.unknown;
        EvaluationBead bead;
        if (why.empty()) {
            bead = bead_of(model, one);
            for (const NodeRow row : one.group->nodes) {
                const ClassMotion& known = classes.of(row);
                if (known.motion) {
                    bead.motion.push_back(motions.add(known));
                    continue;
                }
                why = "bead node " + std::to_string(value(model.nodes().user_id(row))) + ": " + known.why;
                break;
            }
        }
        if (why.empty()) {
            const std::size_t s = *one.bead->surface;
            const auto [at, is_new] = surfaces.try_emplace(s);
            if (is_new) {
                const Surface& surface = model.surfaces()[s];
                const SurfaceStiffness& stiffness = *contact.surfaces[s].stiffness;
                EvaluationSurface made;
                made.id = surface.id;
                made.mesh = std::move(contact.surfaces[s].mesh);
                bool masses_known = true;
                for (const uint32_t row : made.mesh.node_row) {
                    const ClassMotion& known = classes.of(NodeRow{row});
                    if (!known.motion) {
                        at->second.second = "node " + std::to_string(model.nodes().id[row]) + " of surface " +
                                            std::to_string(surface.id) + ": " + known.why;
                        break;
                    }
                    made.motion.push_back(motions.add(known));
                    masses_known = masses_known && std::isfinite(mass[row]);
                    made.mass.push_back(std::isfinite(mass[row]) ? mass[row] : 0);
                }
                for (const uint32_t segment : made.mesh.segment_index) {
                    made.stiffness.push_back(stiffness(segment));
                    made.thickness.push_back(segment_thickness(model, surface.segments[segment]));
                }
                if (!masses_known)
                    out.notes.push_back("surface " + std::to_string(surface.id) +
                                        ": masses of some elements are not known and count as 0 in the "
                                        "viscous terms");
                for (const std::string& doubt : stiffness.doubts())
                    out.notes.push_back("surface " + std::to_string(surface.id) + ": " + doubt);
                if (at->second.second.empty()) {
                    at->second.first = scene.surfaces.size();
                    scene.surfaces.push_back(std::move(made));
                }
            }
            why = at->second.second;
            bead.surface = at->second.first;
        }
        if (!why.empty()) {
            out.left_out.push_back({id, std::move(why)});
            continue;
        }
        const bool past_table =
            std::any_of(bead.slope_read.begin(), bead.slope_read.end(), [](const auto& s) { return !s; });
        if (past_table && bead.law.fn_first != 0)
            out.notes.push_back(
                "interface " + std::to_string(id) +
                ": more bead nodes than segments: the solver reads slopes past the end of its "
                "table; here the segment's own stand in");
        std::optional<int64_t> tool;
        for (const Attachment& held : model.attachments(one.group->nodes.front()))
            if (held.kind == Attachment::Kind::rigid_body) tool = held.id;
        scene.beads.push_back(std::move(bead));
        out.rank.push_back(ranks[b]);
        out.tool.push_back(tool);
    }
    if (model.admesh())
        out.notes.emplace_back("/ADMESH/GLOBAL: the mesh is taken as the deck has it; a run refines it and "
                               "meets other segments");
    for (std::string& note : classes.take_notes())
        out.notes.push_back(std::move(note));
    return out;
}

} // namespace drawbead
