#include "force/trace_times.h"

#include "force/trace_walk.h"

#include <cmath>

namespace drawbead {

using C = TraceColumn;

TraceTimes times_of(const Trace& trace) {
    TraceTimes out;
    bool uneven = false;
    std::size_t filled = 0;
    each_bead_cycle(trace, [&](std::span<const TraceRow> rows) {
        const TraceRow& row = rows.front();
        const auto cycle = static_cast<std::size_t>(row.integer(C::ncycle));
        if (cycle < out.time.size()) return; // another interface in the same cycle
        const double t = row[C::tt], dt = row[C::dt1];
        const std::size_t known = out.time.size();
        if (cycle > known) {
            const double from = known > 0 ? out.time.back() : 0;
            const std::size_t steps = cycle - known + (known > 0 ? 1 : 0);
            const double step = (t - from) / static_cast<double>(steps);
            if (known == 0) {
                out.time.push_back(0);
                out.dt.push_back(0);
            }
            while (out.time.size() < cycle) {
                out.time.push_back(out.time.back() + step);
                out.dt.push_back(step);
            }
            filled += cycle - known;
            uneven = uneven || std::abs(step - dt) > 1e-6 * dt;
        }
        out.time.push_back(t);
        out.dt.push_back(cycle == 0 ? 0 : dt);
    });
    if (filled > 0)
        out.note = "the record says nothing of " + std::to_string(filled) +
                   " cycles; they count as steps of equal length" +
                   (uneven ? ", though the recorded steps are of another length" : "");
    return out;
}

} // namespace drawbead
