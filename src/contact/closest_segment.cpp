#include "contact/closest_segment.h"

#include "base/radix_order.h"
#include "geometry/closest_foot.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace drawbead {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr uint32_t leaf_size = 4;

double outside(double lo, double hi, double at) {
    return std::max({lo - at, at - hi, 0.0});
}

double squared_distance_to_box(Vec3 lo, Vec3 hi, Vec3 x) {
    return squared_norm({outside(lo.x, hi.x, x.x), outside(lo.y, hi.y, x.y), outside(lo.z, hi.z, x.z)});
}

Vec3 lower(Vec3 a, Vec3 b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3 upper(Vec3 a, Vec3 b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// Node numbers of edge k; a triangle has no edge 2.
std::array<uint32_t, 2> edge_nodes(const SegmentNodes& n, std::size_t k) {
    return {n[k], n[(k + 1) % 4]};
}

bool holds(const SegmentNodes& n, uint32_t node) {
    return std::find(n.begin(), n.end(), node) != n.end();
}

/// Whether two segments have the nodes of an edge in common, next to each other in both.
bool has_edge(const SegmentNodes& n, uint32_t a, uint32_t b) {
    for (std::size_t k = 0; k < 4; ++k) {
        const auto e = edge_nodes(n, k);
        if ((e[0] == a && e[1] == b) || (e[0] == b && e[1] == a)) return true;
    }
    return false;
}

bool is_free_edge(const NearMesh& mesh, uint32_t a, uint32_t b) {
    int count = 0;
    for (const uint32_t s : mesh.segments_around(a))
        count += has_edge(mesh.segment[s], a, b);
    return count == 1;
}

/// Whether any edge that ends at this node is free.
bool on_outline(const NearMesh& mesh, uint32_t node) {
    for (const uint32_t s : mesh.segments_around(node))
        for (std::size_t k = 0; k < 4; ++k) {
            const auto e = edge_nodes(mesh.segment[s], k);
            if (e[0] != e[1] && (e[0] == node || e[1] == node) && is_free_edge(mesh, e[0], e[1])) return true;
        }
    return false;
}

/// Nodes of a segment at the foot: one for a corner, two for an edge, none inside.
struct FootNodes {
    std::array<uint32_t, 2> node{};
    std::size_t count = 0;
};

FootNodes nodes_at(const SegmentNodes& n, const Foot& foot) {
    FootNodes out;
    std::array<std::size_t, 2> edge{};
    std::size_t edges = 0;
    for (std::size_t k = 0; k < 4 && edges < 2; ++k)
        if (foot.edges >> k & 1) edge[edges++] = k;
    if (edges == 0) return out;
    const auto first = edge_nodes(n, edge[0]);
    if (edges == 1) return {first, 2};
    const auto second = edge_nodes(n, edge[1]);
    const bool shared = first[0] == second[0] || first[0] == second[1];
    return {{shared ? first[0] : first[1], 0}, 1};
}

/// Bits of a ten-bit number moved three apart.
uint32_t spread(uint32_t v) {
    v = (v | v << 16) & 0x030000ff;
    v = (v | v << 8) & 0x0300f00f;
    v = (v | v << 4) & 0x030c30c3;
    return (v | v << 2) & 0x09249249;
}

/// Distance to the straight piece from a to b, squared.
double squared_distance_to_line(Vec3 a, Vec3 b, Vec3 x) {
    const Vec3 along = b - a, away = x - a;
    const double squared = squared_norm(along);
    const double t = squared > 0 ? std::clamp(dot(away, along) / squared, 0.0, 1.0) : 0.0;
    return squared_norm(away - t * along);
}

/// An upper bound of the distance to a segment, squared, by straight pieces of it that begin at a foot on its
/// border: the edges that end in a corner, or the ruling that crosses from a point of an edge to the edge
/// opposite.
double squared_bound_from(const NearMesh& mesh, const SegmentNodes& n, const FootNodes& at, Vec3 foot,
                          Vec3 x) {
    double bound = infinity;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto e = edge_nodes(n, k);
        if (at.count == 1 && (e[0] == at.node[0] || e[1] == at.node[0]))
            bound = std::min(bound, squared_distance_to_line(mesh.x[e[0]], mesh.x[e[1]], x));
        if (at.count == 2 &&
            ((e[0] == at.node[0] && e[1] == at.node[1]) || (e[1] == at.node[0] && e[0] == at.node[1]))) {
            const Vec3 from = mesh.x[e[0]], edge = mesh.x[e[1]] - from;
            const double squared = squared_norm(edge);
            const double t = squared > 0 ? dot(foot - from, edge) / squared : 0;
            const Vec3 before = mesh.x[n[(k + 3) % 4]], after = mesh.x[n[(k + 2) % 4]];
            bound = std::min(bound, squared_distance_to_line(foot, before + t * (after - before), x));
        }
    }
    return bound;
}

constexpr std::size_t no_edge = 4;

/// An edge of a segment that its closest point to x is on, whatever the segment's shape: the squared distance
/// falls all over it towards that edge. no_edge: there may be none. S(u, v) is bilinear, so that its
/// derivative (S - x) . S_u is a polynomial of degree 1 by 2, and one sign of its Bernstein coefficients is
/// its sign everywhere. A triangle's edge 1 to 2 is told, its others are not.
std::size_t edge_downhill(const Corners& c, Vec3 x) {
    const Vec3 a = c[0] - x, b = c[1] - x, d = c[3] - x, e = c[2] - x;
    const Vec3 left = c[3] - c[0], right = c[2] - c[1];
    const double al = dot(a, left), br = dot(b, right), dl = dot(d, left), er = dot(e, right);
    const double across_a = dot(a, right) + dot(b, left), across_d = dot(d, right) + dot(e, left);
    if (std::min({al, br, dl, er, across_a, across_d}) > 0) return 0;
    if (std::max({al, br, dl, er, across_a, across_d}) < 0) return 2;
    const Vec3 bottom = c[1] - c[0], top = c[2] - c[3];
    const double ab = dot(a, bottom), dt = dot(d, top), bb = dot(b, bottom), et = dot(e, top);
    const double up_a = dot(a, top) + dot(d, bottom), up_b = dot(b, top) + dot(e, bottom);
    if (std::min({ab, dt, bb, et, up_a, up_b}) > 0) return 3;
    if (std::max({ab, dt, bb, et, up_a, up_b}) < 0) return 1;
    return no_edge;
}

} // namespace

