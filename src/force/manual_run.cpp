#include "contact/closest_segment.h"
#include "force/evaluator.h"
#include "force/manual_law.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

using Kernel = ManualForce<double> (*)(const BeadLaw<double>&, const ManualContact<double>&,
                                       const ManualInput<double>&, double&);

template <bool normal, bool ramp>
Kernel kernel_of(bool varies) {
    return varies ? manual_node_force<double, Effects{Restraint::viscous, normal, true, ramp, ramp}>
                  : manual_node_force<double, Effects{Restraint::viscous, normal, false, ramp, ramp}>;
}

/// One bead under the manual's law. Everything moves exactly; a step is split where a velocity bends or
/// changes its sign and at the window's edges, and for each node where contact begins or ends and where the
/// ramp ends. Between these the slider's return map is exact.
class ManualRun final : public BeadRun {
public:
    ManualRun(const EvaluationScene& scene, std::size_t bead, EffectSet stages)
        : BeadRun(scene, bead, stages), mesh_(surface_.mesh), q_(bead_.x.size(), 0.0),
          share_(bead_.x.size(), 0.0), then_(bead_.x.size()), now_(bead_.x.size()), track_(bead_.x.size()) {
        if (stages.has(Effect::normal))
            kernel_ = stages.has(Effect::ramp) ? kernel_of<true, true>(stages.has(Effect::variation))
                                               : kernel_of<true, false>(stages.has(Effect::variation));
        else
            kernel_ = stages.has(Effect::ramp) ? kernel_of<false, true>(stages.has(Effect::variation))
                                               : kernel_of<false, false>(stages.has(Effect::variation));
        incremental_ = bead_.iform != 1;
        restrains_ = stages.has(incremental_ ? Effect::incremental : Effect::viscous);
        double length = 0;
        for (std::size_t i = 1; i < bead_.x.size(); ++i)
            share_[i] = length += distance(bead_.x[i - 1], bead_.x[i]);
        for (double& s : share_)
            s = length > 0 ? s / length : 0;
        reference_ = surface_.motion.empty() ? 0 : surface_.motion.front();
        one_motion_ = std::all_of(surface_.motion.begin(), surface_.motion.end(),
                                  [&](uint32_t m) { return m == reference_; });
        closest_ = std::make_unique<ClosestSegment>(mesh_);
        deforming_ = stages.has(Effect::deforming_blank) || !one_motion_;
        const std::size_t last = bead_.x.size() - 1;
        for (std::size_t i = 0; i <= last; ++i) {
            const double L = 0.5 * norm(bead_.x[std::min(i + 1, last)] - bead_.x[i > 0 ? i - 1 : 0]);
            if (bead_.law.fn_first != 0)
                history_.normal_capacity +=
                    manual_limit(bead_.law.fn_first, bead_.law.fn_last, share_[i]) * L;
            history_.restraint_capacity += manual_limit(bead_.law.ft_first, bead_.law.ft_last, share_[i]) * L;
        }
        corners_ = corners();
        accelerates_ = std::any_of(scene_.motions.begin(), scene_.motions.end(),
                                   [](const Motion& m) { return m.accelerates(); });
    }

    void finish() override {
        if (!incremental_) return;
        for (std::size_t i = 0; i < q_.size(); ++i)
            if (now_[i].k > 0) history_.energy.stored += q_[i] * q_[i] / (2 * now_[i].k);
    }

private:
    /// A node at one instant.
    struct At {
        ManualContact<double> contact;
        ManualForce<double> force; ///< without restraint
        Vec3 foot, x, chord;       ///< where they are
        double k = 0;
        double limit = 0; ///< of the restraint: a force
        double xi = 0, eta = 0;
        uint32_t segment = 0;
        bool found = false;

        /// Without contact, on the ramp, on the plateau.
        int status() const {
            return !contact.on_surface || !(force.penetration > 0) ? 0 : force.ramp < 1 ? 1 : 2;
        }
    };

