#include "scene/bead_path.h"

#include "base/parallel.h"
#include "contact/closest_segment.h"
#include "geometry/segment_shape.h"
#include "scene/main_surface.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>

namespace drawbead {

namespace {

constexpr std::size_t most_queries = 16'000; // of closest segments, in the whole deck
constexpr std::size_t even_times = 32, most_corners = 160;
constexpr double never = 1e29;

/// Where the tail of equal values begins: of zeros for a velocity.
std::optional<double> tail(const TimeTable& table, bool velocity) {
    const std::vector<double>& y = table.values();
    std::size_t first = y.size() - 1;
    if (velocity && y[first] != 0) return std::nullopt;
    while (first > 0 && y[first - 1] == y.back())
        --first;
    if (y.size() > 1 && first + 1 == y.size()) return std::nullopt; // goes on along its last line
    return first == 0 ? 0 : table.times()[first];
}

/// Length of what is perpendicular to a unit vector.
double along(Vec3 way, Vec3 normal) {
    return norm(way - dot(way, normal) * normal);
}

/// One motion at the sampled times.
struct Sampled {
    const Motion* motion = nullptr;
    std::vector<Placement> at;
};

class PathFinder {
public:
    PathFinder(const Model& model, const DeckContact& contact, const PathRequest& request)
        : model_(model), contact_(contact), request_(request),
          classes_(model, request.prescribed, request.end.value_or(never), true) {}

    std::vector<BeadPath> all() {
        std::vector<BeadPath> out;
        for (const InterfaceContact& one : contact_.interfaces)
            out.push_back(find_motion(one));
        const auto known = static_cast<std::size_t>(
            std::count_if(out.begin(), out.end(), [](const BeadPath& path) { return path.known(); }));
        std::vector<Followed> all;
        for (std::size_t b = 0; b < out.size(); ++b)
            if (out[b].known()) all.push_back(prepare(contact_.interfaces[b], most_queries / known, out[b]));
        for (uint32_t s = 0; s < contact_.surfaces.size(); ++s) {
            std::vector<Followed*> beads;
            for (Followed& one : all)
                if (one.path->known() && *one.contact->bead->surface == s) beads.push_back(&one);
            find_closest(s, beads);
        }
        for (Followed& one : all)
            if (one.path->known()) finish(one);
        return out;
    }

private:
    /// What is known of the motions of a bead and its blank.
    BeadPath find_motion(const InterfaceContact& one) {
        BeadPath path;
        path.unknown = one.unknown;
        if (!path.known()) return path;
        for (const NodeRow row : one.group->nodes)
            if (const ClassMotion& known = classes_.of(row); !known.motion) {
                path.unknown =
                    "bead node " + std::to_string(value(model_.nodes().user_id(row))) + ": " + known.why;
                return path;
            }
        const NearMesh& mesh = contact_.surfaces[*one.bead->surface].mesh;
        std::optional<uint32_t> last; // class
        for (const uint32_t row : mesh.node_row) {
            const uint32_t number = model_.motion().of_node[row];
            if (last == number) continue;
            const ClassMotion& known = classes_.of_class(number);
            if (!known.motion) {
                path.blank_unknown =
                    "node " + std::to_string(model_.nodes().id[row]) + " of the blank: " + known.why;
                return path;
            }
            if (last && known.key != classes_.of_class(*last).key) {
                path.unknown = "the blank deforms";
                return path;
            }
            last = number;
        }
        return path;
    }

    /// A bead on its way.
    struct Followed {
        const InterfaceContact* contact = nullptr;
        BeadPath* path = nullptr;
        std::vector<double> time;
        std::map<std::string, Sampled> motions; ///< of its nodes, by key
        std::vector<const Sampled*> of_node;
        Sampled blank;
        // By sampled node, then time:
        std::vector<Vec3> seen;      ///< where it is, as the blank sees it
        std::vector<ClosestHit> hit; ///< what is closest to it
        const NearMesh* mesh = nullptr;
        bool moved = false; ///< some are not those of the first cycle
    };