// Segments along a Morton curve, split where its highest bit changes.
SegmentTree::SegmentTree(const NearMesh& mesh) {
    const std::size_t n = mesh.segment.size();
    if (n == 0) return;
    Vec3 lo = mesh.x[0], hi = lo;
    for (const Vec3& p : mesh.x)
        lo = lower(lo, p), hi = upper(hi, p);
    for (const double v : {lo.x, lo.y, lo.z, hi.x, hi.y, hi.z})
        magnitude_ = std::max(magnitude_, std::abs(v));
    const double longest = std::max({hi.x - lo.x, hi.y - lo.y, hi.z - lo.z});
    const double scale = longest > 0 ? 1023 / longest : 0;
    const auto step = [&](double at, double from) {
        return spread(static_cast<uint32_t>((at - from) * scale));
    };
    std::vector<uint32_t> key(n);
    for (uint32_t s = 0; s < n; ++s) {
        const Vec3 middle = 0.5 * (mesh.x[mesh.segment[s][0]] + mesh.x[mesh.segment[s][2]]);
        key[s] = step(middle.x, lo.x) | step(middle.y, lo.y) << 1 | step(middle.z, lo.z) << 2;
    }
    order_ = radix_order(std::span<const uint32_t>(key));
    box_.reserve(2 * (n / (leaf_size / 2) + 1));
    build(mesh, 0, static_cast<uint32_t>(n), key);
}

