#include "scene/deck_evaluation.h"

#include "scene/interface_rank.h"
#include "scene/nodal_mass.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

namespace drawbead {

namespace {

/// A motion, or why it is not known.
struct Known {
    std::optional<Motion> motion;
    std::string why;
    std::string key; ///< equal for equal motions
};

/// What the classes of nodes of a model do.
class ClassMotions {
public:
    ClassMotions(const Model& model, const EvaluationRequest& request)
        : model_(model), motion_(model.motion()), request_(request), known_(motion_.classes.size()) {}

    const Known& of(NodeRow node) { return of_class(motion_.of_node[index(node)]); }

    const Known& of_class(uint32_t number) {
        if (!known_[number]) {
            known_[number] = Known{{}, "rigid bodies follow each other in a ring", ""};
            known_[number] = request_.deck_motion ? of_deck(number) : of_moves(number);
        }
        return *known_[number];
    }

    std::vector<std::string> take_notes() { return {notes_.begin(), notes_.end()}; }

private:
    using Condition = MotionCondition;

    std::string name(const Condition& c) const {
        const Block& block = model_.deck().blocks()[c.block];
        return "/" + std::string(block.keyword) + "/" + std::to_string(c.id);
    }

    static Known unknown(std::string why) { return {{}, std::move(why), ""}; }

    Known of_moves(uint32_t number) const {
        Known out;
        out.motion.emplace();
        std::set<std::size_t> acting; // a motion of two targets that share a node moves it once
        for (const uint32_t c : motion_.classes[number])
            acting.insert(request_.motion_of_target[motion_.conditions[c].function]);
        for (const std::size_t move : acting) {
            const Motion& part = request_.motions[move];
            out.motion->terms.insert(out.motion->terms.end(), part.terms.begin(), part.terms.end());
            if (part.turn && out.motion->turn) return unknown("two rotations act on the same nodes");
            if (part.turn) out.motion->turn = part.turn;
            if (!part.at_rest()) out.key += "m" + std::to_string(move) + " ";
        }
        if (out.motion->at_rest()) out.motion = Motion{};
        return out;
    }

    Known of_deck(uint32_t number) {
        const std::vector<uint32_t>& acting = motion_.classes[number];
        if (acting.empty()) return unknown("nothing in the deck prescribes its motion");
        for (const uint32_t c : acting) {
            const Condition& condition = motion_.conditions[c];
            if (condition.kind == Condition::Kind::unknown)
                return unknown(name(condition) + ": " + condition.why);
            if (condition.kind == Condition::Kind::rigid_body) return of_rigid_body(condition);
        }
        Known out;
        out.motion.emplace();
        Motion& motion = *out.motion;
        std::array<const Condition*, 3> by{};
        for (const uint32_t c : acting) {
            const Condition& condition = motion_.conditions[c];
            if (condition.kind == Condition::Kind::initial_velocity) {
                motion.initial_velocity = condition.velocity;
                continue;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                if (!condition.translation[k]) continue;
                const bool both_hold = by[k] && by[k]->kind == Condition::Kind::fixed &&
                                       condition.kind == Condition::Kind::fixed;
                if (by[k] && !both_hold)
                    return unknown(name(*by[k]) + " and " + name(condition) + " act in the same direction " +
                                   "XYZ"[k]);
                by[k] = &condition;
                if (std::string why = take(condition, k, motion); !why.empty())
                    return unknown(std::move(why));
            }
        }
        for (std::size_t k = 0; k < 3; ++k)
            if (!by[k]) return unknown(std::string("it is free in ") + "XYZ"[k]);
        if (motion.at_rest()) motion.terms.clear();
        for (const uint32_t c : acting)
            if (motion_.conditions[c].kind == Condition::Kind::initial_velocity)
                out.key += "i" + std::to_string(c) + " ";
        for (std::size_t k = 0; k < 3 && !motion.terms.empty(); ++k)
            if (by[k]->kind != Condition::Kind::fixed) out.key += key_of(*by[k], k);
        return out;
    }

    /// With all digits: equal texts are equal numbers.
    static std::string key_of(const Condition& c, std::size_t axis) {
        char text[96];
        std::snprintf(text, sizeof text, "%c%c%u*%a/%a ", c.kind == Condition::Kind::velocity ? 'v' : 'd',
                      "xyz"[axis], c.function, c.scale, c.time_scale);
        return text;
    }

    /// Adds one direction of a condition; gives why that is not possible.
    std::string take(const Condition& condition, std::size_t axis, Motion& motion) {
        if (condition.kind == Condition::Kind::fixed) return {};
        const MotionFunction& f = motion_.functions[condition.function];
        if (!f.unusable.empty()) return name(condition) + ": " + f.unusable;
        if (condition.sensor != 0)
            notes_.insert(name(condition) + ": sensor " + std::to_string(condition.sensor) +
                          " is ignored, the motion counts from the start");
        const double end = request_.time.empty() ? 0 : request_.time.back();
        if (condition.t_start > 0 || condition.t_stop < end)
            return name(condition) + " does not act over the whole run";
        motion.terms.push_back({condition.kind == Condition::Kind::velocity, axis, condition.scale,
                                condition.time_scale, TimeTable(f.x, f.y)});
        return {};
    }

    Known of_rigid_body(const Condition& body) {
        if (body.main == no_node) return unknown(name(body) + " has no main node");
        const uint32_t main = motion_.of_node[index(body.main)];
        if (body.sensor != 0)
            notes_.insert(name(body) + ": sensor " + std::to_string(body.sensor) +
                          " is ignored, the body counts as rigid from the start");
        std::array<bool, 3> held{};
        for (const uint32_t c : motion_.classes[main])
            if (motion_.conditions[c].kind == Condition::Kind::fixed)
                for (std::size_t k = 0; k < 3; ++k)
                    held[k] = held[k] || motion_.conditions[c].rotation[k];
        const Known& known = of_class(main);
        if (!known.motion) return unknown(name(body) + ", main node: " + known.why);
        if (!(held[0] && held[1] && held[2]))
            return unknown(name(body) + " may turn: nothing holds the rotation of its main node");
        return known;
    }

    const Model& model_;
    const DeckMotion& motion_;
    const EvaluationRequest& request_;
    std::vector<std::optional<Known>> known_;
    std::set<std::string> notes_;
};

/// Motions of the scene, equal ones once.
class MotionTable {
public:
    explicit MotionTable(EvaluationScene& scene) : scene_(scene) {}

    uint32_t add(const Known& known) {
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
    double most = 0;
    for (const double t : time)
        most = std::max(most, norm(motion.displacement(t)));
    for (const double t : motion.corners(time.front(), time.back()))
        most = std::max(most, norm(motion.displacement(t)));
    return most;
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
    ClassMotions classes(model, request);
    MotionTable motions(scene);

    // How far anything goes, before the part of the surface near the beads is cut out.
    double travel = 0;
    for (uint32_t c = 0; c < model.motion().classes.size(); ++c)
        if (const Known& known = classes.of_class(c); known.motion)
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
                const Known& known = classes.of(row);
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
                    const Known& known = classes.of(NodeRow{row});
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
