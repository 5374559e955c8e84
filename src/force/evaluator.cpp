#include "force/evaluator.h"

#include <algorithm>

namespace drawbead {

std::string_view name(Law law) {
    return law == Law::solver ? "solver" : "manual";
}

BeadRun::BeadRun(const EvaluationScene& scene, std::size_t bead, EffectSet stages)
    : scene_(scene), bead_(scene.beads[bead]), surface_(scene.surfaces[bead_.surface]), stages_(stages),
      row_(bead_.x.size()), touched_(bead_.x.size(), 0) {
    for (uint32_t i = 0; i < row_.size(); ++i)
        row_[i].node = i;
    history_.steps.resize(scene.time.size());
}

bool BeadRun::sampling(std::size_t n) const {
    return every_ > 0 && (n % every_ == 0 || n + 1 == scene_.time.size());
}

void BeadRun::advance(std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
        step(n);
        book(n);
        if (sampling(n)) samples_.push_back({n, row_});
    }
}

void BeadRun::book(std::size_t n) {
    const StepTotals& now = history_.steps[n];
    if (n == 0) return;
    const double half = 0.5 * scene_.dt[n];
    history_.impulse += half * (history_.steps[n - 1].total() + now.total());
}

std::unique_ptr<BeadRun> make_run(const EvaluationScene& scene, const std::vector<MotionSteps>& steps,
                                  std::size_t bead, Law law, EffectSet stages) {
    return law == Law::solver ? make_solver_run(scene, steps, bead, stages)
                              : make_manual_run(scene, bead, stages);
}

} // namespace drawbead
