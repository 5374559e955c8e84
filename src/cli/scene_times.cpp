#include "cli/scene_times.h"

#include "force/trace.h"
#include "force/trace_times.h"

namespace drawbead {

Result<SceneTimes> times_of(const Scene& scene) {
    SceneTimes out;
    if (!scene.time.trace.empty()) {
        const Result<Trace> trace = read_trace(scene.time.trace);
        if (!trace) return trace.error();
        TraceTimes times = times_of(*trace);
        out.time = std::move(times.time);
        out.dt = std::move(times.dt);
        out.note = std::move(times.note);
    } else {
        constexpr double most = 1e8;
        if (scene.time.step && *scene.time.end / *scene.time.step > most)
            return Error{"more than 1e8 steps", scene.path, scene.time.place.line, scene.time.place.column,
                         "please give longer steps"};
        out.time = equal_steps(*scene.time.end, scene.time.step, scene.time.steps);
        out.dt.push_back(0);
        for (std::size_t n = 1; n < out.time.size(); ++n)
            out.dt.push_back(out.time[n] - out.time[n - 1]);
    }
    if (auto covered = check_tables(scene, out.time.back()); !covered) return covered.error();
    return out;
}

} // namespace drawbead