    /// The scene's placements at one instant.
    struct Instant {
        double t = 0;
        Placement blank;
        std::vector<Vec3> bead;
    };

    std::vector<double> corners() const {
        std::vector<double> out;
        const double begin = scene_.time.front(), end = scene_.time.back();
        std::vector<uint32_t> motions = surface_.motion;
        motions.insert(motions.end(), bead_.motion.begin(), bead_.motion.end());
        std::sort(motions.begin(), motions.end());
        motions.erase(std::unique(motions.begin(), motions.end()), motions.end());
        for (const uint32_t m : motions)
            for (const double t : scene_.motions[m].bends(begin, end))
                out.push_back(t);
        for (const double t : {bead_.t_start, bead_.t_stop})
            if (t > begin && t < end) out.push_back(t);
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
        return out;
    }

    /// Of the bead nodes in [begin, end) only.
    Instant instant(double t, std::size_t begin, std::size_t end) {
        Instant at;
        at.t = t;
        at.blank = scene_.motions[reference_].placement(t);
        at.bead.resize(bead_.x.size());
        uint32_t last = 0xffffffffu;
        Placement placement;
        for (std::size_t i = begin; i < end; ++i) {
            if (bead_.motion[i] != last) placement = scene_.motions[last = bead_.motion[i]].placement(t);
            at.bead[i] = stages_.has(Effect::moving_tool) ? placement(bead_.x[i]) : bead_.x[i];
        }
        if (deforming_) deform(at);
        return at;
    }

    /// One node at a time between two instants.
    At look(std::size_t i, double t) {
        return look(i, instant(t, i > 0 ? i - 1 : 0, std::min(i + 2, bead_.x.size())));
    }

    /// Brings the mesh to its shape at t, seen from its first node.
    void deform(const Instant& at) {
        count(Effect::deforming_blank);
        if (at.t == shape_of_) return;
        shape_of_ = at.t;
        if (one_motion_) return;
        for (uint32_t i = 0; i < mesh_.x.size(); ++i)
            if (surface_.motion[i] != reference_)
                mesh_.x[i] =
                    at.blank.back(scene_.motions[surface_.motion[i]].placement(at.t)(surface_.mesh.x[i]));
        closest_ = std::make_unique<ClosestSegment>(mesh_);
    }

    At look(std::size_t i, const Instant& now) {
        count(Effect::search);
        At at;
        at.x = now.bead[i];
        const std::size_t last = now.bead.size() - 1;
        at.chord = 0.5 * (now.bead[std::min(i + 1, last)] - now.bead[i > 0 ? i - 1 : 0]);
        const Vec3 seen = now.blank.back(at.x);
        const ClosestHit hit = one_motion_ ? closest_->find(seen, track_[i]) : closest_->find(seen);
        at.contact.on_surface = hit.found();
        if (!hit.found()) return at;
        at_rim_ = at_rim_ || !hit.exact;
        at.found = true;
        at.segment = hit.segment;
        at.xi = hit.foot.xi;
        at.eta = hit.foot.eta;
        at.foot = now.blank(hit.foot.point);
        at.contact.normal = now.blank.turn(hit.foot.normal);
        at.contact.distance = hit.d;
        if (stages_.has(Effect::edge)) {
            count(Effect::edge);
            at.contact.on_surface = hit.in_contact_range();
        }
        const SegmentStiffness& stiffness = surface_.stiffness[hit.segment];
        const double t = surface_.thickness[hit.segment];
        at.k = stiffness.k;
        // A thickness on the element's card counts in the manual's stiffness too.
        if (stiffness.half_thickness > 0) at.k *= 0.5 * t / stiffness.half_thickness;
        at.contact.stiffness = at.k;
        if (stages_.has(Effect::thickness)) {
            count(Effect::thickness);
            at.contact.half_thickness = 0.5 * t;
        }
        const SegmentNodes& nodes = mesh_.segment[hit.segment];
        const std::size_t corners = is_triangle(nodes) ? 3 : 4;
        for (std::size_t c = 0; c < corners; ++c)
            at.contact.mass += surface_.mass[nodes[c]] / static_cast<double>(corners);
        ManualInput<double> in;
        in.half_chord = at.chord;
        in.tributary = norm(at.chord);
        in.s_fraction = share_[i];
        double none = 0;
        at.force = kernel_(bead_.law, at.contact, in, none);
        if (stages_.has(Effect::variation)) count(Effect::variation);
        at.limit = at.force.ft_limit * in.tributary * at.force.ramp;
        return at;
    }

