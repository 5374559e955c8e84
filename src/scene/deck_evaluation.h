#pragma once
// From a model to a scene that can be evaluated: which nodes move how, and what the beads meet.
#include "base/result.h"
#include "force/evaluation.h"
#include "model/model.h"
#include "scene/class_motion.h"
#include "scene/deck_contact.h"

#include <limits>
#include <string>
#include <vector>

namespace drawbead {

inline constexpr Needs needs_evaluation = needs_contact | Needs::motion;

struct EvaluationRequest {
    std::vector<InterfaceId> interfaces; ///< empty: all
    PrescribedMotion prescribed;
    std::vector<double> time, dt;
    unsigned threads = 1;
    /// At least so much travel is allowed for around the beads; infinity: the whole surface is kept.
    double travel = 0;
};

/// An interface that cannot be evaluated, and why.
struct LeftOut {
    InterfaceId id = 0;
    std::string why;
};

struct DeckEvaluation {
    EvaluationScene scene;
    std::vector<int64_t> rank; ///< by bead of the scene: among the deck's interfaces, the solver's `nin`
    std::vector<std::optional<int64_t>> tool; ///< by bead: the rigid body that holds its first node
    std::vector<LeftOut> left_out;
    std::vector<std::string> notes; ///< what was assumed
    double travel = 0;              ///< allowed for
};

/// An error when an asked interface does not exist.
/// The model must be read with needs_evaluation.
Result<DeckEvaluation> evaluation_of(const Model&, const EvaluationRequest&);

} // namespace drawbead
