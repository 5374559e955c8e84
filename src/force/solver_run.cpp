#include "contact/rigid_tracks.h"
#include "force/evaluator.h"
#include "force/moving_surface.h"
#include "force/solver_kernels.h"
#include "force/solver_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace drawbead {

namespace {

/// One bead under the solver's law: tracking, projection and force in each cycle, at the cycle's positions
/// and the velocities of half a step before.
class SolverRun final : public BeadRun {
public:
    SolverRun(const EvaluationScene& scene, const std::vector<MotionSteps>& steps, std::size_t bead,
              EffectSet stages)
        : BeadRun(scene, bead, stages), steps_(steps), blank_(surface_, steps), law_(bead_.law), x_(bead_.x),
          track_(bead_.track), due_(x_.size(), 0.0), tool_motions_(bead_.motion), state_(x_.size()),
          force_(x_.size()), half_chord_(x_.size()), s_(x_.size(), 0.0) {
        if (law_.fn_first == 0) law_.fn_last = 0; // the solver has no normal force then
        restraint_ = bead_.iform == 1 ? Effect::viscous : Effect::incremental;
        const bool restrains = stages.has(restraint_);
        Effects effects;
        effects.restraint = !restrains         ? Restraint::none
                            : bead_.iform == 1 ? Restraint::viscous
                                               : Restraint::incremental;
        effects.normal = stages.has(Effect::normal);
        effects.varies = stages.has(Effect::variation);
        effects.ramp = stages.has(Effect::ramp);
        effects.share = stages.has(Effect::ft_ramp);
        cycle_ = with_effects(effects, []<Effects E>() { return &SolverRun::cycle<E>; });
        std::sort(tool_motions_.begin(), tool_motions_.end());
        tool_motions_.erase(std::unique(tool_motions_.begin(), tool_motions_.end()), tool_motions_.end());
        take_half_chords();
        take_capacities();
        mass_.reserve(surface_.mesh.segment.size());
        for (const SegmentNodes& nodes : surface_.mesh.segment)
            mass_.push_back({surface_.mass[nodes[0]], surface_.mass[nodes[1]], surface_.mass[nodes[2]],
                             surface_.mass[nodes[3]]});
        const uint32_t one = surface_.motion.empty() ? 0 : surface_.motion.front();
        one_motion_ = std::all_of(surface_.motion.begin(), surface_.motion.end(),
                                  [&](uint32_t m) { return m == one; }) &&
                      !steps_[one].turns;
        deforming_ = stages.has(Effect::deforming_blank) || !one_motion_;
        tool_turns_ = std::any_of(bead_.motion.begin(), bead_.motion.end(),
                                  [&](uint32_t m) { return steps_[m].turns; });
        if (!deforming_ && !surface_.motion.empty()) rigid_.emplace(surface_.mesh, rounding());
    }

private:
    void step(std::size_t n) override {
        if (!stages_.has(Effect::search)) return;
        const double t = scene_.time[n];
        if (n > 0 && stages_.has(Effect::moving_tool)) move_tool(n);
        if (n > 0) note_motion(n);
        if (stages_.has(Effect::window)) {
            count(Effect::window);
            if (t < bead_.t_start || t > bead_.t_stop) {
                if (open_) leave_window();
                return;
            }
        }
        open_ = true;
        // Nothing moves and the last cycle left the search where it was: this one would be the same.
        if (!stages_.has(Effect::moving) && settled_) {
            history_.steps[n] = history_.steps[n - 1];
            return;
        }
        if (stages_.has(Effect::moving)) count(Effect::moving);
        (this->*cycle_)(n);
    }

    void leave_window() {
        open_ = settled_ = false;
        std::fill(force_.begin(), force_.end(), Applied{});
        for (NodeSample& sample : row_)
            sample = NodeSample{.node = sample.node, .x = sample.x};
    }