    /// Of the material point of the blank that is at `x` at t.
    Vec3 blank_velocity(const At& at, double t) const {
        if (one_motion_) return scene_.motions[reference_].velocity_at(t, at.foot);
        const SegmentNodes& nodes = mesh_.segment[at.segment];
        const auto h = bilinear_weights(at.xi, at.eta);
        Vec3 v;
        for (std::size_t c = 0; c < 4; ++c) {
            const Motion& m = scene_.motions[surface_.motion[nodes[c]]];
            v += h[c] * m.velocity_at(t, m.placement(t)(surface_.mesh.x[nodes[c]]));
        }
        return v;
    }
    /// Way of the point of the blank that node i is over at `at`, from t0 to t1.
    Vec3 blank_way(const At& at, double t0, double t1) const {
        const auto way = [&](const Motion& m, Vec3 start) {
            return m.turn ? m.placement(t1)(start) - m.placement(t0)(start)
                          : m.displacement(t1) - m.displacement(t0);
        };
        const SegmentNodes& nodes = mesh_.segment[at.segment];
        const auto h = bilinear_weights(at.xi, at.eta);
        if (one_motion_ && !scene_.motions[reference_].turn) return way(scene_.motions[reference_], {});
        Vec3 sum;
        for (std::size_t c = 0; c < 4; ++c)
            sum += h[c] * way(scene_.motions[surface_.motion[nodes[c]]], surface_.mesh.x[nodes[c]]);
        return sum;
    }
    Vec3 bead_way(std::size_t i, double t0, double t1) const {
        if (!stages_.has(Effect::moving_tool)) return {};
        const Motion& m = scene_.motions[bead_.motion[i]];
        return m.turn ? m.placement(t1)(bead_.x[i]) - m.placement(t0)(bead_.x[i])
                      : m.displacement(t1) - m.displacement(t0);
    }

    void step(std::size_t n) override {
        if (!stages_.has(Effect::search)) return;
        const double t = scene_.time[n];
        if (!stages_.has(Effect::moving) && settled_) {
            bool open = true;
            if (stages_.has(Effect::window)) {
                count(Effect::window);
                open = t >= bead_.t_start && t < bead_.t_stop;
            }
            if (open) history_.steps[n] = history_.steps[n - 1];
            if (open || !was_open_) return;
        }
        if (n == 0) {
            advance_to(t, true);
        } else {
            const double from = scene_.time[n - 1];
            auto corner = std::upper_bound(corners_.begin(), corners_.end(), from);
            for (; corner != corners_.end() && *corner < t; ++corner)
                advance_to(*corner, false);
            advance_to(t, false);
        }
        sample(n);
    }

    bool open_at(double t) {
        if (!stages_.has(Effect::window)) return true;
        count(Effect::window);
        return t >= bead_.t_start && t < bead_.t_stop;
    }

