#include "study/reference.h"

#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

namespace drawbead {

namespace {

using R = long double;
using V = BasicVec3<long double>;
constexpr R infinity = std::numeric_limits<R>::infinity();
constexpr int most_halvings = 4; // of half a hop

V wide(Vec3 v) {
    return {v.x, v.y, v.z};
}

/// A table of time, integrated exactly.
class Line {
public:
    explicit Line(const TimeTable& table) {
        for (std::size_t i = 0; i < table.times().size(); ++i) {
            t_.push_back(table.times()[i]);
            y_.push_back(table.values()[i]);
        }
        sum_.assign(t_.size(), 0);
        for (std::size_t i = 1; i < t_.size(); ++i)
            sum_[i] = sum_[i - 1] + (y_[i] + y_[i - 1]) / 2 * (t_[i] - t_[i - 1]);
    }
    R value(R t, R inside) const {
        if (t_.size() < 2) return y_[0];
        const std::size_t i = piece(inside);
        return ((t_[i + 1] - t) * y_[i] + (t - t_[i]) * y_[i + 1]) / (t_[i + 1] - t_[i]);
    }
    R slope(R inside) const {
        if (t_.size() < 2) return 0;
        const std::size_t i = piece(inside);
        return (y_[i + 1] - y_[i]) / (t_[i + 1] - t_[i]);
    }
    R integral(R t) const { // from 0
        return primitive(t) - primitive(0);
    }

private:
    std::vector<R> t_, y_, sum_;
    std::size_t piece(R t) const {
        std::size_t i = 0;
        while (i + 2 < t_.size() && t >= t_[i + 1])
            ++i;
        return i;
    }
    R primitive(R t) const {
        if (t_.size() < 2) return y_[0] * t;
        const std::size_t i = piece(t);
        const R gone = t - t_[i];
        return sum_[i] + gone * y_[i] + gone * gone / 2 * slope(t);
    }
};

/// One motion in extended precision.
struct Moved {
    std::array<V, 3> column{V{1, 0, 0}, V{0, 1, 0}, V{0, 0, 1}}; ///< images of the axes
    V origin, about, axis;
    V speed;    ///< of the translation
    R spin = 0; ///< about `axis` through `about` + translation
    V gone;     ///< the translation
    bool turns = false;

