#include "rules/srf/bead_side.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drawbead {

namespace {

constexpr uint32_t none = 0xffffffffu;

Vec3 lower(Vec3 a, Vec3 b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3 upper(Vec3 a, Vec3 b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// The line of feet in a grid of boxes, so that a point meets only the hops near it.
class LineGrid {
public:
    struct Near {
        double distance = std::numeric_limits<double>::infinity();
        uint32_t hop = none;
        double along = 0; ///< 0 at the hop's first foot, 1 at its second
    };

    LineGrid(std::span<const BeadFoot> feet, std::span<const std::pair<uint32_t, uint32_t>> hops,
             double reach)
        : feet_(feet), hops_(hops) {
        double largest = 0;
        for (const BeadFoot& f : feet) {
            min_ = lower(min_, f.foot);
            max_ = upper(max_, f.foot);
            largest = std::max(largest, f.element);
        }
        const double margin = reach * largest;
        min_ = min_ - Vec3{margin, margin, margin};
        max_ = max_ + Vec3{margin, margin, margin};
        cell_ = std::max(margin, std::numeric_limits<double>::min());
        const Vec3 extent = max_ - min_;
        const auto cells = [&](double e) { return std::max(1.0, std::ceil(e / cell_)); };
        constexpr double most_cells = 1 << 20;
        while (cells(extent.x) * cells(extent.y) * cells(extent.z) > most_cells)
            cell_ *= 1.5;
        count_ = {static_cast<uint32_t>(cells(extent.x)), static_cast<uint32_t>(cells(extent.y)),
                  static_cast<uint32_t>(cells(extent.z))};
        line_.reserve(hops.size());
        for (const auto& [a, b] : hops) {
            const Vec3 from = feet[a].foot, along = feet[b].foot - from;
            const double squared = squared_norm(along);
            line_.push_back({from, along, squared > 0 ? 1 / squared : 0,
                             reach * std::max(feet[a].element, feet[b].element)});
        }

        begin_.assign(std::size_t{count_[0]} * count_[1] * count_[2] + 1, 0);
        for (uint32_t h = 0; h < hops.size(); ++h)
            for_cells(h, [&](std::size_t cell) { ++begin_[cell + 1]; });
        for (std::size_t c = 1; c < begin_.size(); ++c)
            begin_[c] += begin_[c - 1];
        hop_.resize(begin_.back());
        std::vector<uint32_t> next(begin_.begin(), begin_.end() - 1);
        for (uint32_t h = 0; h < hops.size(); ++h)
            for_cells(h, [&](std::size_t cell) { hop_[next[cell]++] = h; });
    }

    /// Whether the point is anywhere near the line; without a branch, as most are not.
    bool is_around(Vec3 x) const {
        return (int{x.x >= min_.x} & int{x.y >= min_.y} & int{x.z >= min_.z} & int{x.x <= max_.x} &
                int{x.y <= max_.y} & int{x.z <= max_.z}) != 0;
    }
    /// The closest hop whose reach the point is in, if any.
    Near find(Vec3 x) const {
        Near best;
        if (!is_around(x)) return best;
        const auto c = cell_of(x);
        const std::size_t cell = (std::size_t{c[2]} * count_[1] + c[1]) * count_[0] + c[0];
        double squared = std::numeric_limits<double>::infinity();
        for (uint32_t i = begin_[cell]; i < begin_[cell + 1]; ++i) {
            const Line& line = line_[hop_[i]];
            const Vec3 away = x - line.from;
            const double along = std::min(std::max(0.0, dot(away, line.along) * line.per_squared), 1.0);
            const double one = squared_norm(away - along * line.along);
            if (one >= squared || one > line.reach * line.reach) continue;
            squared = one;
            best.hop = hop_[i];
            best.along = along;
        }
        best.distance = std::sqrt(squared);
        return best;
    }

private:
    std::span<const BeadFoot> feet_;
    std::span<const std::pair<uint32_t, uint32_t>> hops_;
    static constexpr double inf = std::numeric_limits<double>::infinity();
    Vec3 min_{inf, inf, inf}, max_{-inf, -inf, -inf};
    double cell_ = 1;
    std::array<uint32_t, 3> count_{};
    struct Line {
        Vec3 from, along;
        double per_squared, reach; ///< 1 over the squared length; 0 for no length
    };
    std::vector<Line> line_; ///< by hop
    std::vector<uint32_t> begin_, hop_;

    std::array<uint32_t, 3> cell_of(Vec3 x) const {
        const auto one = [&](double v, uint32_t n) {
            const double c = v / cell_;
            return c > 0 ? std::min(static_cast<uint32_t>(std::min(c, 4e9)), n - 1) : 0u;
        };
        return {one(x.x - min_.x, count_[0]), one(x.y - min_.y, count_[1]), one(x.z - min_.z, count_[2])};
    }

    template <class Visit>
    void for_cells(uint32_t hop, Visit&& visit) const {
        const Vec3 a = feet_[hops_[hop].first].foot, b = feet_[hops_[hop].second].foot;
        const double r = line_[hop].reach;
        const auto lo = cell_of(lower(a, b) - Vec3{r, r, r}), hi = cell_of(upper(a, b) + Vec3{r, r, r});
        for (uint32_t z = lo[2]; z <= hi[2]; ++z)
            for (uint32_t y = lo[1]; y <= hi[1]; ++y)
                for (uint32_t x = lo[0]; x <= hi[0]; ++x)
                    visit((std::size_t{z} * count_[1] + y) * count_[0] + x);
    }
};

/// What lies across an edge of a segment, when exactly one other segment does.
struct Across {
    uint32_t segment = none;
    bool agrees = false; ///< runs along the edge the other way
};

/// How a segment runs along the edge from a to b: whether it has it from a to b, and from b to a.
struct Runs {
    bool forward = false, back = false;
};

Runs runs_along(const SegmentNodes& n, uint32_t a, uint32_t b) {
    Runs out;
    for (std::size_t k = 0; k < 4; ++k) {
        out.forward |= n[k] == a && n[(k + 1) % 4] == b;
        out.back |= n[k] == b && n[(k + 1) % 4] == a;
    }
    return out;
}

/// Across edge k, of two segments to the first of them; none when that is this one.
Across across(const NearMesh& mesh, uint32_t segment, std::size_t k) {
    const SegmentNodes& s = mesh.segment[segment];
    const uint32_t a = s[k], b = s[(k + 1) % 4];
    const auto around = mesh.segments_around(a); // ascending
    if (a == b || around.back() <= segment) return {};
    if (a == s[(k + 2) % 4] || b == s[(k + 3) % 4]) return {}; // along it and back
    // Mostly one other has both nodes: it is found without a branch per segment.
    uint32_t other = none, count = 0;
    for (const uint32_t one : around) {
        const SegmentNodes& n = mesh.segment[one];
        const bool has = (int{n[0] == b} | int{n[1] == b} | int{n[2] == b} | int{n[3] == b}) != 0;
        other = has && one != segment ? one : other;
        count += has;
    }
    if (count < 2 || other < segment) return {};
    if (count == 2) {
        const Runs runs = runs_along(mesh.segment[other], a, b);
        return runs.forward == runs.back ? Across{} : Across{other, runs.back};
    }
    Across out;
    for (const uint32_t one : mesh.segments_around(a)) {
        const Runs runs = runs_along(mesh.segment[one], a, b);
        if (one == segment || (!runs.forward && !runs.back)) continue;
        if (out.segment != none || (runs.forward && runs.back)) return {};
        out = {one, runs.back};
    }
    return out.segment > segment ? out : Across{};
}

/// Disjoint sets with the smallest member as the root, so that numbers do not depend on the order of joining.
class Sets {
public:
    explicit Sets(std::size_t n) : parent_(n) {
        for (std::size_t i = 0; i < n; ++i)
            parent_[i] = static_cast<uint32_t>(i);
    }
    uint32_t root(uint32_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(uint32_t a, uint32_t b) {
        a = root(a), b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<uint32_t> parent_;
};

struct Patch {
    double toward = 0, away = 0; ///< distances of its bead nodes, by side
    bool seen_toward = false, seen_away = false;
    Facing facing = Facing::unknown;
    std::vector<uint32_t> clashes; ///< patches across an edge
};

constexpr Facing opposite(Facing f) {
    return f == Facing::toward ? Facing::away : f == Facing::away ? Facing::toward : Facing::unknown;
}

/// Judged patches hand their side on to those that they clash with.
void spread(std::vector<Patch>& patches, std::vector<uint32_t> front) {
    for (std::size_t i = 0; i < front.size(); ++i)
        for (const uint32_t next : patches[front[i]].clashes)
            if (patches[next].facing == Facing::unknown) {
                patches[next].facing = opposite(patches[front[i]].facing);
                front.push_back(next);
            }
}

} // namespace

uint64_t BeadSide::count(Facing facing) const {
    return static_cast<uint64_t>(
        std::count_if(zone.begin(), zone.end(), [&](const ZoneSegment& z) { return z.facing == facing; }));
}

BeadSide judge_side(const NearMesh& mesh, std::span<const BeadFoot> feet,
                    std::span<const std::pair<uint32_t, uint32_t>> hops,
                    std::span<const uint8_t> solid_backed, const SideLimits& limits) {
    BeadSide out;
    if (feet.empty()) return out;
    std::vector<std::pair<uint32_t, uint32_t>> all_hops(hops.begin(), hops.end());
    std::vector<bool> in_hop(feet.size(), false);
    for (const auto& [a, b] : hops)
        in_hop[a] = in_hop[b] = true;
    for (uint32_t i = 0; i < feet.size(); ++i) // so that a foot without hops has a zone, too
        if (!in_hop[i]) all_hops.emplace_back(i, i);
    const LineGrid line(feet, all_hops, limits.reach);

    // The zone: start segments and every segment with a node in reach.
    std::vector<uint8_t> starts(mesh.segment.size(), 0);
    for (const BeadFoot& f : feet)
        starts[f.segment] = 1;
    std::vector<uint32_t> place_of(mesh.x.size(), none); // of a node in `near`
    std::vector<LineGrid::Near> near;
    for (std::size_t n = 0; n < mesh.x.size(); ++n) {
        const LineGrid::Near one = line.find(mesh.x[n]);
        if (one.hop == none) continue;
        place_of[n] = static_cast<uint32_t>(near.size());
        near.push_back(one);
    }
    std::vector<uint32_t> place(mesh.segment.size(), none);
    std::vector<LineGrid::Near> nearest;
    for (uint32_t s = 0; s < mesh.segment.size(); ++s) {
        const SegmentNodes& nodes = mesh.segment[s];
        // All bits are set only where no node has a place.
        const uint32_t places =
            place_of[nodes[0]] & place_of[nodes[1]] & place_of[nodes[2]] & place_of[nodes[3]];
        if (places == none && starts[s] == 0) continue;
        LineGrid::Near best;
        for (const uint32_t n : nodes)
            if (place_of[n] != none && near[place_of[n]].distance < best.distance) best = near[place_of[n]];
        place[s] = static_cast<uint32_t>(out.zone.size());
        out.zone.push_back({s, Facing::unknown, starts[s] != 0, starts[s] ? 0 : best.distance, 0});
        nearest.push_back(best);
    }

    // Patches of one orientation, numbered by their first segment; and where they clash.
    Sets sets(out.zone.size());
    std::vector<std::pair<uint32_t, uint32_t>> clashes;
    for (uint32_t i = 0; i < out.zone.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k) {
            const Across other = across(mesh, out.zone[i].segment, k);
            if (other.segment == none || place[other.segment] == none) continue;
            if (other.agrees) {
                sets.join(i, place[other.segment]);
            } else {
                clashes.emplace_back(i, place[other.segment]);
                clashes.emplace_back(place[other.segment], i);
            }
        }
    std::sort(clashes.begin(), clashes.end());
    std::vector<Patch> patches;
    std::vector<uint32_t> patch_of(out.zone.size());
    for (uint32_t i = 0; i < out.zone.size(); ++i) {
        const uint32_t root = sets.root(i);
        if (root == i) {
            patch_of[i] = static_cast<uint32_t>(patches.size());
            patches.emplace_back();
        } else {
            patch_of[i] = patch_of[root];
        }
    }
    for (const auto& [a, b] : clashes)
        if (patch_of[a] != patch_of[b]) patches[patch_of[a]].clashes.push_back(patch_of[b]);
    out.patches = static_cast<uint32_t>(patches.size());

    // The bead's own nodes first.
    for (const BeadFoot& f : feet) {
        const bool decides = !f.beside && !f.turned && std::abs(f.d) > limits.in_surface * f.element;
        out.decides.push_back(decides);
        if (!decides) continue;
        Patch& patch = patches[patch_of[place[f.segment]]];
        (f.d > 0 ? patch.toward : patch.away) += std::abs(f.d);
    }
    std::vector<uint32_t> judged;
    const auto judge = [&](uint32_t p, double toward, double away) {
        if (std::min(toward, away) > limits.minority * (toward + away) || toward == away) return;
        patches[p].facing = toward > away ? Facing::toward : Facing::away;
        judged.push_back(p);
    };
    for (uint32_t p = 0; p < patches.size(); ++p)
        judge(p, patches[p].toward, patches[p].away);
    spread(patches, judged);

    // Then what no judged patch touches, as its segments see the bead. Unless no node of the bead decides
    // anything.
    if (!judged.empty()) {
        constexpr double clearly = 0.2; // sine of the angle over the segment's plane
        for (uint32_t i = 0; i < out.zone.size(); ++i) {
            Patch& patch = patches[patch_of[i]];
            if (patch.facing != Facing::unknown || nearest[i].hop == none) continue;
            if (patch.toward > 0 || patch.away > 0) continue;
            if (!solid_backed.empty() && solid_backed[out.zone[i].segment] != 0) continue;
            const auto [a, b] = all_hops[nearest[i].hop];
            const double along = nearest[i].along;
            const Vec3 bead = feet[a].bead + along * (feet[b].bead - feet[a].bead);
            const Corners c = mesh.corners(out.zone[i].segment);
            const Vec3 to_bead = bead - centroid(c), normal = area_vector(c);
            const double sine = dot(normal, to_bead) / (norm(normal) * norm(to_bead));
            if (sine > clearly) patch.seen_toward = true;
            if (sine < -clearly) patch.seen_away = true;
        }
        judged.clear();
        for (uint32_t p = 0; p < patches.size(); ++p)
            if (patches[p].seen_toward != patches[p].seen_away && patches[p].facing == Facing::unknown) {
                patches[p].facing = patches[p].seen_toward ? Facing::toward : Facing::away;
                judged.push_back(p);
            }
        spread(patches, judged);
    }

    for (uint32_t i = 0; i < out.zone.size(); ++i) {
        ZoneSegment& z = out.zone[i];
        z.facing = patches[patch_of[i]].facing;
        if (nearest[i].hop == none) continue;
        const auto [a, b] = all_hops[nearest[i].hop];
        const double gap = std::abs(feet[nearest[i].along > 0.5 ? b : a].d);
        z.d = z.facing == Facing::away ? -gap : gap;
    }
    for (const BeadFoot& f : feet)
        out.node.push_back(out.zone[place[f.segment]].facing);
    return out;
}

} // namespace drawbead