    /// To the next instant at which nothing bends in between.
    void advance_to(double t, bool first) {
        const bool open = open_at(t);
        if (!open && !was_open_) {
            t_ = t;
            return;
        }
        if (stages_.has(Effect::moving)) count(Effect::moving);
        const Instant now = instant(t, 0, bead_.x.size());
        if (stages_.has(Effect::moving_tool)) count(Effect::moving_tool, bead_.x.size());
        std::swap(then_, now_);
        for (std::size_t i = 0; i < now_.size(); ++i)
            now_[i] = look(i, now);
        if (was_open_ && !first)
            for (std::size_t i = 0; i < now_.size(); ++i)
                piece(i, t_, t, then_[i], now_[i], 0);
        if (open && !was_open_) begin(t);
        if (!open) {
            // What is still stored when the window closes is lost.
            for (std::size_t i = 0; i < q_.size(); ++i)
                release(i, now_[i].k);
        }
        settled_ = was_open_ && open;
        was_open_ = open;
        t_ = t;
    }

    /// The window opens: contact may be there already.
    void begin(double t) {
        std::fill(q_.begin(), q_.end(), 0.0);
        for (std::size_t i = 0; i < now_.size(); ++i)
            if (now_[i].status() > 0) note_contact(i, t, now_[i].status());
    }

    void note_contact(std::size_t i, double t, int status) {
        const auto earliest = [t](std::optional<double>& at) { at = at ? std::min(*at, t) : t; };
        earliest(history_.first_contact);
        if (status == 2) earliest(history_.first_plateau);
        if (!touched_[i]) touched_[i] = 1, ++history_.ever_in_contact;
    }

    void release(std::size_t i, double k) {
        if (incremental_ && k > 0) history_.energy.dissipated += q_[i] * q_[i] / (2 * k);
        q_[i] = 0;
    }

    /// When in (ta, tb) the node stops to come closer or to go away, or turns across the bead; between bends
    /// relative velocities are linear.
    std::optional<double> turning(std::size_t i, double ta, double tb, const At& a, const At& b) const {
        if (!accelerates_ || !a.found || !b.found || !(tb > ta)) return {};
        const Vec3 va = relative_velocity(i, a, ta), vb = relative_velocity(i, b, std::nextafter(tb, ta));
        const auto zero = [&](Vec3 at_a, Vec3 at_b) -> std::optional<double> {
            const double from = dot(va, at_a), to = dot(vb, at_b);
            if (!(from * to < 0)) return {};
            const double t = ta + (tb - ta) * (from / (from - to)), margin = 1e-9 * (tb - ta);
            return t > ta + margin && t < tb - margin ? std::optional(t) : std::nullopt;
        };
        if (const auto t = zero(a.contact.normal, b.contact.normal)) return t;
        return a.status() > 0 && b.status() > 0 ? zero(a.force.across, b.force.across) : std::nullopt;
    }

    /// Node i from ta to tb; where its status changes in between, in two pieces.
    void piece(std::size_t i, double ta, double tb, const At& a, const At& b, int depth) {
        const int from = a.status(), to = b.status();
        if (const auto turn = depth < 4 ? turning(i, ta, tb, a, b) : std::nullopt) {
            const At at = look(i, *turn);
            piece(i, ta, *turn, a, at, depth + 1);
            piece(i, *turn, tb, at, b, depth + 1);
            return;
        }
        if (from != to && depth < 4) {
            double low = ta, high = tb;
            At at_low = a, at_high = b;
            for (int k = 0; k < 60 && high - low > 1e-15 * (std::abs(tb) + (tb - ta)); ++k) {
                const double middle = 0.5 * (low + high);
                if (!(middle > low && middle < high)) break;
                const At m = look(i, middle);
                (m.status() == from ? (low = middle, at_low) : (high = middle, at_high)) = m;
            }
            const int next = at_high.status();
            slide(i, ta, low, a, at_low);
            if (next > 0) {
                if (from == 0) {
                    if (stages_.has(Effect::stick_reset)) {
                        count(Effect::stick_reset);
                        q_[i] = 0;
                    }
                    note_contact(i, high, next);
                } else if (next == 2) {
                    note_contact(i, high, 2);
                }
                if (std::abs(q_[i]) > at_high.limit) q_[i] = std::copysign(at_high.limit, q_[i]);
            } else if (stages_.has(Effect::stick_reset)) {
                count(Effect::stick_reset);
                release(i, at_low.k);
            }
            piece(i, high, tb, at_high, b, depth + 1);
            return;
        }
        slide(i, ta, tb, a, b);
    }

