#include "force/evaluator.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace drawbead {

namespace {

/// Equal bits, or both zero of either sign.
bool same(double a, double b) {
    return a == b || std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b);
}
bool same(Vec3 a, Vec3 b) {
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}
bool same(const std::optional<double>& a, const std::optional<double>& b) {
    return a.has_value() == b.has_value() && (!a || same(*a, *b));
}
bool same(const StepTotals& a, const StepTotals& b) {
    return same(a.normal, b.normal) && same(a.restraint, b.restraint) && same(a.couple, b.couple) &&
           same(a.normal_sum, b.normal_sum) && same(a.restraint_sum, b.restraint_sum) &&
           a.in_contact == b.in_contact && a.on_plateau == b.on_plateau;
}

bool is_finite(Vec3 a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

} // namespace

std::string_view name(Law law) {
    return law == Law::solver ? "solver" : "manual";
}

BeadRun::BeadRun(const EvaluationScene& scene, std::size_t bead, EffectSet stages)
    : scene_(scene), bead_(scene.beads[bead]), surface_(scene.surfaces[bead_.surface]), stages_(stages),
      row_(bead_.x.size()), touched_(bead_.x.size(), 0) {
    for (uint32_t i = 0; i < row_.size(); ++i) {
        row_[i].node = i;
        row_[i].x = bead_.x[i];
    }
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

std::optional<std::size_t> first_difference(const BeadHistory& a, const BeadHistory& b) {
    for (std::size_t n = 0; n < a.steps.size(); ++n)
        if (!same(a.steps[n], b.steps[n])) return n;
    const BeadEnergy &e = a.energy, &f = b.energy;
    const bool equal = same(e.normal_work, f.normal_work) && same(e.restraint_work, f.restraint_work) &&
                       same(e.tool_work, f.tool_work) && same(e.stored, f.stored) &&
                       same(e.dissipated, f.dissipated) && same(e.created, f.created) &&
                       same(a.impulse, b.impulse) && same(a.first_contact, b.first_contact) &&
                       same(a.first_plateau, b.first_plateau) && same(a.first_slip, b.first_slip) &&
                       a.ever_in_contact == b.ever_in_contact && same(a.worst_restraint, b.worst_restraint) &&
                       a.worst_node == b.worst_node && same(a.worst_time, b.worst_time);
    return equal ? std::nullopt : std::optional(a.steps.size());
}

std::optional<std::size_t> first_not_finite(const BeadHistory& h) {
    for (std::size_t n = 0; n < h.steps.size(); ++n) {
        const StepTotals& step = h.steps[n];
        if (!is_finite(step.normal) || !is_finite(step.restraint) || !is_finite(step.couple) ||
            !std::isfinite(step.normal_sum) || !std::isfinite(step.restraint_sum))
            return n;
    }
    const BeadEnergy& e = h.energy;
    for (const double value :
         {e.normal_work, e.restraint_work, e.tool_work, e.stored, e.dissipated, e.created, h.worst_restraint})
        if (!std::isfinite(value)) return h.steps.size();
    return is_finite(h.impulse) ? std::nullopt : std::optional(h.steps.size());
}

} // namespace drawbead
