#pragma once
// The times of a scene: equal steps, or those of a recorded run.
#include "base/result.h"
#include "cli/scene_file.h"

#include <string>
#include <vector>

namespace drawbead {

struct SceneTimes {
    std::vector<double> time, dt; ///< dt[n] from time[n−1] to time[n]; dt[0] = 0
    std::string note;             ///< what was assumed; empty: nothing
};

/// Reads the record when the scene names one. An error, too, when a table of the scene does not cover the
/// run.
Result<SceneTimes> times_of(const Scene&);

} // namespace drawbead