    Followed prepare(const InterfaceContact& one, std::size_t queries, BeadPath& path) {
        const Drawbead& bead = *one.bead;
        Followed out;
        out.contact = &one;
        out.path = &path;
        out.mesh = &contact_.surfaces[*bead.surface].mesh;
        const NearMesh& mesh = *out.mesh;
        if (mesh.segment.empty()) {
            path.unknown = "no segment is near";
            return out;
        }
        auto& motions = out.motions;
        auto& of_node = out.of_node;
        for (const NodeRow row : one.group->nodes) {
            const ClassMotion& known = classes_.of(row);
            Sampled& sampled = motions[known.key];
            sampled.motion = &*known.motion;
            of_node.push_back(&sampled);
            path.bead_moves = path.bead_moves || !known.motion->at_rest();
        }
        Sampled& blank = out.blank;
        blank.motion = path.blank_known() ? &*classes_.of(NodeRow{mesh.node_row.front()}).motion : &still_;
        path.blank_moves = !blank.motion->at_rest();

        std::vector<const Motion*> all{blank.motion};
        for (const auto& [key, sampled] : motions)
            all.push_back(sampled.motion);
        const std::vector<double>& time = out.time = times(bead, all, path);
        for (auto& [key, sampled] : motions)
            for (const double t : time)
                sampled.at.push_back(sampled.motion->placement(t));
        for (const double t : time)
            blank.at.push_back(blank.motion->placement(t));

        const std::size_t count = one.x.size();
        const std::size_t most = std::max<std::size_t>(8, queries / time.size());
        const std::size_t stride = (count + most - 1) / most;
        for (std::size_t begin = 0; begin < count; begin += stride) {
            NodePath node;
            node.begin = static_cast<uint32_t>(begin);
            node.end = static_cast<uint32_t>(std::min(count, begin + stride));
            node.place = static_cast<uint32_t>((node.begin + node.end) / 2);
            path.node.push_back(node);
        }

        const std::size_t steps = time.size();
        std::vector<Vec3>& seen = out.seen;
        seen.resize(path.node.size() * steps);
        for (std::size_t i = 0; i < path.node.size(); ++i) {
            const uint32_t place = path.node[i].place;
            for (std::size_t k = 0; k < steps; ++k)
                seen[i * steps + k] = blank.at[k].back(of_node[place]->at[k](one.x[place]));
        }
        // Where a node has not moved, the contact of the first cycle has the answer.
        out.hit.resize(seen.size());
        for (std::size_t i = 0; i < path.node.size(); ++i) {
            const uint32_t place = path.node[i].place;
            const ClosestHit& start = one.contact.node[place].exact;
            for (std::size_t k = 0; k < steps; ++k)
                if (start.found() && start.exact && seen[i * steps + k] == one.x[place])
                    out.hit[i * steps + k] = start;
                else
                    out.moved = true;
        }
        return out;
    }

    /// What is closest to the nodes of all beads of a surface: in the part of it that the contact has made,
    /// else in one that is large enough for all.
    void find_closest(uint32_t surface, const std::vector<Followed*>& beads) {
        std::vector<Followed*> far;
        std::vector<Vec3> points;
        for (Followed* one : beads) {
            if (!one->moved || find_all(tree_of(surface), *one->mesh, one->seen, one->hit)) continue;
            far.push_back(one);
            std::copy_if(one->seen.begin(), one->seen.end(), std::back_inserter(points),
                         [&](Vec3 x) { return !is_far(*one->mesh, x); });
        }
        if (far.empty()) return;
        NearMesh& larger = larger_[surface];
        larger =
            mesh_for_closest(segment_mesh(model_, model_.surfaces()[surface]), points, 0, request_.threads);
        const ClosestSegment tree(larger);
        for (Followed* one : far) {
            one->mesh = &larger;
            one->hit.assign(one->seen.size(), {});
            if (find_all(tree, larger, one->seen, one->hit) && moves_alike(larger, *one->path)) continue;
            *one->path = {};
            one->path->unknown = "the bead comes to a part of the blank that moves differently";
        }
    }

    void finish(const Followed& one) {
        BeadPath& path = *one.path;
        const Drawbead& bead = *one.contact->bead;
        const std::size_t steps = one.time.size();
        for (std::size_t i = 0; i < path.node.size(); ++i)
            if (!one.hit[i * steps].found()) {
                path = {};
                path.unknown = "the bead starts far away from the blank";
                return;
            }

        for (std::size_t i = 0; i < path.node.size() && path.blank_known(); ++i)
            for (std::size_t k = 1; k < steps && one.time[k] <= bead.t_stop; ++k)
                path.travel = std::max(path.travel, along(one.seen[i * steps + k] - one.seen[i * steps],
                                                          one.hit[i * steps].foot.normal));
        const SurfaceStiffness& stiffness = *contact_.surfaces[*bead.surface].stiffness;
        parallel_for(request_.threads, path.node.size(), [&](std::size_t i) {
            NodePath& node = path.node[i];
            const Walk walk{bead,
                            *one.mesh,
                            stiffness,
                            one.time,
                            *one.of_node[node.place],
                            one.blank,
                            &one.seen[i * steps],
                            &one.hit[i * steps],
                            one.contact->x[node.place],
                            one.contact->line.half_chord[node.place]};
            walk_along(walk, path, node);
        });
    }

