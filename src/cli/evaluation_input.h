#pragma once
// From a scene's files to what can be evaluated: for `evaluate`, `plan` and `accuracy`.
#include "base/result.h"
#include "cli/options.h"
#include "cli/scene_file.h"
#include "deck/deck.h"
#include "force/plan.h"
#include "model/model.h"
#include "scene/deck_evaluation.h"

#include <memory>
#include <string>
#include <vector>

namespace drawbead {

/// Everything that a run needs, from files.
struct Loaded {
    Scene scene;
    std::unique_ptr<Deck> deck;
    Model model;
    std::vector<double> time, dt;
    std::vector<std::string> notes;
    unsigned threads = 1;
};
Result<Loaded> load_scene(const EvaluateCommand&);

/// The scene with enough of its surfaces for `travel`.
struct Prepared {
    DeckEvaluation evaluation;
    std::vector<MotionSteps> steps;
    std::vector<Law> laws;
    std::vector<std::vector<BeadPlan>> plans; ///< [law][bead]
    std::optional<EvaluationScene> stepped;   ///< of the manual's law, when the scene gives its settings

    const EvaluationScene& scene_of(Law law) const {
        return law == Law::manual && stepped ? *stepped : evaluation.scene;
    }
};
Result<Prepared> prepare_scene(const Loaded&, double travel);

/// The travel to ask for after the surfaces turned out too small; infinity at last: all of them.
double next_travel(const DeckEvaluation&);

bool is_scene_file(const std::string& path);

} // namespace drawbead
