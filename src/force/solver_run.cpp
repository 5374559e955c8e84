#include "contact/rigid_tracks.h"
#include "force/evaluator.h"
#include "force/moving_surface.h"
#include "force/solver_block.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace drawbead {

namespace {

/// One bead under the solver's law: tracking, projection and force in each cycle, at the cycle's positions
/// and the velocities of half a step before. Nodes go through the law N at a time.
template <std::size_t N>
class SolverRun final : public BeadRun {
public:
    SolverRun(const EvaluationScene& scene, const std::vector<MotionSteps>& steps, std::size_t bead,
              EffectSet stages)
        : BeadRun(scene, bead, stages), steps_(steps), blank_(surface_, steps), law_(bead_.law), x_(bead_.x),
          track_(bead_.track), due_(x_.size(), 0.0), tool_motions_(bead_.motion), half_chord_(x_.size()),
          s_(x_.size(), 0.0), lanes_((x_.size() + N - 1) / N) {
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
        kernel_ = solver_block_kernel<N>(effects);
        std::sort(tool_motions_.begin(), tool_motions_.end());
        tool_motions_.erase(std::unique(tool_motions_.begin(), tool_motions_.end()), tool_motions_.end());
        take_half_chords();
        take_capacities();
        for (std::size_t i = 0; i < x_.size(); ++i)
            take_segment(i);
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
        cycle(n);
    }

    void leave_window() {
        open_ = settled_ = false;
        for (SolverLanes<N>& lanes : lanes_)
            lanes.normal = {}, lanes.restraint = {}, lanes.stored_energy = {};
        for (NodeSample& sample : row_)
            sample = NodeSample{.node = sample.node, .x = sample.x};
    }

    void cycle(std::size_t n) {
        if (!deforming_) {
            const Vec3 velocity = steps_[surface_.motion.front()].velocity_of(n);
            for (RowVec3<N>& row : block_.segment_v)
                for (std::size_t lane = 0; lane < N; ++lane)
                    row.set(lane, velocity);
        }
        if (stages_.has(Effect::variation)) sum_arcs();
        length_ = stages_.has(Effect::variation) && s_.back() > 0 ? s_.back() : 1;
        keep_ = sampling(n) || !stages_.has(Effect::moving);
        settled_ = n > 0;
        block_.dt = scene_.dt[n];
        block_.books = stages_.has(Effect::energy);
        block_.stores = bead_.iform != 1;
        for (std::size_t first = 0; first < x_.size(); first += N) {
            const std::size_t nodes = std::min(N, x_.size() - first);
            SolverLanes<N>& lanes = lanes_[first / N];
            for (std::size_t lane = 0; lane < nodes; ++lane)
                prepare(first + lane, n, lane);
            kernel_(law_, lanes, block_);
            for (std::size_t lane = 0; lane < nodes; ++lane)
                take(first + lane, n, lanes, lane);
        }
        if (block_.books && n > 0) count(Effect::energy, x_.size());
        if (deforming_) count(Effect::deforming_blank, x_.size());
        if (stages_.has(Effect::thickness)) count(Effect::thickness, x_.size());
        if (stages_.has(Effect::reset)) count(Effect::reset, x_.size());
        count(Effect::edge, x_.size());
    }

    /// What the law asks for of node i.
    void prepare(std::size_t i, std::size_t n, std::size_t lane) {
        if (deforming_ || moved_ >= due_[i]) settled_ = follow(i, n) && settled_;
        const SegmentNodes& nodes = surface_.mesh.segment[track_[i].segment];
        for (std::size_t k = 0; k < 4; ++k)
            block_.segment_x[k].set(lane, blank_.at(nodes[k], n));
        if (deforming_)
            for (std::size_t k = 0; k < 4; ++k)
                block_.segment_v[k].set(lane, blank_.velocity(nodes[k], n));
        block_.x.set(lane, x_[i]);
        block_.half_chord.set(lane, half_chord_[i]);
        block_.s_fraction[lane] = s_[i] / length_;
        if (block_.books) block_.tool_velocity.set(lane, tool_velocity(i, n));
    }

    /// What the law asks for of the segment under node i.
    void take_segment(std::size_t i) {
        SolverLanes<N>& lanes = lanes_[i / N];
        const std::size_t lane = i % N;
        const uint32_t number = track_[i].segment;
        const SegmentNodes& nodes = surface_.mesh.segment[number];
        const SegmentStiffness& stiffness = surface_.stiffness[number];
        for (std::size_t k = 0; k < 4; ++k)
            lanes.mass[k][lane] = surface_.mass[nodes[k]];
        lanes.stiffness[lane] = stiffness.k;
        lanes.half_thickness[lane] = stages_.has(Effect::thickness) ? stiffness.half_thickness : 0;
        lanes.slope[lane] = bead_.slope.ramp;
        if (stages_.has(Effect::reset))
            lanes.slope[lane] = bead_.slope_read[i] ? *bead_.slope_read[i] : bead_.slope.of(stiffness.k);
    }