    /// Times at which positions are looked at; says in the path what they cover.
    std::vector<double> times(const Drawbead& bead, const std::vector<const Motion*>& motions,
                              BeadPath& path) const {
        std::optional<double> end = request_.end;
        if (!end) {
            end = 0;
            for (const Motion* motion : motions) {
                const auto rest = rest_time(*motion);
                end = end && rest ? std::optional(std::max(*end, *rest)) : std::nullopt;
            }
        }
        path.whole_run = end.has_value();
        const double open = std::max(bead.t_start, 0.0);
        double last = end.value_or(0);
        // Without a known end the run is taken to reach the opening of the window.
        if (!request_.end && open < never) last = std::max(last, open);
        path.opens = open <= last && bead.t_stop >= open;
        path.end = last;

        std::vector<double> time{0, last};
        const auto add = [&](double t) {
            if (t > 0 && t < last) time.push_back(t);
        };
        add(open);
        add(bead.t_stop);
        if (path.bead_moves || path.blank_moves) {
            for (std::size_t k = 1; k < even_times; ++k)
                add(last * static_cast<double>(k) / static_cast<double>(even_times));
            std::vector<double> corners;
            for (const Motion* motion : motions)
                for (const double t : motion->corners(0, last))
                    corners.push_back(t);
            const std::size_t every = corners.size() / most_corners + 1;
            for (std::size_t k = 0; k < corners.size(); k += every)
                add(corners[k]);
        }
        std::sort(time.begin(), time.end());
        time.erase(std::unique(time.begin(), time.end()), time.end());
        return time;
    }

    /// Whether a known blank moves as one in a larger part, too.
    bool moves_alike(const NearMesh& mesh, const BeadPath& path) {
        if (!path.blank_known()) return true;
        std::optional<std::string> key;
        for (const uint32_t row : mesh.node_row) {
            const ClassMotion& known = classes_.of(NodeRow{row});
            if (!known.motion || (key && known.key != *key)) return false;
            key = known.key;
        }
        return true;
    }

    /// Out of any reach, or nowhere: not worth a search.
    static bool is_far(const NearMesh& mesh, Vec3 x) {
        const Vec3 lo = mesh.surface_min, hi = mesh.surface_max;
        const Vec3 gap{std::max({lo.x - x.x, x.x - hi.x, 0.0}), std::max({lo.y - x.y, x.y - hi.y, 0.0}),
                       std::max({lo.z - x.z, x.z - hi.z, 0.0})};
        const double size = norm(hi - lo);
        return !(norm(gap) <= 4 * size) || !std::isfinite(x.x + x.y + x.z);
    }

    /// Over the part of a surface that the contact has made; built once.
    const ClosestSegment& tree_of(uint32_t surface) {
        std::unique_ptr<const ClosestSegment>& tree = trees_[surface];
        const SurfaceScene& scene = contact_.surfaces[surface];
        if (!tree) tree = std::make_unique<const ClosestSegment>(scene.mesh, scene.tree);
        return *tree;
    }

    /// Finds what is not found yet. False: a part of the surface outside of the mesh may be closer somewhere.
    bool find_all(const ClosestSegment& closest, const NearMesh& mesh, const std::vector<Vec3>& points,
                  std::vector<ClosestHit>& hit) const {
        std::atomic<bool> exact = true;
        constexpr std::size_t chunk = 256;
        parallel_for(request_.threads, (points.size() + chunk - 1) / chunk, [&](std::size_t piece) {
            const std::size_t end = std::min(points.size(), (piece + 1) * chunk);
            for (std::size_t i = piece * chunk; i < end && exact; ++i) {
                if (hit[i].found()) continue;
                if (is_far(mesh, points[i])) {
                    hit[i].foot.distance = hit[i].d = std::numeric_limits<double>::max();
                    continue;
                }
                // At rest one look is enough.
                const bool again = i > piece * chunk && points[i] == points[i - 1];
                hit[i] = again ? hit[i - 1] : closest.find(points[i]);
                if (!hit[i].exact || !hit[i].found()) exact = false;
            }
        });
        return exact;
    }