    /// The slider over a piece in which the contact keeps its kind.
    void slide(std::size_t i, double ta, double tb, const At& a, const At& b) {
        if (b.status() == 0 || !(tb > ta)) return;
        const Vec3 u = b.force.across;
        const Vec3 blank = blank_way(b, ta, tb), tool = bead_way(i, ta, tb);
        const double way = dot(blank - tool, u);
        double& q = q_[i];
        const double before = q;
        double absorbed = 0;
        if (!restrains_) {
            q = 0;
        } else if (incremental_) {
            count(Effect::incremental);
            const double trial = q + b.k * way;
            q = std::clamp(trial, -b.limit, b.limit);
            const double slip = b.k > 0 ? (trial - q) / b.k : way;
            const bool slid = std::abs(before) >= a.limit * (1 - 1e-12) && slip * before > 0;
            const double along = slid ? 0.5 * (before + q) : q;
            const double change = b.k > 0 ? (q * q - before * before) / (2 * b.k) : 0;
            const double lost = along * slip;
            absorbed = change + lost;
            if (stages_.has(Effect::energy)) history_.energy.dissipated += lost;
            if (slip != 0 && b.force.ft_limit > 0) note_slip(i, ta, tb, a, before);
        } else {
            count(Effect::viscous);
            const double damper = std::sqrt(b.k * b.contact.mass);
            const double wanted = damper * dot(relative_velocity(i, b, tb), u);
            const double start = a.status() > 0 ? viscous(i, a, ta) : 0;
            q = std::clamp(wanted, -b.limit, b.limit);
            // The velocity may jump at tb: on the way there it had not yet.
            absorbed = 0.5 * (start + viscous(i, b, std::nextafter(tb, ta))) * way;
            if (stages_.has(Effect::energy)) history_.energy.dissipated += absorbed;
            if (std::abs(wanted) > b.limit && b.force.ft_limit > 0) {
                const double t = std::abs(damper * dot(relative_velocity(i, a, ta), u)) > a.limit ? ta : tb;
                history_.first_slip = history_.first_slip ? std::min(*history_.first_slip, t) : t;
            }
        }
        if (!stages_.has(Effect::energy)) return;
        count(Effect::energy);
        BeadEnergy& energy = history_.energy;
        const double mean = way != 0 ? absorbed / way : 0.5 * (before + q);
        const Vec3 normal =
            -0.5 * (a.force.normal_force * a.force.normal + b.force.normal_force * b.force.normal);
        energy.restraint_work -= mean * dot(u, blank);
        energy.normal_work += dot(normal, blank);
        energy.tool_work -= dot(normal - mean * u, tool);
    }

    Vec3 relative_velocity(std::size_t i, const At& at, double t) const {
        Vec3 v = blank_velocity(at, t);
        if (stages_.has(Effect::moving_tool)) v = v - scene_.motions[bead_.motion[i]].velocity_at(t, at.x);
        return v;
    }
    double viscous(std::size_t i, const At& at, double t) const {
        const double damper = std::sqrt(at.k * at.contact.mass);
        return std::clamp(damper * dot(relative_velocity(i, at, t), at.force.across), -at.limit, at.limit);
    }