    void take(std::size_t i, std::size_t n, const SolverLanes<N>& lanes, std::size_t lane) {
        add(history_.steps[n], i, n, lanes, lane);
        if (!keep_) return;
        NodeSample& sample = row_[i];
        sample.segment = track_[i].segment;
        sample.found = true;
        sample.inside = block_.inside[lane] != 0;
        sample.xi = block_.xi[lane];
        sample.eta = block_.eta[lane];
        sample.distance = block_.distance[lane];
        sample.penetration = block_.penetration[lane];
        sample.x = x_[i];
        sample.normal = lanes.normal[lane];
        sample.restraint = lanes.restraint[lane];
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
        if (track.segment != before.segment) take_segment(i);
        return track.nearest == before.nearest && track.segment == before.segment;
    }

    void add(StepTotals& totals, std::size_t i, std::size_t n, const SolverLanes<N>& lanes,
             std::size_t lane) {
        const double penetration = block_.penetration[lane];
        if (penetration > 0) {
            totals.normal += lanes.normal[lane];
            totals.restraint += lanes.restraint[lane];
            totals.couple += block_.couple[lane];
            totals.normal_sum += std::abs(block_.normal_size[lane]);
            const double restraint = block_.restraint_size[lane];
            totals.restraint_sum += restraint;
            ++totals.in_contact;
            const bool plateau = penetration >= law_.depth;
            if (plateau) ++totals.on_plateau;
            if (stages_.has(Effect::normal)) count(Effect::normal);
            if (stages_.has(Effect::normal) && !plateau) {
                count(Effect::ramp);
                if (block_.ramp_share[lane] != 1) count(Effect::ft_ramp);
            }
            if (stages_.has(restraint_)) count(restraint_);
            const double t = scene_.time[n];
            if (!history_.first_contact) history_.first_contact = t;
            if (plateau && !history_.first_plateau) history_.first_plateau = t;
            if (!history_.first_slip && block_.ft_limit[lane] != 0 && restraint > 0 &&
                (restraint_ == Effect::incremental ? block_.slip[lane] != 0
                                                   : block_.limited[lane] >= block_.ft_limit[lane]))
                history_.first_slip = t;
            if (!touched_[i]) touched_[i] = 1, ++history_.ever_in_contact;
            if (restraint > history_.worst_restraint * (1 + 1e-12)) {
                history_.worst_restraint = restraint;
                history_.worst_node = static_cast<uint32_t>(i);
                history_.worst_time = t;
            }
        }
        if (!block_.books) return;
        BeadEnergy& energy = history_.energy;
        energy.stored += block_.stored_change[lane];
        // Before the first cycle there is no way, but a negative Ft stores a force in it already.
        const double restraint_work = n > 0 ? block_.restraint_work[lane] : 0;
        if (n > 0) {
            energy.normal_work += block_.normal_work[lane];
            energy.restraint_work += restraint_work;
            energy.tool_work -= block_.tool_work[lane];
        }
        const double taken = -restraint_work - block_.stored_change[lane];
        (taken >= 0 ? energy.dissipated : energy.created) += std::abs(taken);
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

    const std::vector<MotionSteps>& steps_;
    MovingSurface blank_;
    BeadLaw<double> law_;
    SolverBlockKernel<N> kernel_ = nullptr;
    SolverBlock<N> block_; ///< of the nodes at hand
    double length_ = 1;    ///< of the bead
    bool keep_ = false;    ///< samples of this cycle
    std::vector<Vec3> x_;
    std::vector<Track> track_;
    std::vector<double> due_;          ///< way at which the node's track is to be looked at again
    std::optional<RigidTracks> rigid_; ///< of a blank that does not deform
    Vec3 gone_;                        ///< displacement of such a blank
    std::vector<uint32_t> tool_motions_;
    std::vector<Vec3> half_chord_;
    std::vector<double> s_;
    std::vector<SolverLanes<N>> lanes_; ///< N nodes each
    double moved_ = 0;
    Effect restraint_ = Effect::incremental; ///< its own of the two
    bool deforming_ = false, one_motion_ = false, tool_turns_ = false;
    bool open_ = false, settled_ = false;
};

} // namespace

std::unique_ptr<BeadRun> make_solver_run(const EvaluationScene& scene, const std::vector<MotionSteps>& steps,
                                         std::size_t bead, EffectSet stages) {
    if (runs_four_lanes()) return std::make_unique<SolverRun<4>>(scene, steps, bead, stages);
    return std::make_unique<SolverRun<2>>(scene, steps, bead, stages);
}

} // namespace drawbead