    /// One node on its way.
    struct Walk {
        const Drawbead& bead;
        const NearMesh& mesh;
        const SurfaceStiffness& stiffness;
        const std::vector<double>& time;
        const Sampled& tool;
        const Sampled& blank;
        const Vec3* seen;
        const ClosestHit* hit;
        Vec3 start, chord;
    };

    static void walk_along(const Walk& w, const BeadPath& path, NodePath& node) {
        const double depth = w.bead.depth;
        const double open = std::max(w.bead.t_start, 0.0);
        node.element = std::sqrt(area(w.mesh.corners(w.hit[0].segment)));
        double pushed = 0; // how far a blank that is not prescribed was taken along
        bool was_in_reach = false, was_over = false, opened = false;
        std::optional<double> off;
        double height = 0;
        for (std::size_t k = 0; k < w.time.size(); ++k) {
            const ClosestHit& hit = w.hit[k];
            const double g = hit.found() ? w.stiffness(w.mesh.segment_index[hit.segment]).half_thickness : 0;
            if (!path.blank_known()) pushed = std::max(pushed, -hit.d);
            const double d = hit.d + pushed, beyond = d - depth - g;
            const bool over = hit.in_contact_range();
            const bool in_reach = over && (depth > 0 ? beyond < 0 : true);
            const double t = w.time[k];
            const bool inside = t >= open && t <= w.bead.t_stop;
            if (inside && !opened) {
                opened = true;
                node.opening_distance = d;
                node.opening_share = !over ? 0 : depth > 0 ? std::clamp(-beyond / depth, 0.0, 1.0) : 1;
                node.travel_before = along(w.seen[k] - w.seen[0], hit.foot.normal);
            }
            if (inside && over) node.nearest = std::min(node.nearest, beyond);
            if (inside && !over && was_over && was_in_reach && !node.left) node.left = t;
            if (inside && !in_reach && was_in_reach && over) off = t, height = 0;
            if (off && !in_reach) height = std::max(height, beyond);
            if (inside && in_reach && off) {
                if (!node.lift || height > node.lift->height) node.lift = NodePath::Lift{*off, t, height};
                off.reset();
            }
            if (inside && in_reach && was_in_reach && k > 0) add_ways(w, k, node);
            was_in_reach = inside && in_reach;
            was_over = over;
        }
    }

    static void add_ways(const Walk& w, std::size_t k, NodePath& node) {
        const Vec3 normal = w.blank.at[k].turn(w.hit[k].foot.normal);
        const Vec3 across = unit(cross(normal, w.tool.at[k].turn(w.chord)));
        const Vec3 tool = w.tool.at[k](w.start) - w.tool.at[k - 1](w.start);
        const Vec3 foot = w.hit[k].foot.point; // in the blank as the deck has it
        const Vec3 blank = w.blank.at[k](foot) - w.blank.at[k - 1](foot);
        const double way = std::abs(dot(tool, across));
        node.tool_way += way;
        node.slide_way += std::abs(dot(blank - tool, across));
        if (const double step = w.time[k] - w.time[k - 1]; step > 0)
            node.tool_speed = std::max(node.tool_speed, way / step);
    }

    const Model& model_;
    const DeckContact& contact_;
    const PathRequest& request_;
    ClassMotions classes_;
    const Motion still_;
    // By surface:
    std::map<uint32_t, std::unique_ptr<const ClosestSegment>> trees_;
    std::map<uint32_t, NearMesh> larger_;
};

} // namespace

std::optional<double> rest_time(const Motion& motion) {
    double last = 0;
    for (const Motion::Term& term : motion.terms) {
        const auto rest = tail(term.table, term.velocity);
        if (!rest && term.scale != 0) return std::nullopt;
        last = std::max(last, rest.value_or(0) * term.time_scale);
    }
    if (motion.turn) {
        const auto rest = tail(motion.turn->angle, false);
        if (!rest) return std::nullopt;
        last = std::max(last, *rest);
    }
    return last;
}

std::vector<BeadPath> bead_paths(const Model& model, const DeckContact& contact, const PathRequest& request) {
    return PathFinder(model, contact, request).all();
}

} // namespace drawbead