    V turn(V v) const { return turns ? v.x * column[0] + v.y * column[1] + v.z * column[2] : v; }
    V turn_back(V v) const { return turns ? V{dot(column[0], v), dot(column[1], v), dot(column[2], v)} : v; }
    V at(V x) const { return turns ? about + gone + turn(x - about) : x + gone; }
    V back(V y) const { return turns ? about + turn_back(y - gone - about) : y - gone; }
    V velocity(V y) const { return turns ? speed + spin * cross(axis, y - gone - about) : speed; }
};

class Path {
public:
    explicit Path(const Motion& motion) : motion_(motion) {
        for (const Motion::Term& term : motion.terms)
            lines_.emplace_back(term.table);
        if (motion.turn) angle_ = std::make_unique<Line>(motion.turn->angle);
    }
    /// Velocities from the side on which `inside` lies.
    Moved at(R t, R inside) const {
        Moved m;
        std::array<R, 3> gone{}, speed{};
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const Motion::Term& term = motion_.terms[i];
            const R stretch = term.time_scale, scale = term.scale;
            if (term.velocity) {
                gone[term.axis] += scale * stretch * lines_[i].integral(t / stretch);
                speed[term.axis] += scale * lines_[i].value(t / stretch, inside / stretch);
            } else {
                gone[term.axis] += scale * lines_[i].value(t / stretch, t / stretch);
                speed[term.axis] += scale / stretch * lines_[i].slope(inside / stretch);
            }
        }
        m.gone = {gone[0], gone[1], gone[2]};
        m.speed = {speed[0], speed[1], speed[2]};
        if (!angle_) return m;
        m.turns = true;
        m.about = wide(motion_.turn->about);
        m.axis = wide(motion_.turn->axis);
        m.axis = m.axis / std::sqrt(dot(m.axis, m.axis));
        m.spin = angle_->slope(inside);
        const R a = angle_->value(t, t), half = a / 2;
        // By a quaternion.
        const R w = std::cos(half);
        const V p = std::sin(half) * m.axis;
        for (V& c : m.column)
            c = c + 2 * cross(p, cross(p, c) + w * c);
        return m;
    }

private:
    const Motion& motion_;
    std::vector<Line> lines_;
    std::unique_ptr<Line> angle_;
};

using Quad = std::array<V, 4>;

/// Closest point of a segment: where, how far, and what of the outline it lies on.
struct Near {
    V point;
    R xi = 0, eta = 0, squared = infinity;
    int edge = -1;   ///< −1: inside
    int corner = -1; ///< at an end of the edge
};

void along_edges(const Quad& c, bool triangle, V x, Near& best) {
    static constexpr std::array<std::array<R, 2>, 4> place{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (int k = 0; k < 4; ++k) {
        if (triangle && k == 2) continue;
        const auto a = static_cast<std::size_t>(k), b = static_cast<std::size_t>((k + 1) % 4);
        const V edge = c[b] - c[a];
        const R length = dot(edge, edge);
        R t = length > 0 ? dot(x - c[a], edge) / length : 0;
        t = t < 0 ? 0 : t > 1 ? 1 : t;
        const V point = c[a] + t * edge;
        const R squared = dot(x - point, x - point);
        if (squared < best.squared) {
            best = {point,
                    place[a][0] + t * (place[b][0] - place[a][0]),
                    place[a][1] + t * (place[b][1] - place[a][1]),
                    squared,
                    k,
                    -1};
            if (t == 0) best.corner = k;
            if (t == 1) best.corner = static_cast<int>(b);
        }
    }
}

struct Bilinear {
    V m, a, b, e;
    explicit Bilinear(const Quad& c)
        : m((c[0] + c[1] + c[2] + c[3]) / 4), a((c[1] + c[2] - c[0] - c[3]) / 4),
          b((c[2] + c[3] - c[0] - c[1]) / 4), e((c[0] + c[2] - c[1] - c[3]) / 4) {}
    V at(R s, R t) const { return m + s * a + t * b + s * t * e; }
};

/// A stationary point inside, by Newton's method from (s, t).
bool stationary(const Bilinear& q, V x, R s, R t, Near& best) {
    for (int step = 0; step < 40; ++step) {
        const V ds = q.a + t * q.e, dt = q.b + s * q.e, r = q.at(s, t) - x;
        const R f = dot(r, ds), g = dot(r, dt);
        const R fs = dot(ds, ds), gt = dot(dt, dt);
        R mixed = dot(ds, dt) + dot(r, q.e);
        if (fs * gt <= mixed * mixed) mixed = dot(ds, dt); // not a minimum here: by Gauss and Newton
        const R det = fs * gt - mixed * mixed;
        if (!(det > 0)) return false;
        const R u = (f * gt - g * mixed) / det, v = (g * fs - f * mixed) / det;
        s -= u;
        t -= v;
        if (std::abs(s) > 3 || std::abs(t) > 3) return false;
        if (std::abs(u) + std::abs(v) < 1e-17L) break;
    }
    if (std::abs(s) >= 1 || std::abs(t) >= 1) return false;
    const V point = q.at(s, t);
    const R squared = dot(x - point, x - point);
    if (squared < best.squared) best = {point, s, t, squared, -1, -1};
    return true;
}

/// `s`, `t`: where to begin.
Near nearest(const Quad& c, bool triangle, V x, R s, R t) {
    Near best;
    if (triangle) {
        const V p = c[1] - c[0], q = c[2] - c[0], n = cross(p, q), w = x - c[0];
        const R size = dot(n, n);
        if (size > 0) {
            const R second = dot(cross(w, q), n) / size, third = dot(cross(p, w), n) / size;
            if (second > 0 && third > 0 && second + third < 1) {
                const V point = c[0] + second * p + third * q;
                const R eta = 2 * third - 1, xi = (second - (1 - second - third)) / (1 - third);
                return {point, xi, eta, dot(x - point, x - point), -1, -1};
            }
        }
        along_edges(c, true, x, best);
        return best;
    }
    const Bilinear q(c);
    const bool found = stationary(q, x, s, t, best);
    const V n = cross(q.a, q.b);
    const bool flat =
        std::abs(dot(n, q.e)) <= 1e-15L * std::sqrt(dot(n, n) * (dot(q.a, q.a) + dot(q.b, q.b)));
    if (found && flat) return best;
    along_edges(c, false, x, best);
    if (!flat)
        for (const R u : {-0.7L, 0.7L})
            for (const R v : {-0.7L, 0.7L})
                stationary(q, x, u, v, best);
    return best;
}

V normal_at(const Quad& c, bool triangle, R s, R t) {
    V n = cross(c[2] - c[0], c[3] - c[1]);
    if (!triangle) {
        const Bilinear q(c);
        const V ds = q.a + t * q.e, dt = q.b + s * q.e, local = cross(ds, dt);
        if (dot(local, local) > 1e-24L * dot(ds, ds) * dot(dt, dt)) n = local;
    }
    const R size = std::sqrt(dot(n, n));
    return size > 0 ? n / size : V{};
}

/// A point of the line and what it stands for.
struct Spot {
    uint32_t a = 0, b = 0, node = 0;
    R at = 0;
    R part = 0; ///< of the hop; 0: the node itself
};

/// Everything about a spot at one instant, as of the whole node.
struct Look {
    R t = 0;
    uint32_t segment = 0;
    int status = 0;    ///< without contact, on the ramp, on the plateau
    bool held = false; ///< a foot was found
    V n, u, foot;
    R share = 1, ramp = 0, N = 0, limit = 0, k = 0, damper = 0, speed = 0;
    bool restrains = false;

    bool same_kind(const Look& o) const {
        return status == o.status && (status == 0 || segment == o.segment);
    }
};

/// What one spot did.
struct Record {
    std::vector<Vec3> normal, restraint;
    std::vector<double> q;
    R absorbed = 0, stored = 0, gross = 0;
    R first_contact = infinity, first_slip = infinity;
    uint64_t evaluations = 0;
    bool at_a_blow = false;

    void add(const Record& o, double weight) {
        for (std::size_t i = 0; i < q.size(); ++i) {
            normal[i] += weight * o.normal[i];
            restraint[i] += weight * o.restraint[i];
            q[i] += weight * o.q[i];
        }
        absorbed += weight * o.absorbed;
        stored += weight * o.stored;
        gross += weight * o.gross;
        first_contact = std::min(first_contact, o.first_contact);
        first_slip = std::min(first_slip, o.first_slip);
        evaluations += o.evaluations;
        at_a_blow = at_a_blow || o.at_a_blow;
    }
};

Record empty_record(std::size_t times) {
    Record out;
    out.normal.resize(times);
    out.restraint.resize(times);
    out.q.assign(times, 0);
    return out;
}

/// The scene of one bead, shared by all its spots.
class World {
public:
    World(const EvaluationScene& of, std::size_t which, std::span<const double> times, Truth what)
        : scene(of), bead(of.beads[which]), surface(of.surfaces[bead.surface]), truth(what) {
        for (const Motion& motion : scene.motions)
            paths.emplace_back(motion);
        frame = surface.motion.empty() ? 0 : surface.motion.front();
        rigid =
            std::all_of(surface.motion.begin(), surface.motion.end(), [&](uint32_t m) { return m == frame; });
        turning = !rigid || std::any_of(scene.motions.begin(), scene.motions.end(),
                                        [](const Motion& m) { return m.turn.has_value(); });
        way.assign(bead.x.size(), 0);
        for (std::size_t i = 1; i < way.size(); ++i) {
            const V hop = wide(bead.x[i]) - wide(bead.x[i - 1]);
            way[i] = way[i - 1] + std::sqrt(dot(hop, hop));
        }
        count_edges();
        sizes();
        grid(times);
        if (!rigid) bound_speed();
    }

    Quad corners(uint32_t segment) const {
        Quad c;
        for (std::size_t k = 0; k < 4; ++k)
            c[k] = wide(surface.mesh.x[surface.mesh.segment[segment][k]]);
        return c;
    }

    /// Whether the foot lies where the surface ends.
    bool free(uint32_t segment, const Near& near) const {
        if (near.edge < 0) return false;
        const SegmentNodes& n = surface.mesh.segment[segment];
        if (near.corner >= 0) return outline.at(n[static_cast<std::size_t>(near.corner)]);
        const auto k = static_cast<std::size_t>(near.edge);
        return edge_count.at(key(n[k], n[(k + 1) % 4])) == 1;
    }

    const EvaluationScene& scene;
    const EvaluationBead& bead;
    const EvaluationSurface& surface;
    Truth truth;
    std::vector<Path> paths;
    std::vector<R> way;             ///< along the deck's coordinates
    std::vector<R> time;            ///< grid
    std::vector<uint8_t> kink;      ///< of the grid: a velocity may jump here
    std::vector<std::size_t> asked; ///< of the grid: those that are to be recorded
    std::vector<V> low, high;       ///< boxes of segments as they start
    uint32_t frame = 0;
    bool rigid = true;    ///< the surface moves as one
    bool turning = false; ///< speeds are not lines between the corners of the tables
    R margin = 0, scale = 0, speed = 0;
    std::map<std::pair<uint32_t, uint32_t>, int> edge_count;
    std::vector<uint8_t> outline; ///< by node: an edge that ends there is free

private:
    static std::pair<uint32_t, uint32_t> key(uint32_t a, uint32_t b) {
        return {std::min(a, b), std::max(a, b)};
    }

    void count_edges() {
        for (const SegmentNodes& n : surface.mesh.segment)
            for (std::size_t k = 0; k < 4; ++k)
                if (n[k] != n[(k + 1) % 4]) ++edge_count[key(n[k], n[(k + 1) % 4])];
        outline.assign(surface.mesh.x.size(), 0);
        for (const auto& [edge, count] : edge_count)
            if (count == 1) outline[edge.first] = outline[edge.second] = 1;
    }

    void sizes() {
        R sum = 0;
        for (uint32_t s = 0; s < surface.mesh.segment.size(); ++s) {
            const Quad c = corners(s);
            V lo = c[0], hi = c[0];
            for (const V& p : c) {
                lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
                hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
                scale = std::max({scale, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
            }
            low.push_back(lo);
            high.push_back(hi);
            sum += std::sqrt(dot(hi - lo, hi - lo));
        }
        margin = low.empty() ? 1 : sum / static_cast<R>(low.size());
    }

    void grid(std::span<const double> times) {
        std::map<double, uint8_t> all; // 1: asked for, 2: a corner
        for (const double t : times)
            all[t] |= 1;
        const double begin = times.front(), end = times.back();
        for (const Motion& motion : scene.motions)
            for (const double t : motion.corners(begin, end))
                all[t] |= 3;
        for (const double t : {bead.t_start, bead.t_stop})
            if (t > begin && t < end) all[t] |= 3;
        for (const auto& [t, what] : all) {
            if (what & 1) asked.push_back(time.size());
            time.push_back(t);
            kink.push_back(what & 2);
        }
    }

    /// No node of the surface moves faster in space.
    void bound_speed() {
        for (const R t : time)
            for (std::size_t i = 0; i < surface.mesh.x.size(); i += 1 + surface.mesh.x.size() / 200) {
                const Moved m = paths[surface.motion[i]].at(t, t);
                const V v = m.velocity(m.at(wide(surface.mesh.x[i])));
                speed = std::max(speed, std::sqrt(dot(v, v)));
            }
        speed *= 1.5L;
    }
};

/// Follows one spot through the run.
class Follower {
public:
    Follower(const World& world, const Spot& spot) : w_(world), spot_(spot), moved_(world.paths.size()) {}

    Record run() {
        record_ = empty_record(w_.asked.size());
        auto next = w_.asked.begin();
        const std::size_t last = w_.time.size() - 1;
        bool open = false;
        Look before;
        for (std::size_t i = 0; i <= last; ++i) {
            const R t = w_.time[i];
            const R inside = i < last ? (t + w_.time[i + 1]) / 2 : (t + w_.time[i - 1]) / 2;
            const bool opens = t >= w_.bead.t_start && t < w_.bead.t_stop;
            if (!opens && !open) {
                if (next != w_.asked.end() && *next == i) ++next;
                continue;
            }
            const bool bends = w_.kink[i] != 0 && open;
            Look now = look(t, bends ? (t + w_.time[i - 1]) / 2 : inside);
            if (open) advance(before, now, 0);
            if (!open) {
                q_ = 0;
                if (now.status > 0) touch(t);
            }
            if (bends) now = look(t, inside);
            if (!opens) q_ = 0;
            open = opens;
            if (next != w_.asked.end() && *next == i) {
                const auto n = static_cast<std::size_t>(next - w_.asked.begin());
                ++next;
                if (open && now.status > 0) put(n, now);
            }
            before = now;
        }
        if (open && before.k > 0 && incremental()) record_.stored = before.share * q_ * q_ / (2 * before.k);
        return std::move(record_);
    }

private:
    bool incremental() const { return w_.bead.iform != 1; }

    void put(std::size_t n, const Look& now) {
        const R q = incremental() ? q_ : viscous(now);
        const V normal = -now.share * now.N * now.n, restraint = -now.share * q * now.u;
        const auto narrow = [](V v) {
            return Vec3{static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
        };
        record_.normal[n] = narrow(normal);
        record_.restraint[n] = narrow(restraint);
        record_.q[n] = static_cast<double>(now.share * q);
    }

    static R viscous(const Look& l) {
        const R q = l.damper * l.speed;
        return q > l.limit ? l.limit : q < -l.limit ? -l.limit : q;
    }

    const Moved& moved(uint32_t m, R t, R inside) {
        auto& [at, side, value] = moved_[m];
        if (at != t || side != inside) {
            value = w_.paths[m].at(t, inside);
            at = t;
            side = inside;
        }
        return value;
    }

    V node(std::size_t i, R t, R inside) {
        return moved(w_.bead.motion[i], t, inside).at(wide(w_.bead.x[i]));
    }

    Quad corners(uint32_t segment, R t, R inside) {
        if (w_.rigid) return w_.corners(segment);
        Quad c;
        for (std::size_t k = 0; k < 4; ++k) {
            const uint32_t n = w_.surface.mesh.segment[segment][k];
            c[k] = moved(w_.surface.motion[n], t, inside).at(wide(w_.surface.mesh.x[n]));
        }
        return c;
    }

    static R outside(V lo, V hi, V x) {
        const V d{std::max({lo.x - x.x, x.x - hi.x, R(0)}), std::max({lo.y - x.y, x.y - hi.y, R(0)}),
                  std::max({lo.z - x.z, x.z - hi.z, R(0)})};
        return std::sqrt(dot(d, d));
    }

    /// Segments that can be the closest as long as neither the spot nor the surface goes farther than the
    /// margin.
    void gather(V x, R t, R inside) {
        gathered_at_ = x;
        gathered_then_ = t;
        known_ = true;
        const std::size_t count = w_.low.size();
        std::vector<R> far(count);
        R bound = infinity;
        for (uint32_t s = 0; s < count; ++s) {
            if (w_.rigid) {
                far[s] = outside(w_.low[s], w_.high[s], x);
                const V c = w_.corners(s)[0];
                bound = std::min(bound, std::sqrt(dot(c - x, c - x)));
            } else {
                const Quad c = corners(s, t, inside);
                V lo = c[0], hi = c[0];
                for (const V& p : c) {
                    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
                    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
                }
                far[s] = outside(lo, hi, x);
                bound = std::min(bound, std::sqrt(dot(c[0] - x, c[0] - x)));
            }
        }
        near_.clear();
        for (uint32_t s = 0; s < count; ++s)
            if (far[s] <= bound + 2 * w_.margin) near_.push_back(s);
    }

    /// In the frame of the surface when that is rigid, else in space.
    bool closest(V x, R t, R inside, uint32_t& segment, Near& foot) {
        const V gone = x - gathered_at_;
        if (!known_ ||
            std::sqrt(dot(gone, gone)) + (w_.rigid ? 0 : w_.speed * std::abs(t - gathered_then_)) > w_.margin)
            gather(x, t, inside);
        const R equal = 4e-15L * std::max({w_.scale, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
        R best = infinity;
        bool any = false;
        const auto consider = [&](uint32_t s) {
            const SegmentNodes& n = w_.surface.mesh.segment[s];
            const bool again = s == last_;
            const Near one =
                nearest(corners(s, t, inside), n[2] == n[3], x, again ? last_xi_ : 0, again ? last_eta_ : 0);
            const R d = std::sqrt(one.squared);
            const bool clearly = d < best - equal, tied = !clearly && d <= best + equal;
            // Among equals a foot inside wins, then the first in storage order.
            const bool in = one.edge < 0, in_so_far = foot.edge < 0;
            const bool takes = !any || clearly || (tied && (in != in_so_far ? in : s < segment));
            best = std::min(best, d);
            if (!takes) return;
            any = true;
            foot = one;
            segment = s;
        };
        const uint32_t last = last_;
        if (last < w_.low.size()) consider(last); // most likely still the one
        for (const uint32_t s : near_)
            if (s != last && !(w_.rigid && farther(w_.low[s], w_.high[s], x, best + equal))) consider(s);
        if (any) {
            last_ = segment;
            last_xi_ = std::clamp<R>(foot.xi, -0.9L, 0.9L);
            last_eta_ = std::clamp<R>(foot.eta, -0.9L, 0.9L);
        }
        return any;
    }

    static bool farther(V lo, V hi, V x, R bound) {
        const R dx = std::max({lo.x - x.x, x.x - hi.x, R(0)});
        if (dx > bound) return true;
        const R dy = std::max({lo.y - x.y, x.y - hi.y, R(0)});
        if (dy > bound) return true;
        const R dz = std::max({lo.z - x.z, x.z - hi.z, R(0)});
        return dx * dx + dy * dy + dz * dz > bound * bound;
    }

    Look look(R t, R inside) {
        ++record_.evaluations;
        Look out;
        out.t = t;
        const std::size_t last = w_.bead.x.size() - 1, i = spot_.node;
        const std::size_t up = i < last ? i + 1 : last, down = i > 0 ? i - 1 : 0;
        const V here = node(i, t, inside), ahead = node(up, t, inside), behind = node(down, t, inside);
        const auto size = [](V v) { return std::sqrt(dot(v, v)); };
        const R hops = (size(ahead - here) + size(here - behind)) / 2;
        V x = here, chord = (ahead - behind) / 2;
        R L = w_.truth == Truth::nodes ? size(chord) : hops;
        if (spot_.part > 0) {
            const V a = node(spot_.a, t, inside), b = node(spot_.b, t, inside);
            chord = b - a;
            x = a + spot_.at * chord;
            L = hops;
            out.share = hops > 0 ? spot_.part * size(chord) / hops : 0;
        }
        const Moved& frame = moved(w_.frame, t, inside);
        const V seen = w_.rigid ? frame.back(x) : x;
        Near foot;
        if (!closest(seen, t, inside, out.segment, foot)) return out;
        out.held = true;
        const SegmentNodes& nodes = w_.surface.mesh.segment[out.segment];
        const bool triangle = nodes[2] == nodes[3];
        const Quad c = corners(out.segment, t, inside);
        const V n = normal_at(c, triangle, foot.xi, foot.eta), away = seen - foot.point;
        const R along = dot(n, away), d = along < 0 ? -std::sqrt(foot.squared) : std::sqrt(foot.squared);
        bool beside = false;
        if (w_.free(out.segment, foot)) {
            const V area = cross(c[2] - c[0], c[3] - c[1]) / 2;
            beside = size(away - along * n) > 0.05L * std::sqrt(size(area));
        }
        out.n = w_.rigid ? frame.turn(n) : n;
        out.foot = w_.rigid ? frame.at(foot.point) : foot.point;
        const V across = cross(out.n, chord);
        out.u = size(across) > 0 ? across / size(across) : V{};
        law(out, d, beside, L);
        // Velocities of the two.
        V blank;
        if (w_.rigid) {
            blank = frame.velocity(out.foot);
        } else {
            const R s = foot.xi, e = foot.eta;
            const std::array<R, 4> h{(1 - s) * (1 - e) / 4, (1 + s) * (1 - e) / 4, (1 + s) * (1 + e) / 4,
                                     (1 - s) * (1 + e) / 4};
            for (std::size_t k = 0; k < 4; ++k)
                blank += h[k] * moved(w_.surface.motion[nodes[k]], t, inside).velocity(c[k]);
        }
        V bead;
        if (spot_.part > 0) {
            const V a = node_velocity(spot_.a, t, inside), b = node_velocity(spot_.b, t, inside);
            bead = a + spot_.at * (b - a);
        } else {
            bead = node_velocity(i, t, inside);
        }
        out.speed = dot(blank - bead, out.u);
        return out;
    }

    V node_velocity(std::size_t i, R t, R inside) {
        return moved(w_.bead.motion[i], t, inside).velocity(node(i, t, inside));
    }

    /// The manual's law (solver notes 4): normal force, limit, stiffness.
    void law(Look& out, R d, bool beside, R L) const {
        const BeadLaw<double>& b = w_.bead.law;
        const auto limit = [&](R first, R last) {
            const R whole = w_.way.back();
            R s = spot_.part > 0 ? w_.way[spot_.a] + spot_.at * (w_.way[spot_.b] - w_.way[spot_.a])
                                 : w_.way[spot_.node];
            s = whole > 0 ? s / whole : 0;
            const R here = last != 0 ? (1 - s) * first + s * last : first;
            return here > 0 ? here : R(0);
        };
        const R f = limit(b.ft_first, b.ft_last), F = b.fn_first != 0 ? limit(b.fn_first, b.fn_last) : 0;
        const R t = w_.surface.thickness[out.segment];
        const SegmentStiffness& stiffness = w_.surface.stiffness[out.segment];
        out.k = stiffness.k;
        if (stiffness.half_thickness > 0) out.k *= t / (2 * static_cast<R>(stiffness.half_thickness));
        const SegmentNodes& nodes = w_.surface.mesh.segment[out.segment];
        R mass = 0;
        const std::size_t count = nodes[2] == nodes[3] ? 3 : 4;
        for (std::size_t k = 0; k < count; ++k)
            mass += w_.surface.mass[nodes[k]];
        out.damper = std::sqrt(out.k * mass / static_cast<R>(count));
        out.restrains = f > 0;
        const R depth = b.depth > 0 ? static_cast<R>(b.depth) : 0, deep = depth - d + t / 2;
        if (beside || !(deep > 0)) return;
        const R full = F * L;
        R r = 1;
        if (full > 0 && (depth == 0 || full > out.k * depth)) {
            out.N = std::min(out.k * deep, full);
            r = out.N / full;
        } else {
            if (depth > 0) r = std::min(deep / depth, R(1));
            out.N = full * r;
        }
        out.ramp = r;
        out.limit = f * L * r;
        out.status = r < 1 ? 1 : 2;
    }

    void touch(R t) { record_.first_contact = std::min(record_.first_contact, t); }

    void advance(const Look& a, const Look& b, int depth) {
        if (!(b.t > a.t)) return;
        const R inside = (a.t + b.t) / 2;
        if (a.same_kind(b) || depth > 24) {
            smooth(a, b);
            return;
        }
        Look low = a, high = b;
        const bool jump = a.status != b.status && (a.status == 0 || b.status == 0);
        const R close = (jump ? 1e-18L : 1e-13L) * (std::abs(b.t) + (b.t - a.t));
        for (int i = 0; i < 70 && high.t - low.t > close; ++i) {
            const R t = (low.t + high.t) / 2;
            if (!(t > low.t && t < high.t)) break;
            const Look m = look(t, inside);
            (m.same_kind(a) ? low : high) = m;
        }
        smooth(a, low);
        if (jump) record_.at_a_blow = record_.at_a_blow || std::max(low.ramp, high.ramp) > 1e-6L;
        if (a.status == 0 && high.status > 0) {
            q_ = 0;
            touch(high.t);
        }
        if (high.status == 0) q_ = 0;
        if (std::abs(q_) > high.limit) {
            if (q_ != 0 && high.restrains) record_.first_slip = std::min(record_.first_slip, high.t);
            q_ = q_ > 0 ? high.limit : -high.limit;
        }
        advance(high, b, depth + 1);
    }

    /// Nothing changes its kind between a and b.
    void smooth(const Look& a, const Look& b) {
        if (a.status == 0 || !(b.t > a.t)) return;
        const R inside = (a.t + b.t) / 2;
        Look m = b;
        if (w_.turning || a.limit != b.limit || a.u != b.u) {
            m = look(inside, inside);
        } else {
            // All is straight in between: tables are lines, and nothing else changes.
            m.t = inside;
            m.speed = (a.speed + b.speed) / 2;
        }
        if (!incremental()) {
            damped(a, m, b);
            return;
        }
        const auto turns = [](const Look& p, const Look& q) {
            return (p.speed > 0 && q.speed < 0) || (p.speed < 0 && q.speed > 0);
        };
        if (!turns(a, m) && !turns(m, b)) {
            slide(a, m, b);
            return;
        }
        Look low = turns(a, m) ? a : m, high = turns(a, m) ? m : b;
        const R close = 1e-16L * (std::abs(b.t) + (b.t - a.t));
        for (int i = 0; i < 70 && high.t - low.t > close; ++i) {
            const R t = (low.t + high.t) / 2;
            if (!(t > low.t && t < high.t)) break;
            const Look middle = look(t, inside);
            (turns(low, middle) ? high : low) = middle;
        }
        const Look before = look((a.t + low.t) / 2, inside), after = look((high.t + b.t) / 2, inside);
        if (low.t > a.t) slide(a, before, low);
        if (b.t > high.t) slide(high, after, b);
    }

    /// Values at begin, middle and end as a parabola over [0, 1].
    struct Parabola {
        R c0, c1, c2;
        Parabola(R a, R m, R b) : c0(a), c1(4 * m - 3 * a - b), c2(2 * (a + b) - 4 * m) {}
        R at(R x) const { return c0 + x * (c1 + x * c2); }
        R integral(R x) const { return x * (c0 + x * (c1 / 2 + x * c2 / 3)); }
    };

    /// The speed keeps its sign.
    void slide(const Look& a, const Look& m, const Look& b) {
        const R h = b.t - a.t, k = b.k;
        const Parabola speed(a.speed, m.speed, b.speed), limit(a.limit, m.limit, b.limit);
        const auto trial = [&](R x) { return q_ + k * h * speed.integral(x); };
        const R end = trial(1), sign = end < 0 ? -1 : 1;
        if (!(std::abs(end) > b.limit) || !(k > 0)) {
            if (k > 0) {
                const R work = (end * end - q_ * q_) / (2 * k);
                record_.absorbed += a.share * work;
                record_.gross += a.share * std::abs(work);
                q_ = end;
            } else {
                q_ = 0;
            }
            return;
        }
        R from = 0;
        if (sign * q_ < a.limit * (1 - 1e-15L)) {
            R low = 0, high = 1;
            for (int i = 0; i < 80; ++i) {
                const R x = (low + high) / 2;
                (sign * trial(x) > limit.at(x) ? high : low) = x;
            }
            from = high;
        }
        if (b.restrains) record_.first_slip = std::min(record_.first_slip, a.t + from * h);
        const R at_limit = from > 0 ? sign * limit.at(from) : q_;
        const R stick = (at_limit * at_limit - q_ * q_) / (2 * k);
        // ∫ limit · speed over the rest, by three points of Gauss: exact for parabolas.
        static const R g = std::sqrt(0.6L);
        const R centre = (from + 1) / 2, half = (1 - from) / 2;
        const auto power = [&](R x) { return sign * limit.at(x) * speed.at(x); };
        const R slip =
            half * h * (5 * power(centre - g * half) + 8 * power(centre) + 5 * power(centre + g * half)) / 9;
        record_.absorbed += a.share * (stick + slip);
        record_.gross += a.share * (std::abs(stick) + std::abs(slip));
        q_ = sign * b.limit;
    }

    void damped(const Look& a, const Look& m, const Look& b) {
        const R h = b.t - a.t;
        const R work = h * (viscous(a) * a.speed + 4 * viscous(m) * m.speed + viscous(b) * b.speed) / 6;
        record_.absorbed += a.share * work;
        record_.gross += a.share * std::abs(work);
        if (!a.restrains) return;
        const auto over = [](const Look& l) { return l.damper * std::abs(l.speed) > l.limit; };
        if (over(a)) {
            record_.first_slip = std::min(record_.first_slip, a.t);
        } else if (over(b) && record_.first_slip > a.t) {
            Look low = a, high = b;
            for (int i = 0; i < 60; ++i) {
                const Look middle = look((low.t + high.t) / 2, m.t);
                (over(middle) ? high : low) = middle;
            }
            record_.first_slip = std::min(record_.first_slip, high.t);
        }
    }

    const World& w_;
    Spot spot_;
    Record record_;
    struct Known {
        R t = -infinity, inside = 0;
        Moved value;
    };
    std::vector<Known> moved_;
    std::vector<uint32_t> near_;
    V gathered_at_;
    R gathered_then_ = 0, q_ = 0;
    uint32_t last_ = 0xffffffffu; ///< segment of the look before
    R last_xi_ = 0, last_eta_ = 0;
    bool known_ = false;
};

/// One half of a hop: what its part of the line did, and for the node's sum q.
Record half_hop(const World& world, const World& probe, uint32_t a, bool second, R normal_scale,
                R restraint_scale, double tolerance) {
    Record sum = empty_record(world.asked.size());
    const auto run_in = [&](const World& which, R at, R part) {
        return Follower(which, Spot{a, a + 1, second ? a + 1 : a, at, part}).run();
    };
    const auto run = [&](R at, R part) { return run_in(world, at, part); };
    const auto apart = [](const Record& one, const Record& two) {
        std::pair<double, double> most{0, 0};
        for (std::size_t i = 0; i < one.q.size(); ++i) {
            most.first = std::max(most.first, norm(one.normal[i] - two.normal[i]));
            most.second = std::max(most.second, norm(one.restraint[i] - two.restraint[i]));
        }
        return most;
    };
    static const R g = 1 / std::sqrt(3.0L);
    // A coarse look in time decides how far the parts are halved, and whether one point stands for a part.
    bool varies = true;
    const auto panel = [&](const auto& self, R from, R to, int depth) -> void {
        const R centre = (from + to) / 2, half = (to - from) / 2;
        const Record one = run_in(probe, centre, to - from);
        Record two = run_in(probe, centre - g * half, half);
        two.add(run_in(probe, centre + g * half, half), 1);
        sum.evaluations += one.evaluations + two.evaluations;
        // The ends see what both miss: contact that stops within the part.
        const R edge = 1e-9L * (to - from);
        Record ends = run_in(probe, from + edge, half);
        ends.add(run_in(probe, to - edge, half), 1);
        sum.evaluations += ends.evaluations;
        auto [normal, restraint] = apart(one, two);
        const auto [normal_of_ends, restraint_of_ends] = apart(one, ends);
        normal = std::max(normal, normal_of_ends / 4);
        restraint = std::max(restraint, restraint_of_ends / 4);
        const auto within = [&](double share) {
            return normal <= share * normal_scale && restraint <= share * restraint_scale;
        };
        const bool same_work =
            std::abs(one.absorbed - two.absorbed) <= 1e-12L * std::max(one.gross, two.gross);
        if (within(1e-12) && same_work) {
            sum.add(run(centre, to - from), 1);
            if (depth == 0) varies = false;
        } else if (depth >= most_halvings || within(tolerance)) {
            sum.add(run(centre - g * half, half), 1);
            sum.add(run(centre + g * half, half), 1);
        } else {
            self(self, from, centre, depth + 1);
            self(self, centre, to, depth + 1);
        }
    };
    panel(panel, second ? 0.5L : 0, second ? 1 : 0.5L, 0);
    // Slip and contact begin at an end of it more often than not.
    if (varies)
        for (const R at : {second ? 0.5L : R(0), second ? R(1) : 0.5L}) {
            const Record end = run(at, 1e-30L);
            sum.first_slip = std::min(sum.first_slip, end.first_slip);
            sum.first_contact = std::min(sum.first_contact, end.first_contact);
            sum.evaluations += end.evaluations;
        }
    return sum;
}

} // namespace

std::string_view name(Truth truth) {
    return truth == Truth::line ? "line" : truth == Truth::nodes ? "nodes" : "arc";
}

ReferenceBead reference_of(const EvaluationScene& scene, std::size_t bead, std::span<const double> times,
                           const ReferenceOptions& options) {
    const World world(scene, bead, times, options.truth);
    std::vector<double> some;
    for (std::size_t i = 0; i < times.size(); i += 1 + times.size() / 200)
        some.push_back(times[i]);
    if (some.back() != times.back()) some.push_back(times.back());
    const World probe(scene, bead, some, options.truth);
    const std::size_t nodes = world.bead.x.size();
    const bool line = options.truth == Truth::line && nodes > 1;
    const BeadLaw<double>& law = world.bead.law;
    const R length = world.way.back();
    const R normal_scale = length * std::max<R>({law.fn_first, law.fn_last, 1e-300}),
            restraint_scale = length * std::max<R>({law.ft_first, law.ft_last, 1e-300});
    std::vector<Record> records(line ? 2 * (nodes - 1) : nodes);
    parallel_for(options.threads, records.size(), [&](std::size_t i) {
        records[i] = line ? half_hop(world, probe, static_cast<uint32_t>(i / 2), i % 2 == 1, normal_scale,
                                     restraint_scale, options.line_tolerance)
                          : Follower(world, Spot{static_cast<uint32_t>(i), static_cast<uint32_t>(i),
                                                 static_cast<uint32_t>(i), 0, 0})
                                .run();
    });
    Record total = empty_record(world.asked.size());
    ReferenceBead out;
    for (std::size_t node = 0; node < nodes; ++node) {
        Record of_node = empty_record(world.asked.size());
        if (!line) {
            of_node.add(records[node], 1);
        } else {
            if (node > 0) of_node.add(records[2 * node - 1], 1);
            if (node + 1 < nodes) of_node.add(records[2 * node], 1);
        }
        for (const double q : of_node.q)
            if (std::abs(q) > out.worst * (1 + 1e-12)) {
                out.worst = std::abs(q);
                out.worst_node = static_cast<uint32_t>(node);
            }
        total.add(of_node, 1);
    }
    for (const std::size_t i : world.asked)
        out.time.push_back(static_cast<double>(world.time[i]));
    out.normal = std::move(total.normal);
    out.restraint = std::move(total.restraint);
    for (std::size_t i = 0; i < out.time.size(); ++i) {
        out.normal_largest = std::max(out.normal_largest, norm(out.normal[i]));
        out.restraint_largest = std::max(out.restraint_largest, norm(out.restraint[i]));
    }
    out.absorbed = static_cast<double>(total.absorbed);
    out.stored = static_cast<double>(total.stored);
    out.gross = static_cast<double>(total.gross);
    if (total.first_contact < infinity) out.first_contact = static_cast<double>(total.first_contact);
    if (total.first_slip < infinity) out.first_slip = static_cast<double>(total.first_slip);
    out.evaluations = total.evaluations;
    out.at_a_blow = total.at_a_blow;
    return out;
}

} // namespace drawbead
