#pragma once
// Scenes: a deck, a motion, times and outputs, as YAML (schemas/scene.schema.json).
#include "base/result.h"
#include "force/motion.h"
#include "model/motion.h"
#include "scene/class_motion.h"
#include "study/settings.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

/// Where something stands in the scene's file, from 1.
struct ScenePlace {
    uint64_t line = 0;
    uint32_t column = 0;
};

struct SceneMove {
    MotionTarget target;
    std::size_t motion = 0; ///< index into Scene::motions
    ScenePlace place;
};

struct Scene {
    std::string path;                ///< of the scene's file; empty when it was made from the command line
    std::string deck;                ///< as it can be opened
    std::vector<int64_t> interfaces; ///< empty: all
    ScenePlace interfaces_place;
    bool solver = true, manual = true;
    struct Time {
        std::optional<double> end, step;
        std::optional<uint64_t> steps;
        std::string trace; ///< a recorded run whose times are taken; empty: equal steps
        ScenePlace place;
    } time;
    struct Output {
        uint64_t every = 1;
        std::vector<int64_t> nodes; ///< empty: all
        ScenePlace nodes_place;
        std::string csv, vtu; ///< empty: not wanted; vtu: what the names begin with
    } output;
    std::optional<ManualSettings>
        accuracy; ///< how finely the manual's law is evaluated; empty: exactly in time
    ScenePlace accuracy_steps;
    bool deck_motion = true;
    std::vector<Motion> motions;
    std::vector<SceneMove> moves; ///< one motion may move several things
    /// Tables with their places, to be held against the end of the run.
    struct Table {
        double first = 0, last = 0;
        ScenePlace place;
    };
    std::vector<Table> tables;
};

/// Paths in a scene are relative to its folder.
Result<Scene> read_scene(const std::string& path);
Result<Scene> parse_scene(std::string_view text, const std::string& path);

/// Who moves the nodes, and the targets of Model::build that its moves name.
PrescribedMotion prescribed_by(const Scene&);
std::vector<MotionTarget> targets_of(const Scene&);

/// Times of equal steps; the last one may be shorter when `step` does not divide the end.
std::vector<double> equal_steps(double end, std::optional<double> step, std::optional<uint64_t> steps);

/// An error when a table does not cover the run.
Result<void> check_tables(const Scene&, double end);

} // namespace drawbead