    /// When in (ta, tb] the slider first gives way.
    void note_slip(std::size_t i, double ta, double tb, const At& a, double before) {
        if (history_.first_slip && *history_.first_slip <= ta) return;
        const auto slides = [&](double t) {
            const At m = look(i, t);
            const double way = dot(blank_way(m, ta, t) - bead_way(i, ta, t), m.force.across);
            return std::abs(before + m.k * way) > m.limit;
        };
        double low = ta, high = tb;
        if (std::abs(before) >= a.limit * (1 - 1e-12)) {
            high = ta;
        } else {
            // Nothing to look for when another node has slipped sooner.
            if (history_.first_slip) high = std::min(high, *history_.first_slip);
            if (high < tb && !slides(high)) return;
            for (int k = 0; k < 50; ++k) {
                const double middle = 0.5 * (low + high);
                (slides(middle) ? high : low) = middle;
            }
        }
        history_.first_slip = history_.first_slip ? std::min(*history_.first_slip, high) : high;
    }

    void sample(std::size_t n) {
        StepTotals& totals = history_.steps[n];
        const bool keep = sampling(n);
        const double t = scene_.time[n];
        for (std::size_t i = 0; i < now_.size(); ++i) {
            NodeSample& row = row_[i];
            if (!was_open_) {
                if (keep)
                    row = NodeSample{.node = row.node,
                                     .x = scene_.motions[bead_.motion[i]].placement(t)(bead_.x[i])};
                continue;
            }
            const At& at = now_[i];
            const bool contact = at.status() > 0;
            if (contact && restrains_ && !incremental_)
                q_[i] = viscous(i, at, n + 1 == scene_.time.size() ? std::nextafter(t, 0.0) : t);
            if (!contact && stages_.has(Effect::stick_reset)) q_[i] = 0;
            const Vec3 normal = contact ? -at.force.normal_force * at.force.normal : Vec3{};
            const Vec3 restraint = contact ? -q_[i] * at.force.across : Vec3{};
            if (contact) {
                if (stages_.has(Effect::normal)) count(Effect::normal);
                if (stages_.has(Effect::ramp) && at.status() == 1) {
                    count(Effect::ramp);
                    if (restrains_) count(Effect::ft_ramp);
                    if (at.force.reset) count(Effect::reset);
                }
                totals.normal += normal;
                totals.restraint += restraint;
                totals.couple += cross(at.foot - at.x, normal + restraint);
                totals.normal_sum += std::abs(at.force.normal_force);
                totals.restraint_sum += std::abs(q_[i]);
                ++totals.in_contact;
                if (at.status() == 2) ++totals.on_plateau;
                if (std::abs(q_[i]) > history_.worst_restraint * (1 + 1e-12)) {
                    history_.worst_restraint = std::abs(q_[i]);
                    history_.worst_node = static_cast<uint32_t>(i);
                    history_.worst_time = t;
                }
            }
            if (!keep && stages_.has(Effect::moving)) continue;
            row.segment = at.segment;
            row.found = at.found;
            row.inside = at.contact.on_surface;
            row.xi = at.xi;
            row.eta = at.eta;
            row.distance = at.contact.distance;
            row.penetration = at.force.penetration;
            row.x = at.x;
            row.normal = normal;
            row.restraint = restraint;
        }
    }

    NearMesh mesh_; ///< in the frame of its first node
    std::unique_ptr<ClosestSegment> closest_;
    Kernel kernel_ = nullptr;
    std::vector<double> q_;     ///< slider force
    std::vector<double> share_; ///< of the arc length, along the deck's coordinates
    std::vector<At> then_, now_;
    std::vector<ClosestTrack> track_; ///< of each node, on a blank that keeps its shape
    std::vector<double> corners_;     ///< times at which a step is split
    bool accelerates_ = false;        ///< a velocity changes other than by jumps
    uint32_t reference_ = 0;
    double t_ = 0, shape_of_ = 0;
    bool restrains_ = false, incremental_ = false, one_motion_ = true, deforming_ = false;
    bool was_open_ = false, settled_ = false;
};

} // namespace

std::unique_ptr<BeadRun> make_manual_run(const EvaluationScene& scene, std::size_t bead, EffectSet stages) {
    return std::make_unique<ManualRun>(scene, bead, stages);
}

} // namespace drawbead
