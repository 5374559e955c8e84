#pragma once
// Runs beads through their prescribed motion under one of the two laws.
#include "force/evaluation.h"
#include "force/plan.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace drawbead {

/// How often each stage did its work, by Effect.
using EffectCounts = std::array<uint64_t, effect_count>;

/// One bead under one law. Beads are independent of each other, so that threads may take one each.
class BeadRun {
public:
    virtual ~BeadRun() = default;
    /// Computes the steps [begin, end), which follow on those before.
    void advance(std::size_t begin, std::size_t end);
    /// To be called once after the last step.
    virtual void finish() {}

    const BeadHistory& history() const { return history_; }
    const EffectCounts& counts() const { return counts_; }
    /// A node came to the rim of the surface's mesh: a larger part of the surface is needed.
    bool at_rim() const { return at_rim_; }

    /// Samples of the nodes at steps that `every` divides, since the last call; in order of steps, then
    /// nodes. Kept only when asked for.
    void keep_samples(std::size_t every) { every_ = every; }
    struct Sampled {
        std::size_t step = 0;
        std::vector<NodeSample> nodes;
    };
    std::vector<Sampled> take_samples() { return std::move(samples_); }

protected:
    BeadRun(const EvaluationScene& scene, std::size_t bead, EffectSet stages);
    virtual void step(std::size_t n) = 0;

    bool sampling(std::size_t n) const;
    void count(Effect e, uint64_t times = 1) { counts_[static_cast<std::size_t>(e)] += times; }
    /// Impulse, capacities and firsts that follow from the totals of steps n − 1 and n.
    void book(std::size_t n);

    const EvaluationScene& scene_;
    const EvaluationBead& bead_;
    const EvaluationSurface& surface_;
    EffectSet stages_;
    BeadHistory history_;
    EffectCounts counts_{};
    std::vector<NodeSample> row_; ///< of the step at hand
    std::vector<uint8_t> touched_;
    bool at_rim_ = false;

private:
    std::size_t every_ = 0;
    std::vector<Sampled> samples_;
};

/// `stages` ⊇ plan().needed(): what is computed. Scene and steps must outlive the run.
std::unique_ptr<BeadRun> make_run(const EvaluationScene&, const std::vector<MotionSteps>&, std::size_t bead,
                                  Law, EffectSet stages);
std::unique_ptr<BeadRun> make_solver_run(const EvaluationScene&, const std::vector<MotionSteps>&,
                                         std::size_t bead, EffectSet stages);
std::unique_ptr<BeadRun> make_manual_run(const EvaluationScene&, std::size_t bead, EffectSet stages);

/// The first step at which two histories differ, the number of steps when only their sums do; empty when
/// they have the same bits, 0 and −0 alike.
std::optional<std::size_t> first_difference(const BeadHistory&, const BeadHistory&);

/// The first step at which a total is no finite number, the number of steps when only an energy or impulse is
/// not; empty when all are.
std::optional<std::size_t> first_not_finite(const BeadHistory&);

} // namespace drawbead