void SegmentTree::build(const NearMesh& mesh, uint32_t begin, uint32_t end,
                        const std::vector<uint32_t>& key) {
    const std::size_t self = box_.size();
    box_.push_back({{}, {}, begin, end, 0});
    if (end - begin <= leaf_size) {
        Vec3 lo = mesh.x[mesh.segment[order_[begin]][0]], hi = lo;
        for (uint32_t k = begin; k < end; ++k)
            for (const uint32_t node : mesh.segment[order_[k]]) {
                lo = lower(lo, mesh.x[node]);
                hi = upper(hi, mesh.x[node]);
            }
        box_[self].lo = lo, box_[self].hi = hi;
        return;
    }
    uint32_t middle = begin + (end - begin) / 2;
    if (const uint32_t changes = key[order_[begin]] ^ key[order_[end - 1]]; changes != 0) {
        const uint32_t bit = std::bit_floor(changes);
        middle = static_cast<uint32_t>(std::partition_point(order_.begin() + begin, order_.begin() + end,
                                                            [&](uint32_t s) { return (key[s] & bit) == 0; }) -
                                       order_.begin());
    }
    build(mesh, begin, middle, key);
    const std::size_t right = box_.size();
    build(mesh, middle, end, key);
    box_[self].right = static_cast<uint32_t>(right);
    box_[self].lo = lower(box_[self + 1].lo, box_[right].lo);
    box_[self].hi = upper(box_[self + 1].hi, box_[right].hi);
}

namespace {

/// Nodes around which every edge that leaves them in one segment comes back in another: hashes of the nodes
/// after and before them cancel, by chance at one node in 2^64.
std::vector<uint8_t> closed_nodes(const NearMesh& mesh) {
    std::vector<uint64_t> sum(mesh.x.size(), 0), own(mesh.x.size());
    for (uint32_t i = 0; i < own.size(); ++i)
        own[i] = node_hash(i);
    for (const SegmentNodes& n : mesh.segment) {
        const uint64_t h0 = own[n[0]], h1 = own[n[1]], h2 = own[n[2]], h3 = own[n[3]];
        const uint64_t last = is_triangle(n) ? h2 : h3;
        sum[n[0]] += h1 - last;
        sum[n[1]] += h2 - h0;
        sum[n[2]] += (is_triangle(n) ? h0 : h3) - h1;
        if (!is_triangle(n)) sum[n[3]] += h0 - h2;
    }
    std::vector<uint8_t> out(sum.size());
    for (uint32_t i = 0; i < out.size(); ++i)
        out[i] = sum[i] == 0 && mesh.is_complete(i) && !mesh.segments_around(i).empty();
    return out;
}

/// Normals at the corners, not of unit length: at every place of a bilinear segment the normal is a sum of
/// them with weights that are not negative.
std::array<Vec3, 4> corner_normals(const Corners& c) {
    const Vec3 ab = c[1] - c[0], bc = c[2] - c[1], cd = c[3] - c[2], da = c[0] - c[3];
    if (is_triangle(c)) {
        const Vec3 n = cross(ab, bc);
        return {n, n, n, n};
    }
    return {cross(da, ab), cross(ab, bc), cross(bc, cd), cross(cd, da)};
}

} // namespace

// Let every normal around a node be within an angle t < 90 degrees of the axis, and the surface go on in
// every direction. Away from the foot in the direction h across the axis it then rises at an angle u with |u|
// <= t; for a point at an angle p from the axis, towards h, that is downhill when sin(p + u) > 0: always for
// p > t.
NormalCone::NormalCone(const NearMesh& mesh, const SegmentTree& tree) {
    constexpr double narrowest = 0.5, rounding = 1e-6;
    Vec3 sum;
    for (uint32_t s = 0; s < mesh.segment.size(); s += 8) // any axis is one; this is a good one
        sum += area_vector(mesh.corners(s));
    axis_ = unit(sum);
    if (!(squared_norm(axis_) > 0)) return;
    double least = 1; // cosine, squared
    for (uint32_t s = 0; s < mesh.segment.size(); ++s)
        for (const Vec3& n : corner_normals(mesh.corners(s))) {
            const double along = dot(n, axis_), squared = squared_norm(n);
            if (along > 0 && along * along >= least * squared) continue;
            if (!(along > 0) || !(along * along >= narrowest * narrowest * squared)) return;
            least = along * along / squared;
        }
    const std::vector<uint8_t> node_closed = closed_nodes(mesh);
    closed_.resize(tree.box_.size());
    for (std::size_t b = closed_.size(); b-- > 0;) {
        const SegmentTree::Box& box = tree.box_[b];
        if (box.right != 0) {
            closed_[b] = closed_[b + 1] & closed_[box.right];
            continue;
        }
        closed_[b] = 1;
        for (uint32_t k = box.begin; k < box.end; ++k)
            for (const uint32_t node : mesh.segment[tree.order_[k]])
                closed_[b] &= node_closed[node];
    }
    cos_ = std::sqrt(least) - rounding;
    sin_ = std::sqrt(1 - cos_ * cos_);
}

