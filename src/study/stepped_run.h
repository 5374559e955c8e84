#pragma once
// The manual's law by plain time stepping under settings.
#include "force/evaluator.h"
#include "study/settings.h"

#include <cstdint>
#include <memory>

namespace drawbead {

/// What a run cost.
struct StudyCounts {
    uint64_t evaluations = 0; ///< of the law at a point of a line
    uint64_t searches = 0;    ///< of the whole surface
    uint64_t follows = 0;     ///< of tracks, one ring each
    uint64_t projections = 0; ///< on one segment, of those that a search does not give
    uint64_t instants = 0;    ///< ends of steps, with those at kinks

    StudyCounts& operator+=(const StudyCounts& o) {
        evaluations += o.evaluations;
        searches += o.searches;
        follows += o.follows;
        projections += o.projections;
        instants += o.instants;
        return *this;
    }
    friend bool operator==(const StudyCounts&, const StudyCounts&) = default;
};

class SteppedRun : public BeadRun {
public:
    virtual StudyCounts cost() const = 0;
    /// Work of the restraint: Σ∫ q (v_blank − v_bead)·u dt.
    virtual double absorbed() const = 0;

protected:
    using BeadRun::BeadRun;
};

/// The steps are those of `scene.time`, whatever `settings.steps` says; the scene must outlive the run.
std::unique_ptr<SteppedRun> make_stepped_run(const EvaluationScene&, std::size_t bead, const ManualSettings&);

/// Times of `steps` equal steps from `begin` to `end`, and their lengths, into the scene.
void set_steps(EvaluationScene&, double begin, double end, uint64_t steps);

} // namespace drawbead