    template <Effects E>
    void cycle(std::size_t n) {
        const Vec3 velocity = deforming_ ? Vec3{} : steps_[surface_.motion.front()].velocity_of(n);
        for (SegmentState<double>& segment : segment_)
            segment.v.fill(velocity);
        if (stages_.has(Effect::variation)) sum_arcs();
        length_ = stages_.has(Effect::variation) && s_.back() > 0 ? s_.back() : 1;
        keep_ = sampling(n) || !stages_.has(Effect::moving);
        settled_ = n > 0;
        constexpr bool forceless = E.restraint == Restraint::none && !E.normal;
        for (std::size_t first = 0; first < x_.size(); first += side_by_side) {
            const std::size_t nodes = std::min(side_by_side, x_.size() - first);
            for (std::size_t lane = 0; lane < nodes; ++lane)
                prepare(first + lane, n, segment_[lane], input_[lane]);
            if constexpr (forceless) {
                for (std::size_t lane = 0; lane < nodes; ++lane)
                    take(first + lane, n, where(segment_[lane], input_[lane]), segment_[lane]);
            } else {
                const auto take_lanes = [&](std::size_t, std::size_t count, const auto& force) {
                    for (std::size_t lane = 0; lane < count; ++lane)
                        take(first + lane, n, one_of(force, lane), segment_[lane]);
                };
                drawbead::solver_step<double, E>(
                    law_, std::span<const SegmentState<double>>(segment_.data(), nodes),
                    std::span<const NodeInput<double>>(input_.data(), nodes),
                    std::span(state_).subspan(first, nodes), take_lanes);
            }
        }
        if (stages_.has(Effect::thickness)) count(Effect::thickness, x_.size());
        if (stages_.has(Effect::reset)) count(Effect::reset, x_.size());
        count(Effect::edge, x_.size());
    }

    /// What the law asks for of node i.
    void prepare(std::size_t i, std::size_t n, SegmentState<double>& segment, NodeInput<double>& in) {
        if (deforming_ || moved_ >= due_[i]) settled_ = follow(i, n) && settled_;
        const uint32_t number = track_[i].segment;
        const SegmentNodes& nodes = surface_.mesh.segment[number];
        for (std::size_t k = 0; k < 4; ++k)
            segment.x[k] = blank_.at(nodes[k], n);
        if (deforming_) {
            count(Effect::deforming_blank);
            for (std::size_t k = 0; k < 4; ++k)
                segment.v[k] = blank_.velocity(nodes[k], n);
        }
        segment.mass = mass_[number];
        segment.stiffness = surface_.stiffness[number].k;
        if (stages_.has(Effect::thickness))
            segment.half_thickness = surface_.stiffness[number].half_thickness;
        in.x = x_[i];
        in.half_chord = half_chord_[i];
        in.s_fraction = s_[i] / length_;
        in.dt = scene_.dt[n];
        in.slope = bead_.slope.ramp;
        if (stages_.has(Effect::reset))
            in.slope = bead_.slope_read[i] ? *bead_.slope_read[i] : bead_.slope.of(segment.stiffness);
    }

    /// Where a node is when nothing can act on it.
    NodeForce<double> where(const SegmentState<double>& segment, const NodeInput<double>& in) const {
        NodeForce<double> f;
        f.at = project(segment.x, in.x);
        f.penetration = law_.depth > 0
                            ? (law_.depth - f.at.distance + segment.half_thickness) * (f.at.inside ? 1 : 0)
                            : 1;
        return f;
    }

    /// One lane of what take() looks at.
    [[gnu::always_inline]] static NodeForce<double> one_of(const NodeForce<Lanes<double>>& f,
                                                           std::size_t lane) {
        const auto vector = [lane](const BasicVec3<Lanes<double>>& v) {
            return Vec3{v.x[lane], v.y[lane], v.z[lane]};
        };
        NodeForce<double> out;
        out.at.inside = f.at.inside[lane] != 0;
        out.at.xi = f.at.xi[lane];
        out.at.eta = f.at.eta[lane];
        for (std::size_t k = 0; k < 4; ++k)
            out.at.weight[k] = f.at.weight[k][lane];
        out.at.distance = f.at.distance[lane];
        out.penetration = f.penetration[lane];
        out.ft_limit = f.ft_limit[lane];
        out.restraint = f.restraint[lane];
        out.ramp_share = f.ramp_share[lane];
        out.normal_force = f.normal_force[lane];
        out.normal = vector(f.normal);
        out.tangential = vector(f.tangential);
        out.total = vector(f.total);
        out.slip = f.slip[lane];
        return out;
    }

    [[gnu::always_inline]] void take(std::size_t i, std::size_t n, const NodeForce<double>& f,
                                     const SegmentState<double>& segment) {
        add(history_.steps[n], i, f, segment, n);
        if (!keep_) return;
        NodeSample& sample = row_[i];
        sample.segment = track_[i].segment;
        sample.found = true;
        sample.inside = f.at.inside;
        sample.xi = f.at.xi;
        sample.eta = f.at.eta;
        sample.distance = f.at.distance;
        sample.penetration = f.penetration;
        sample.x = x_[i];
        sample.normal = f.normal;
        sample.restraint = f.tangential;
    }