ClosestSegment::ClosestSegment(const NearMesh& mesh)
    : ClosestSegment(mesh, std::make_shared<const SegmentTree>(mesh)) {}

ClosestSegment::ClosestSegment(const NearMesh& mesh, std::shared_ptr<const SegmentTree> tree)
    : mesh_(mesh), tree_(std::move(tree)) {}

/// Distances closer to each other than this are equal but for rounding.
double ClosestSegment::tie(Vec3 x) const {
    return 16 * std::numeric_limits<double>::epsilon() *
           std::max({tree_->magnitude_, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
}

template <class Visit>
void ClosestSegment::visit_within(Vec3 x, const double& radius, Visit&& visit, const NormalCone* cone) const {
    struct Pending {
        uint32_t box;
        double squared; ///< distance
    };
    const std::vector<SegmentTree::Box>& boxes = tree_->box_;
    const std::vector<uint32_t>& order = tree_->order_;
    const auto pending = [&](uint32_t box) {
        return Pending{box, squared_distance_to_box(boxes[box].lo, boxes[box].hi, x)};
    };
    std::array<Pending, 80> stack;
    std::size_t depth = 0;
    if (!boxes.empty()) stack[depth++] = pending(0);
    while (depth > 0) {
        const Pending top = stack[--depth];
        if (top.squared > radius * radius) continue;
        const SegmentTree::Box& box = boxes[top.box];
        if (cone && cone->closed_[top.box] != 0) {
            const Vec3 half = 0.5 * (box.hi - box.lo), away = box.lo + half - x;
            const double along = dot(away, cone->axis_);
            const double aside = norm(away - along * cone->axis_);
            if (aside * cone->cos_ - std::abs(along) * cone->sin_ > norm(half) + tie(x)) continue;
        }
        if (box.right == 0) {
            for (uint32_t k = box.begin; k < box.end; ++k)
                if (squared_distance_to_box(mesh_.corners(order[k]), x) <= radius * radius) visit(order[k]);
            continue;
        }
        const Pending left = pending(top.box + 1), right = pending(box.right);
        stack[depth++] = left.squared <= right.squared ? right : left;
        stack[depth++] = left.squared <= right.squared ? left : right;
    }
}

/// Segments that may still be within a tie of the closest.
struct ClosestSegment::Candidates {
    struct One {
        uint32_t segment;
        double distance;
        bool inside;
    };
    std::array<One, 16> first; ///< more than these are rare
    std::vector<One> rest;
    std::size_t count = 0;
    double equal = 0, closest = infinity, radius = infinity;
    Foot foot; ///< of the closest; whether its normal and place are known depends on where it lies

    explicit Candidates(double tie) : equal(tie) {}
    void add(uint32_t segment, const Foot& at) {
        if (at.distance > radius) return;
        if (at.distance < closest) {
            if (at.distance + equal < closest) count = 0, rest.clear();
            closest = at.distance;
            radius = closest + equal;
            foot = at;
        }
        const One one{segment, at.distance, at.inside()};
        if (count < first.size())
            first[count++] = one;
        else
            rest.push_back(one);
    }
    /// A foot inside a segment wins over one on an edge, then the smallest storage index.
    const One* best() const {
        const One* best = nullptr;
        const auto compare = [&](const One& c) {
            if (c.distance > radius) return;
            if (!best || (c.inside != best->inside ? c.inside : c.segment < best->segment)) best = &c;
        };
        std::for_each(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(count), compare);
        std::for_each(rest.begin(), rest.end(), compare);
        return best;
    }
};

ClosestHit ClosestSegment::best_of(Vec3 x, const Candidates& candidates, bool covered) const {
    const Candidates::One* best = candidates.best();
    if (!best) {
        ClosestHit none;
        none.exact = mesh_.cells.empty();
        return none;
    }
    const bool known = candidates.count == 1 && candidates.foot.normal != Vec3{};
    ClosestHit hit =
        complete(x, best->segment, known ? candidates.foot : closest_point(mesh_.corners(best->segment), x));
    const Vec3 r{candidates.radius, candidates.radius, candidates.radius};
    hit.exact = covered || mesh_.covers(x - r, x + r);
    return hit;
}

ClosestHit ClosestSegment::find(Vec3 x) const {
    Candidates candidates(tie(x));
    visit_within(x, candidates.radius,
                 [&](uint32_t s) { candidates.add(s, closest_foot(mesh_.corners(s), x)); });
    return best_of(x, candidates, false);
}

/// Collects what is near x: about a third of a segment farther than the closest one.
void ClosestSegment::follow(Vec3 x, ClosestTrack& track) const {
    track.near_.clear();
    track.way_ = 0;
    track.at_ = x;
    track.reach_ = -1;
    double closest = infinity, radius = infinity;
    visit_within(x, radius, [&](uint32_t s) {
        const double distance = closest_foot(mesh_.corners(s), x).distance;
        if (distance > radius) return;
        track.near_.push_back({s, distance});
        if (distance >= closest) return;
        closest = distance;
        radius = std::min(radius, closest + std::sqrt(area(mesh_.corners(s))) / 3);
        std::swap(track.near_.front(), track.near_.back());
    });
    if (!(radius < infinity)) return;
    std::erase_if(track.near_, [&](const ClosestTrack::Near& n) { return n.farther > radius; });
    track.reach_ = radius;
    const Vec3 r{radius, radius, radius};
    track.covered_ = mesh_.covers(x - r, x + r);
}

// A distance changes by no more than the way gone: segments that were farther by more than that from the
// closest one cannot have come closer. Rounding is far below `equal`, twice of which is added to each step.
ClosestHit ClosestSegment::find(Vec3 x, ClosestTrack& track) const {
    const double equal = tie(x);
    for (int attempt = 0; attempt < 2; ++attempt) {
        if (track.reach_ >= 0) {
            track.way_ += distance(x, track.at_) + 2 * equal;
            track.at_ = x;
            Candidates candidates(equal);
            std::size_t first = 0;
            for (std::size_t k = 0; k < track.near_.size(); ++k) {
                ClosestTrack::Near& n = track.near_[k];
                if (n.farther - track.way_ > candidates.radius) continue;
                const Foot foot = closest_foot(mesh_.corners(n.segment), x);
                n.farther = foot.distance + track.way_;
                if (foot.distance < candidates.closest) first = k;
                candidates.add(n.segment, foot);
            }
            if (candidates.radius < track.reach_ - track.way_) {
                std::swap(track.near_[0], track.near_[first]);
                return best_of(x, candidates, track.covered_);
            }
        }
        if (attempt == 0) follow(x, track);
    }
    return find(x);
}

ClosestHit ClosestSegment::complete(Vec3 x, uint32_t segment, const Foot& foot) const {
    ClosestHit hit;
    hit.segment = segment;
    hit.foot = foot;
    const Vec3 away = x - foot.point;
    const double along = dot(foot.normal, away);
    hit.d = along < 0 ? -foot.distance : foot.distance;
    const SegmentNodes& n = mesh_.segment[segment];
    const FootNodes at = nodes_at(n, foot);
    hit.on_free_edge = at.count == 1   ? on_outline(mesh_, at.node[0])
                       : at.count == 2 ? is_free_edge(mesh_, at.node[0], at.node[1])
                                       : false;
    if (hit.on_free_edge) {
        const double size = std::sqrt(area(mesh_.corners(segment)));
        const double aside = norm(away - along * foot.normal);
        hit.offset = size > 0 ? aside / size : aside > 0 ? infinity : 0;
    }
    return hit;
}

/// Inside a segment it is one. On an edge or at a node it is one when no segment that shares the foot comes
/// closer.
bool ClosestSegment::is_local_minimum(Vec3 x, uint32_t segment, const Foot& foot) const {
    const FootNodes at = nodes_at(mesh_.segment[segment], foot);
    if (at.count == 0) return true;
    const double equal = tie(x);
    const double closer = foot.distance - equal;
    for (const uint32_t s : mesh_.segments_around(at.node[0])) {
        if (s == segment || (at.count == 2 && !holds(mesh_.segment[s], at.node[1]))) continue;
        if (closer > 0 && squared_bound_from(mesh_, mesh_.segment[s], at, foot.point, x) < closer * closer)
            return false;
    }
    for (const uint32_t s : mesh_.segments_around(at.node[0])) {
        if (s == segment || (at.count == 2 && !holds(mesh_.segment[s], at.node[1]))) continue;
        if (closest_foot(mesh_.corners(s), x).distance < foot.distance - equal) return false;
    }
    return true;
}

/// Most segments near a point that are not the closest lie beside it: they come closest at an edge, and
/// across that edge it goes on downhill. Seen here without a closest point.
bool ClosestSegment::leads_on(Vec3 x, uint32_t segment, double radius) const {
    const SegmentNodes& n = mesh_.segment[segment];
    const std::size_t edge = edge_downhill(mesh_.corners(segment), x);
    if (edge == no_edge) return false;
    const FootNodes at{edge_nodes(n, edge), 2};
    const Vec3 from = mesh_.x[at.node[0]], along = mesh_.x[at.node[1]] - from, away = x - from;
    const double squared_length = squared_norm(along);
    if (!(squared_length > 0)) return false;
    const Vec3 foot = from + std::clamp(dot(away, along) / squared_length, 0.0, 1.0) * along;
    const double distance = norm(x - foot), closer = distance - tie(x);
    if (closer > radius) return true;
    if (!(closer > 0)) return false;
    for (const uint32_t s : mesh_.segments_around(at.node[0]))
        if (s != segment && holds(mesh_.segment[s], at.node[1]) &&
            squared_bound_from(mesh_, mesh_.segment[s], at, foot, x) < closer * closer)
            return true;
    return false;
}

std::optional<ClosestHit> ClosestSegment::other_layer(Vec3 x, const ClosestHit& nearest, double within,
                                                      const NormalCone* cone) const {
    if (!nearest.found()) return {};
    const SegmentNodes& own = mesh_.segment[nearest.segment];
    uint32_t best = no_segment;
    double closest = within, radius = within; // with room for a segment at the same distance
    const auto visit = [&](uint32_t s) {
        const SegmentNodes& n = mesh_.segment[s];
        if (std::any_of(n.begin(), n.end(), [&](uint32_t node) { return holds(own, node); })) return;
        if (leads_on(x, s, radius)) return;
        const Foot foot = closest_foot(mesh_.corners(s), x);
        if (foot.distance > closest || (foot.distance == closest && best != no_segment && s > best)) return;
        if (!is_local_minimum(x, s, foot)) return;
        best = s;
        closest = foot.distance;
        radius = closest + tie(x);
    };
    visit_within(x, radius, visit, cone && cone->cos_ > 0 ? cone : nullptr);
    if (best == no_segment) return {};
    return complete(x, best, closest_point(mesh_.corners(best), x));
}

NearMesh mesh_for_closest(const SegmentMesh& mesh, std::span<const Vec3> points, double travel,
                          unsigned threads) {
    double reach = first_reach(mesh) + 2 * travel;
    while (true) {
        NearMesh part = near_mesh(mesh, points, reach, threads);
        if (part.cells.empty()) return part;
        const ClosestSegment closest(part);
        double farthest = 0;
        bool exact = true;
        for (const Vec3& p : points) {
            const ClosestHit hit = closest.find(p);
            exact = exact && hit.exact && hit.found();
            farthest = std::max(farthest, hit.found() ? hit.foot.distance : 0);
        }
        // The distance changes by no more than the way gone: a ball around the moved point.
        const double needed = 2 * travel + farthest * (1 + 1e-9);
        if (exact && needed <= reach) return part;
        const bool known = exact || (needed > reach && needed < 2 * reach);
        reach = next_reach(part, points, known ? needed : 2 * reach);
    }
}

} // namespace drawbead
