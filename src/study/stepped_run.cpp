#include "study/stepped_run.h"

#include "contact/closest_segment.h"
#include "contact/solver_search.h"
#include "force/manual_law.h"
#include "study/line_points.h"
#include "study/segment_foot.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace drawbead {

namespace {

/// A sum, with what rounding took from it (Neumaier) when that is asked for.
template <class Real>
class Sum {
public:
    void add(Real v, bool compensated) {
        const Real next = sum_ + v;
        if (compensated) lost_ += std::abs(sum_) >= std::abs(v) ? (sum_ - next) + v : (v - next) + sum_;
        sum_ = next;
    }
    double value() const { return static_cast<double>(sum_ + lost_); }

private:
    Real sum_ = 0, lost_ = 0;
};

template <class Real>
class VectorSum {
public:
    void add(const BasicVec3<Real>& v, bool compensated) {
        x_.add(v.x, compensated);
        y_.add(v.y, compensated);
        z_.add(v.z, compensated);
    }
    Vec3 value() const { return {x_.value(), y_.value(), z_.value()}; }

private:
    Sum<Real> x_, y_, z_;
};

template <class Real>
BasicVec3<Real> rounded(Vec3 v) {
    return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
}
template <class Real>
Vec3 widened(const BasicVec3<Real>& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// The adaptive line halves a part along which the forces change by more than this share of the largest.
constexpr double line_tolerance = 1e-4;

template <class Real>
class Stepped final : public SteppedRun {
    using V = BasicVec3<Real>;

public:
    Stepped(const EvaluationScene& scene, std::size_t bead, const ManualSettings& settings)
        : SteppedRun(scene, bead, EffectSet::all()), settings_(settings), mesh_(surface_.mesh),
          share_(bead_.x.size(), 0.0), place_(scene.motions.size()), before_(scene.motions.size()),
          x_(bead_.x.size()), compensated_(settings.sum == Summing::compensated) {
        law_ = {static_cast<Real>(bead_.law.fn_first), static_cast<Real>(bead_.law.fn_last),
                static_cast<Real>(bead_.law.ft_first), static_cast<Real>(bead_.law.ft_last),
                static_cast<Real>(bead_.law.depth)};
        incremental_ = bead_.iform != 1;
        double length = 0;
        for (std::size_t i = 1; i < bead_.x.size(); ++i)
            share_[i] = length += distance(bead_.x[i - 1], bead_.x[i]);
        for (double& s : share_)
            s = length > 0 ? s / length : 0;
        reference_ = surface_.motion.empty() ? 0 : surface_.motion.front();
        one_motion_ = std::all_of(surface_.motion.begin(), surface_.motion.end(),
                                  [&](uint32_t m) { return m == reference_; });
        closest_ = std::make_unique<ClosestSegment>(mesh_);
        capacities();
        times_of_corners();
        const std::vector<LinePoint> line =
            line_points(bead_.x.size(), settings.line,
                        [&](uint32_t a, double from, double to) { return changes(a, from, to); });
        for (const LinePoint& one : line)
            points_.push_back({one, {}, {}, {}, 0, false});
        by_node_.assign(bead_.x.size(), 0);
    }

    StudyCounts cost() const override { return cost_; }
    double absorbed() const override { return absorbed_.value(); }

    void finish() override {
        BeadEnergy& energy = history_.energy;
        if (incremental_) {
            Sum<Real> stored;
            for (const Point& p : points_)
                if (p.now.k > 0) stored.add(p.now.share * p.q * p.q / (2 * p.now.k), compensated_);
            energy.stored = stored.value();
        }
        energy.dissipated = dissipated_.value();
        energy.restraint_work = restraint_work_.value();
        energy.normal_work = normal_work_.value();
        energy.tool_work = tool_work_.value();
    }

private:
    /// A point of the line at one instant.
    struct At {
        ManualContact<Real> contact;
        ManualForce<Real> force;
        V chord;
        Real length = 0, share = 1; ///< of its node, and the part of that it stands for
        Real k = 0, limit = 0, speed = 0;
        Real xi = 0, eta = 0;
        Vec3 foot, x; ///< where they are
        uint32_t segment = no_segment;
        bool touches = false;
    };
    struct Point {
        LinePoint line;
        At then, now;
        Track track;
        Real q = 0; ///< of the slider, as of the whole node
        bool tracked = false;
    };

    void capacities() {
        const std::size_t last = bead_.x.size() - 1;
        for (std::size_t i = 0; i <= last; ++i) {
            const double L = 0.5 * norm(bead_.x[std::min(i + 1, last)] - bead_.x[i > 0 ? i - 1 : 0]);
            if (bead_.law.fn_first != 0)
                history_.normal_capacity +=
                    manual_limit(bead_.law.fn_first, bead_.law.fn_last, share_[i]) * L;
            history_.restraint_capacity += manual_limit(bead_.law.ft_first, bead_.law.ft_last, share_[i]) * L;
        }
    }

    /// Where steps end too when they are split.
    void times_of_corners() {
        if (settings_.kinks != Kinks::split) return;
        const double begin = scene_.time.front(), end = scene_.time.back();
        std::vector<uint32_t> motions = surface_.motion;
        motions.insert(motions.end(), bead_.motion.begin(), bead_.motion.end());
        std::sort(motions.begin(), motions.end());
        motions.erase(std::unique(motions.begin(), motions.end()), motions.end());
        for (const uint32_t m : motions)
            for (const double t : scene_.motions[m].corners(begin, end))
                corners_.push_back(t);
        for (const double t : {bead_.t_start, bead_.t_stop})
            if (t > begin && t < end) corners_.push_back(t);
        std::sort(corners_.begin(), corners_.end());
        corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    }

    /// Everything to its place at t.
    void place(double t) {
        for (std::size_t m = 0; m < place_.size(); ++m)
            place_[m] = scene_.motions[m].placement(t);
        for (std::size_t i = 0; i < x_.size(); ++i)
            x_[i] = place_[bead_.motion[i]](bead_.x[i]);
        if (one_motion_) return;
        for (uint32_t i = 0; i < mesh_.x.size(); ++i)
            if (surface_.motion[i] != reference_)
                mesh_.x[i] = place_[reference_].back(place_[surface_.motion[i]](surface_.mesh.x[i]));
        closest_ = std::make_unique<ClosestSegment>(mesh_);
    }

    /// The part of the line around the place in it: its chord, the length of its node, its share of that.
    void shape(const LinePoint& line, At& at) const {
        const std::size_t last = x_.size() - 1, node = line.node;
        const std::size_t next = std::min(node + 1, last), previous = node > 0 ? node - 1 : 0;
        const double hops = 0.5 * (distance(x_[previous], x_[node]) + distance(x_[node], x_[next]));
        if (line.part == 0) {
            at.x = x_[node];
            const Vec3 chord = 0.5 * (x_[next] - x_[previous]);
            at.chord = rounded<Real>(chord);
            at.length = settings_.tributary == Tributary::arc ? static_cast<Real>(hops) : norm(at.chord);
            return;
        }
        const Vec3 hop = x_[line.b] - x_[line.a];
        at.x = x_[line.a] + line.at * hop;
        at.chord = rounded<Real>(hop);
        at.length = static_cast<Real>(hops);
        at.share = line.counts && hops > 0 ? static_cast<Real>(line.part * norm(hop) / hops) : Real(0);
    }

    RealCorners<Real> corners(uint32_t segment) const {
        RealCorners<Real> out;
        for (std::size_t c = 0; c < 4; ++c)
            out[c] = rounded<Real>(mesh_.x[mesh_.segment[segment][c]]);
        return out;
    }

    void find(Point& p, At& at) {
        const Placement& blank = place_[reference_];
        const Vec3 x = blank.back(at.x);
        SegmentFoot<Real> foot;
        bool on_surface = true;
        const bool whole = settings_.search == Searching::exact || !p.tracked;
        if (whole) {
            ++cost_.searches;
            const ClosestHit hit = closest_->find(x);
            if (!hit.found()) {
                at.contact.on_surface = false;
                return;
            }
            at_rim_ = at_rim_ || !hit.exact;
            at.segment = hit.segment;
            on_surface = hit.in_contact_range();
            if (settings_.search == Searching::tracked) start_track(p, hit);
            if (settings_.projection == Projecting::exact && std::is_same_v<Real, double>) {
                foot.normal = rounded<Real>(hit.foot.normal);
                foot.distance = static_cast<Real>(hit.d);
                foot.xi = static_cast<Real>(hit.foot.xi);
                foot.eta = static_cast<Real>(hit.foot.eta);
                set(at, foot, on_surface);
                return;
            }
        } else {
            ++cost_.follows;
            if (!solver_follow(p.track, mesh_, mesh_.x, x)) at_rim_ = true;
            at.segment = p.track.segment;
        }
        ++cost_.projections;
        const V y = rounded<Real>(x);
        foot = settings_.projection == Projecting::exact ? closest_foot(corners(at.segment), y)
                                                         : ratio_foot(corners(at.segment), y);
        set(at, foot, whole ? on_surface : foot.inside);
    }

    void start_track(Point& p, const ClosestHit& hit) const {
        p.tracked = true;
        p.track.segment = hit.segment;
        const SegmentNodes& nodes = mesh_.segment[hit.segment];
        p.track.nearest = *std::min_element(nodes.begin(), nodes.end(), [&](uint32_t a, uint32_t b) {
            return squared_norm(mesh_.x[a] - hit.foot.point) < squared_norm(mesh_.x[b] - hit.foot.point);
        });
    }

    void set(At& at, const SegmentFoot<Real>& foot, bool on_surface) const {
        const Placement& blank = place_[reference_];
        at.contact.on_surface = on_surface;
        at.contact.normal = rounded<Real>(blank.turn(widened(foot.normal)));
        at.contact.distance = foot.distance;
        at.xi = foot.xi;
        at.eta = foot.eta;
        at.foot = blank(widened(weighted(corners(at.segment), foot.xi, foot.eta)));
        const SegmentStiffness& stiffness = surface_.stiffness[at.segment];
        const double t = surface_.thickness[at.segment];
        double k = stiffness.k;
        // A thickness on the element's card counts in the manual's stiffness too.
        if (stiffness.half_thickness > 0) k *= 0.5 * t / stiffness.half_thickness;
        at.k = at.contact.stiffness = static_cast<Real>(k);
        at.contact.half_thickness = static_cast<Real>(0.5 * t);
        const SegmentNodes& nodes = mesh_.segment[at.segment];
        const std::size_t count = is_triangle(nodes) ? 3 : 4;
        double mass = 0;
        for (std::size_t c = 0; c < count; ++c)
            mass += surface_.mass[nodes[c]] / static_cast<double>(count);
        at.contact.mass = static_cast<Real>(mass);
    }

    double share_at(const LinePoint& line) const {
        return share_[line.a] + line.at * (share_[line.b] - share_[line.a]);
    }

    ManualInput<Real> input(const LinePoint& line, const At& at) const {
        ManualInput<Real> in;
        in.half_chord = at.chord;
        in.tributary = at.length;
        in.s_fraction = static_cast<Real>(share_at(line));
        return in;
    }

    ManualForce<Real> law(const ManualContact<Real>& contact, const ManualInput<Real>& in, Real& q) {
        ++cost_.evaluations;
        return incremental_
                   ? manual_node_force<Real, Effects{Restraint::incremental, true, true}>(law_, contact, in,
                                                                                          q)
                   : manual_node_force<Real, Effects{Restraint::viscous, true, true}>(law_, contact, in, q);
    }

    /// Way of the blank's point under the foot in the step.
    Vec3 blank_way(const At& at) const {
        const auto way = [&](uint32_t m, Vec3 start) {
            return place_[m].turned ? place_[m](start) - before_[m](start)
                                    : place_[m].shift - before_[m].shift;
        };
        if (one_motion_ && !place_[reference_].turned) return way(reference_, {});
        const SegmentNodes& nodes = mesh_.segment[at.segment];
        const auto h = corner_weights(static_cast<double>(at.xi), static_cast<double>(at.eta));
        Vec3 sum;
        for (std::size_t c = 0; c < 4; ++c)
            sum += h[c] * way(surface_.motion[nodes[c]], surface_.mesh.x[nodes[c]]);
        return sum;
    }
    Vec3 bead_way(const LinePoint& line) const {
        const auto way = [&](uint32_t i) {
            const uint32_t m = bead_.motion[i];
            return place_[m].turned ? place_[m](bead_.x[i]) - before_[m](bead_.x[i])
                                    : place_[m].shift - before_[m].shift;
        };
        if (line.a == line.b) return way(line.a);
        const Vec3 a = way(line.a);
        return a + line.at * (way(line.b) - a);
    }
    Vec3 blank_velocity(const At& at, double t) const {
        if (one_motion_) return scene_.motions[reference_].velocity_at(t, at.foot);
        const SegmentNodes& nodes = mesh_.segment[at.segment];
        const auto h = corner_weights(static_cast<double>(at.xi), static_cast<double>(at.eta));
        Vec3 v;
        for (std::size_t c = 0; c < 4; ++c) {
            const uint32_t m = surface_.motion[nodes[c]];
            v += h[c] * scene_.motions[m].velocity_at(t, place_[m](surface_.mesh.x[nodes[c]]));
        }
        return v;
    }
    Vec3 bead_velocity(const LinePoint& line, double t) const {
        const Vec3 a = scene_.motions[bead_.motion[line.a]].velocity_at(t, x_[line.a]);
        if (line.a == line.b) return a;
        return a + line.at * (scene_.motions[bead_.motion[line.b]].velocity_at(t, x_[line.b]) - a);
    }

    /// For the adaptive line: forces per length at the middle of a part and at those of its halves.
    bool changes(uint32_t a, double from, double to) {
        const double begin = std::max(scene_.time.front(), bead_.t_start),
                     end = std::min(scene_.time.back(), bead_.t_stop);
        for (int i = 0; i <= 4; ++i) {
            const double t = begin + 0.25 * i * (end - begin);
            if (!(end > begin)) return false;
            if (t != probed_) place(probed_ = t);
            std::array<V, 3> normal, across;
            for (std::size_t k = 0; k < 3; ++k) {
                const double at = from + (to - from) * (0.25 + 0.25 * static_cast<double>(k));
                Point p{{a, a + 1, at, 0.5 * (from + to) < 0.5 ? a : a + 1, to - from, true},
                        {},
                        {},
                        {},
                        0,
                        false};
                shape(p.line, p.now);
                find(p, p.now);
                Real none = 0;
                const ManualForce<Real> f = law(p.now.contact, input(p.line, p.now), none);
                normal[k] = f.normal_force * f.normal;
                across[k] = f.ft_limit * f.ramp * p.now.length * f.across;
            }
            for (const auto& v : {normal, across}) {
                const Real apart = norm(v[1] - Real(0.5) * (v[0] + v[2]));
                const Real scale = std::max({norm(v[0]), norm(v[1]), norm(v[2])});
                if (apart > static_cast<Real>(line_tolerance) * scale) return true;
            }
        }
        return false;
    }

    void step(std::size_t n) override {
        const double t = scene_.time[n];
        if (n > 0) {
            const double from = scene_.time[n - 1];
            auto corner = std::upper_bound(corners_.begin(), corners_.end(), from);
            for (; corner != corners_.end() && *corner < t; ++corner)
                reach(*corner, false);
        }
        reach(t, n + 1 == scene_.time.size());
        sample(n);
    }

    /// The next end of a step.
    void reach(double t, bool last) {
        const bool open = t >= bead_.t_start && t < bead_.t_stop;
        // Up to the window's end itself, where forces are 0 already, the step before it still works.
        const bool works = open || (was_open_ && t == bead_.t_stop);
        std::swap(place_, before_);
        place(t);
        if (works) {
            ++cost_.instants;
            for (Point& p : points_)
                move(p, t, last);
        }
        if (!open && was_open_)
            for (Point& p : points_) {
                release(p);
                p.now.touches = false;
            }
        was_open_ = open;
        t_ = t;
    }

    void release(Point& p) {
        if (incremental_ && p.now.k > 0)
            dissipated_.add(p.now.share * p.q * p.q / (2 * p.now.k), compensated_);
        p.q = 0;
    }

    void move(Point& p, double t, bool last) {
        std::swap(p.then, p.now);
        At& now = p.now;
        const At& then = p.then;
        now = At{};
        shape(p.line, now);
        find(p, now);
        ManualInput<Real> in = input(p.line, now);
        const bool going_on = was_open_ && then.touches;
        Vec3 blank, tool;
        if (now.segment != no_segment) {
            // The left-hand velocity at the end, the right-hand one elsewhere.
            const double at = last ? std::nextafter(t, t - 1) : t;
            in.velocity = rounded<Real>(blank_velocity(now, at) - bead_velocity(p.line, at));
            if (going_on) {
                blank = blank_way(now);
                // Where the surface turns or deforms, feet at both ends of the step count half.
                if (!(one_motion_ && !place_[reference_].turned)) blank = 0.5 * (blank + blank_way(then));
                tool = bead_way(p.line);
                const V across = cross(now.contact.normal, now.chord);
                const Real size = norm(across);
                const V u = size > 0 ? across / size : V{};
                const V mean = then.force.across == u ? u : Real(0.5) * (then.force.across + u);
                in.displacement = dot(rounded<Real>(blank - tool), mean) * u;
            }
        }
        const Real before = going_on ? p.q : Real(0);
        Real q = before;
        now.force = law(now.contact, in, q);
        now.touches = now.contact.on_surface && now.force.penetration > 0;
        now.limit = now.force.ft_limit * now.length * now.force.ramp;
        now.speed = dot(in.velocity, now.force.across);
        if (!now.touches) {
            if (then.touches) {
                if (incremental_ && then.k > 0)
                    dissipated_.add(then.share * before * before / (2 * then.k), compensated_);
            }
            p.q = 0;
            return;
        }
        if (!going_on) note_contact(p, t);
        p.q = incremental_ ? q : now.force.restraint;
        const double start = going_on ? t_ : t;
        note_slip(p, before, start, t, going_on);
        if (!going_on) return;
        Vec3 ending;
        if (!incremental_) {
            const double left = std::nextafter(t, t_);
            ending = blank_velocity(now, left) - bead_velocity(p.line, left);
        }
        work(p, before, in, blank, tool, ending);
    }

    /// `ending`: the velocity with which the step ends.
    void work(const Point& p, Real before, const ManualInput<Real>& in, Vec3 blank, Vec3 tool, Vec3 ending) {
        const At &now = p.now, &then = p.then;
        const V u = now.force.across;
        const Real way = dot(in.displacement, u);
        Real absorbed = 0;
        if (incremental_) {
            const Real slip = now.force.slip;
            const bool slid =
                std::abs(before) >= then.limit * (1 - 16 * std::numeric_limits<Real>::epsilon()) &&
                slip * before > 0;
            const Real lost = (slid ? Real(0.5) * (before + p.q) : p.q) * slip;
            const Real change = now.k > 0 ? (p.q - before) * (p.q + before) / (2 * now.k) : Real(0);
            absorbed = change + lost;
            dissipated_.add(now.share * lost, compensated_);
        } else {
            // Where the velocity jumps, the step ends with its value from the left.
            const Real damper = std::sqrt(now.k * now.contact.mass);
            const Real end = std::clamp(damper * dot(rounded<Real>(ending), u), -now.limit, now.limit);
            absorbed = Real(0.5) * (then.force.restraint + end) * way;
            dissipated_.add(now.share * absorbed, compensated_);
        }
        absorbed_.add(now.share * absorbed, compensated_);
        const Real mean = way != 0 ? absorbed / way : Real(0.5) * (before + p.q);
        const V normal = Real(-0.5) * (then.force.normal_force * then.force.normal +
                                       now.force.normal_force * now.force.normal);
        const V of_blank = rounded<Real>(blank), of_tool = rounded<Real>(tool);
        restraint_work_.add(-now.share * mean * dot(u, of_blank), compensated_);
        normal_work_.add(now.share * dot(normal, of_blank), compensated_);
        tool_work_.add(-now.share * dot(normal - mean * u, of_tool), compensated_);
    }

    /// Earlier than the end of the step by the share of it in which there was no penetration yet.
    void note_contact(const Point& p, double t) {
        const auto earliest = [](std::optional<double>& at, double when) {
            at = at ? std::min(*at, when) : when;
        };
        double when = t;
        const At& then = p.then;
        if (was_open_ && then.segment != no_segment && then.contact.on_surface) {
            const double a = static_cast<double>(then.force.penetration),
                         b = static_cast<double>(p.now.force.penetration);
            if (b > a) when = t_ + (t - t_) * std::clamp(-a / (b - a), 0.0, 1.0);
        }
        earliest(history_.first_contact, when);
        contact_since_ = when;
        if (!(p.now.force.ramp < 1)) earliest(history_.first_plateau, t);
        if (!touched_[p.line.node]) touched_[p.line.node] = 1, ++history_.ever_in_contact;
    }

    /// The first time in the step at which the slider gives way: its force follows the parabola that begins
    /// with the speed at the start and ends with the way gone, the limit a straight line.
    void note_slip(const Point& p, Real before, double from, double to, bool going_on) {
        const At &now = p.now, &then = p.then;
        if (!(now.force.ft_limit > 0)) return;
        double when = to;
        const double k = static_cast<double>(now.k), span = to - from;
        if (!incremental_) {
            const double damper = std::sqrt(k * static_cast<double>(now.contact.mass));
            const auto over = [&](const At& at) {
                return damper * std::abs(static_cast<double>(at.speed)) - static_cast<double>(at.limit);
            };
            if (!(over(now) > 0)) return;
            if (going_on) {
                const double a = over(then), b = over(now);
                when = a > 0 ? from : from + span * (-a / (b - a));
            } else {
                when = contact_since_;
            }
        } else {
            if (!going_on) {
                // A limit that grows from nothing more slowly than the slider's force gives way at once.
                const double since = contact_since_;
                if (p.now.force.ramp < 1 && since < to &&
                    k * std::abs(static_cast<double>(now.speed)) * (to - since) >
                        static_cast<double>(now.limit))
                    when = since;
                else
                    return;
            } else if (now.force.slip == 0) {
                return;
            }
            if (going_on) when = within_step(p, before, from, to);
        }
        history_.first_slip = history_.first_slip ? std::min(*history_.first_slip, when) : when;
    }

    double within_step(const Point& p, Real before, double from, double to) const {
        const At &now = p.now, &then = p.then;
        const double k = static_cast<double>(now.k);
        const double sign = now.force.slip > 0 ? 1 : -1, dt = to - from;
        const double way = (static_cast<double>(p.q - before) / k + static_cast<double>(now.force.slip));
        const double v = static_cast<double>(then.speed), c = (way - v * dt) / (dt * dt);
        // sign·(before + k (v τ + c τ²)) − limit = C + B τ + A τ²
        const double rise = static_cast<double>(now.limit - then.limit) / dt;
        const double A = sign * k * c, B = sign * k * v - rise,
                     C = sign * static_cast<double>(before) - static_cast<double>(then.limit);
        const double slack = 1e-9 * static_cast<double>(then.limit);
        if (!(C < -slack)) return from;
        const double root = std::sqrt(std::max(B * B - 4 * A * C, 0.0));
        const double q = -0.5 * (B + std::copysign(root, B));
        double when = to;
        for (const double t : {A != 0 ? q / A : -1.0, q != 0 ? C / q : -1.0})
            if (t > 0 && t <= dt * (1 + 1e-9)) when = std::min(when, from + t);
        return when;
    }

    void sample(std::size_t n) {
        StepTotals& totals = history_.steps[n];
        const bool keep = sampling(n);
        const double t = scene_.time[n];
        if (keep)
            for (uint32_t i = 0; i < row_.size(); ++i)
                row_[i] = NodeSample{.node = i, .x = x_[i]};
        if (!was_open_) return;
        VectorSum<Real> normal, restraint, couple;
        Sum<Real> normal_sum, restraint_sum;
        std::fill(by_node_.begin(), by_node_.end(), Real(0));
        std::vector<uint8_t> in_contact(x_.size(), 0);
        for (const Point& p : points_) {
            const At& at = p.now;
            if (keep && at.segment != no_segment) {
                NodeSample& row = row_[p.line.node];
                row.segment = at.segment;
                row.found = true;
                row.inside = at.contact.on_surface;
                row.xi = static_cast<double>(at.xi);
                row.eta = static_cast<double>(at.eta);
                row.distance = static_cast<double>(at.contact.distance);
                row.penetration = static_cast<double>(at.force.penetration);
            }
            if (!at.touches) continue;
            const V N = -at.share * at.force.normal_force * at.force.normal,
                    R = -at.share * p.q * at.force.across;
            normal.add(N, compensated_);
            restraint.add(R, compensated_);
            couple.add(cross(rounded<Real>(at.foot - at.x), N + R), compensated_);
            normal_sum.add(std::abs(at.share * at.force.normal_force), compensated_);
            restraint_sum.add(std::abs(at.share * p.q), compensated_);
            by_node_[p.line.node] += at.share * p.q;
            in_contact[p.line.node] = std::max<uint8_t>(in_contact[p.line.node], at.force.ramp < 1 ? 1 : 2);
            if (keep) {
                row_[p.line.node].normal += widened(N);
                row_[p.line.node].restraint += widened(R);
            }
        }
        totals.normal = normal.value();
        totals.restraint = restraint.value();
        totals.couple = couple.value();
        totals.normal_sum = normal_sum.value();
        totals.restraint_sum = restraint_sum.value();
        for (std::size_t i = 0; i < x_.size(); ++i) {
            totals.in_contact += in_contact[i] > 0;
            totals.on_plateau += in_contact[i] > 1;
            const double size = std::abs(static_cast<double>(by_node_[i]));
            if (size > history_.worst_restraint * (1 + 1e-12)) {
                history_.worst_restraint = size;
                history_.worst_node = static_cast<uint32_t>(i);
                history_.worst_time = t;
            }
        }
    }

    ManualSettings settings_;
    NearMesh mesh_; ///< in the frame of its first node
    std::unique_ptr<ClosestSegment> closest_;
    BeadLaw<Real> law_;
    std::vector<double> share_; ///< of the arc length, along the deck's coordinates
    std::vector<double> corners_;
    std::vector<Placement> place_, before_; ///< of all motions: now, and at the step's begin
    std::vector<Vec3> x_;                   ///< of the bead's nodes now
    std::vector<Point> points_;
    std::vector<Real> by_node_;
    Sum<Real> absorbed_, dissipated_, restraint_work_, normal_work_, tool_work_;
    StudyCounts cost_;
    double t_ = 0, probed_ = -1e300, contact_since_ = 0;
    uint32_t reference_ = 0;
    bool incremental_ = true, one_motion_ = true, was_open_ = false, compensated_ = true;
};

} // namespace

std::unique_ptr<SteppedRun> make_stepped_run(const EvaluationScene& scene, std::size_t bead,
                                             const ManualSettings& settings) {
    if (settings.number == Number::single) return std::make_unique<Stepped<float>>(scene, bead, settings);
    return std::make_unique<Stepped<double>>(scene, bead, settings);
}

void set_steps(EvaluationScene& scene, double begin, double end, uint64_t steps) {
    scene.time.clear();
    scene.dt.assign(1, 0.0);
    const auto count = static_cast<double>(steps);
    for (uint64_t n = 0; n < steps; ++n)
        scene.time.push_back(begin + (end - begin) * (static_cast<double>(n) / count));
    scene.time.push_back(end);
    for (uint64_t n = 1; n <= steps; ++n)
        scene.dt.push_back(scene.time[n] - scene.time[n - 1]);
}

} // namespace drawbead