    /// Searches where the track may change; whether it stayed.
    bool follow(std::size_t i, std::size_t n) {
        Track& track = track_[i];
        const Track before = track;
        if (deforming_) {
            count(Effect::search);
            blank_.bring_rings(track.nearest, n);
            blank_.bring_segment(track.segment, n);
            at_rim_ = !solver_follow(track, surface_.mesh, blank_.x(), x_[i]) || at_rim_;
        } else {
            Now now(blank_, n);
            const RigidTracks::Step step = rigid_->follow(track, x_[i] - gone_, x_[i], now);
            if (step.searched) count(Effect::search);
            at_rim_ = !step.complete || at_rim_;
            due_[i] = moved_ + step.margin;
        }
        return track.nearest == before.nearest && track.segment == before.segment;
    }

    void add(StepTotals& totals, std::size_t i, const NodeForce<double>& f,
             const SegmentState<double>& segment, std::size_t n) {
        const bool contact = f.penetration > 0;
        const bool incremental = restraint_ == Effect::incremental;
        if (contact) {
            totals.normal += f.normal;
            totals.restraint += f.tangential;
            const Vec3 foot = f.at.weight[0] * segment.x[0] + f.at.weight[1] * segment.x[1] +
                              f.at.weight[2] * segment.x[2] + f.at.weight[3] * segment.x[3];
            totals.couple += cross(foot - x_[i], f.total);
            totals.normal_sum += std::abs(f.normal_force);
            const double restraint = norm(f.tangential);
            totals.restraint_sum += restraint;
            ++totals.in_contact;
            const bool plateau = f.penetration >= law_.depth;
            if (plateau) ++totals.on_plateau;
            if (stages_.has(Effect::normal)) count(Effect::normal);
            if (stages_.has(Effect::normal) && !plateau) {
                count(Effect::ramp);
                if (f.ramp_share != 1) count(Effect::ft_ramp);
            }
            if (stages_.has(restraint_)) count(restraint_);
            const double t = scene_.time[n];
            if (!history_.first_contact) history_.first_contact = t;
            if (plateau && !history_.first_plateau) history_.first_plateau = t;
            if (!history_.first_slip && f.ft_limit != 0 && restraint > 0 &&
                (incremental ? f.slip != 0 : f.restraint >= f.ft_limit))
                history_.first_slip = t;
            if (!touched_[i]) touched_[i] = 1, ++history_.ever_in_contact;
            if (restraint > history_.worst_restraint * (1 + 1e-12)) {
                history_.worst_restraint = restraint;
                history_.worst_node = static_cast<uint32_t>(i);
                history_.worst_time = t;
            }
        }
        if (stages_.has(Effect::energy)) book_energy(i, f, segment, n);
    }

    /// By the trapezium rule: velocities stand halfway between two forces.
    void book_energy(std::size_t i, const NodeForce<double>& f, const SegmentState<double>& segment,
                     std::size_t n) {
        Applied& before = force_[i];
        const double k = segment.stiffness;
        const bool stores = bead_.iform != 1 && k > 0 && f.ft_limit != 0;
        const double stored = stores ? squared_norm(state_[i].stored) / (2 * k) : 0;
        if (n > 0) {
            count(Effect::energy);
            Vec3 v;
            for (std::size_t j = 0; j < 4; ++j)
                v += f.at.weight[j] * segment.v[j];
            const double half = 0.5 * scene_.dt[n];
            BeadEnergy& energy = history_.energy;
            const double restraint_work = half * dot(before.restraint + f.tangential, v);
            energy.normal_work += half * dot(before.normal + f.normal, v);
            energy.restraint_work += restraint_work;
            energy.tool_work -= half * dot(before.normal + before.restraint + f.total, tool_velocity(i, n));
            const double taken = -restraint_work - (stored - before.stored);
            (taken >= 0 ? energy.dissipated : energy.created) += std::abs(taken);
        }
        history_.energy.stored += stored - before.stored;
        before = {f.normal, f.tangential, stored};
    }

    Vec3 tool_velocity(std::size_t i, std::size_t n) const {
        const MotionSteps& m = steps_[bead_.motion[i]];
        return m.turns && n > 0 ? m.rate[n] * (m.placements[n](bead_.x[i]) - m.placements[n - 1](bead_.x[i]))
                                : m.velocity_of(n);
    }

    void move_tool(std::size_t n) {
        count(Effect::moving_tool, x_.size());
        for (std::size_t i = 0; i < x_.size(); ++i) {
            const MotionSteps& m = steps_[bead_.motion[i]];
            if (m.turns)
                x_[i] = m.placements[n](bead_.x[i]);
            else if (!m.increment.empty())
                x_[i] += m.increment[n];
            row_[i].x = x_[i];
        }
        take_half_chords();
    }

    /// How far the blank has come, and bead nodes against it at most.
    void note_motion(std::size_t n) {
        if (deforming_ || !stages_.has(Effect::moving)) return;
        const MotionSteps& blank = steps_[surface_.motion.front()];
        const Vec3 base = blank.increment.empty() ? Vec3{} : blank.increment[n];
        gone_ += base;
        if (tool_turns_) {
            moved_ = HUGE_VAL; // looked at in every step
            return;
        }
        double most = 0;
        for (const uint32_t m : tool_motions_) {
            const MotionSteps& tool = steps_[m];
            most = std::max(most, norm((tool.increment.empty() ? Vec3{} : tool.increment[n]) - base));
        }
        moved_ += most;
    }

    /// How far the distance of a bead node and a node of the blank may be off at any step, when the blank is
    /// taken as it was and the node as far back as the blank has come: sums of increments, rounded each time.
    double rounding() const {
        double size = 0;
        const auto reach = [&](Vec3 x) {
            size = std::max({size, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
        };
        for (const Vec3& x : x_)
            reach(x);
        for (const Vec3& x : surface_.mesh.x)
            reach(x);
        double way = 0;
        const auto path = [&](const MotionSteps& m) {
            for (const Vec3& step : m.increment)
                way += norm(step);
        };
        path(steps_[surface_.motion.front()]);
        for (const uint32_t m : tool_motions_)
            path(steps_[m]);
        constexpr double unit = std::numeric_limits<double>::epsilon();
        return unit * (size + way) * (16 + 4 * static_cast<double>(scene_.time.size()));
    }

    void take_half_chords() {
        const std::size_t last = x_.size() - 1;
        for (std::size_t i = 0; i < x_.size(); ++i)
            half_chord_[i] = 0.5 * (x_[std::min(i + 1, last)] - x_[i > 0 ? i - 1 : 0]);
    }

    void sum_arcs() {
        count(Effect::variation, x_.size());
        for (std::size_t i = 1; i < x_.size(); ++i)
            s_[i] = s_[i - 1] + norm(x_[i] - x_[i - 1]);
    }

    void take_capacities() {
        double length = 0;
        for (std::size_t i = 1; i < x_.size(); ++i)
            length += norm(x_[i] - x_[i - 1]);
        double s = 0;
        for (std::size_t i = 0; i < x_.size(); ++i) {
            if (i > 0) s += norm(x_[i] - x_[i - 1]);
            const double share = length > 0 ? s / length : 0, tributary = norm(half_chord_[i]);
            if (law_.fn_first != 0)
                history_.normal_capacity +=
                    std::abs(solver_limit(law_.fn_first, law_.fn_last, share)) * tributary;
            history_.restraint_capacity +=
                std::abs(solver_limit(law_.ft_first, law_.ft_last, share)) * tributary;
        }
    }

    /// The blank at the step at hand.
    class Now final : public SurfaceNow {
    public:
        Now(MovingSurface& blank, std::size_t n) : blank_(blank), n_(n) {}
        const Vec3& at(uint32_t node) override { return blank_.at(node, n_); }

    private:
        MovingSurface& blank_;
        std::size_t n_;
    };

    /// What acted in the cycle before.
    struct Applied {
        Vec3 normal, restraint;
        double stored = 0;
    };

    const std::vector<MotionSteps>& steps_;
    MovingSurface blank_;
    BeadLaw<double> law_;
    void (SolverRun::*cycle_)(std::size_t) = nullptr;
    static constexpr std::size_t side_by_side = Lanes<double>::count;
    std::array<SegmentState<double>, side_by_side> segment_; ///< of the nodes at hand
    std::array<NodeInput<double>, side_by_side> input_;
    double length_ = 1; ///< of the bead
    bool keep_ = false; ///< samples of this cycle
    std::vector<Vec3> x_;
    std::vector<Track> track_;
    std::vector<double> due_;          ///< way at which the node's track is to be looked at again
    std::optional<RigidTracks> rigid_; ///< of a blank that does not deform
    Vec3 gone_;                        ///< displacement of such a blank
    std::vector<uint32_t> tool_motions_;
    std::vector<NodeState<double>> state_;
    std::vector<Applied> force_;
    std::vector<Vec3> half_chord_;
    std::vector<double> s_;
    std::vector<std::array<double, 4>> mass_; ///< by segment
    double moved_ = 0;
    Effect restraint_ = Effect::incremental; ///< its own of the two
    bool deforming_ = false, one_motion_ = false, tool_turns_ = false;
    bool open_ = false, settled_ = false;
};

} // namespace

std::unique_ptr<BeadRun> make_solver_run(const EvaluationScene& scene, const std::vector<MotionSteps>& steps,
                                         std::size_t bead, EffectSet stages) {
    return std::make_unique<SolverRun>(scene, steps, bead, stages);
}

} // namespace drawbead
