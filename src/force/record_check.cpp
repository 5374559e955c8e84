#include "force/record_check.h"

#include "force/trace_walk.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

using C = TraceColumn;
constexpr double rounding = 4 * 2.220446049250313e-16;
/// Masses are sums over elements in an order of the solver's own.
constexpr double mass_tolerance = 1e-12;

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

Result<void> RecordCheck::bead_cycle(std::size_t which, std::span<const TraceRow> rows, const Trace& trace) {
    const TraceRow& first = rows.front();
    const int64_t cycle = first.integer(C::ncycle);
    const double time = first[C::tt], dt = first[C::dt1];
    Bead& bead = beads_[which];
    const AuditInterface& interface = deck_.interfaces[which];
    if (!bead.cycle) {
        // The cycle before must have been outside the window, or not have been at all.
        if (cycle > 0 && (interface.t_start <= 0 || time - dt > interface.t_start + rounding * time))
            return Error{"the record of interface " + std::to_string(interface.id) + " begins with cycle " +
                             std::to_string(cycle) + ", but its time window was open before",
                         trace.path, first.line, 0,
                         "take the whole file; after a restart, from the first run on"};
    } else if (cycle != *bead.cycle + 1) {
        return Error{"cycles " + std::to_string(*bead.cycle + 1) + " to " + std::to_string(cycle - 1) +
                         " of interface " + std::to_string(interface.id) + " are missing",
                     trace.path, first.line, 0, "take the whole file"};
    } else {
        // The first cycle after a restart has no step before it.
        if (dt != 0) time_.add(dt, time - bead.time, first, rounding * std::abs(time));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::vector<double> step;
            for (std::size_t i = 0; i < rows.size(); ++i)
                step.push_back(rows[i][after(C::xi, axis)] - bead.x[i].*axes[axis]);
            const double all = median(step);
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const double x = rows[i][after(C::xi, axis)], before = bead.x[i].*axes[axis];
                // A bead at rest repeats its numbers; one that moves does so up to rounding.
                bead_.add(x, before + all, rows[i],
                          all == 0 ? 0 : 2 * rounding * std::max(std::abs(x), std::abs(before)));
            }
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<double> v;
        for (const TraceRow& row : rows)
            for (std::size_t k = 0; k < 4; ++k)
                v.push_back(row[after(C::vx1, 3 * k + axis)]);
        const double all = median(std::move(v));
        for (const TraceRow& row : rows)
            for (std::size_t k = 0; k < 4; ++k)
                translation_.add(row[after(C::vx1, 3 * k + axis)], all, row);
    }
    bead.x.clear();
    bead.slope.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        bead.x.push_back(vector_at(rows[i], C::xi));
        see_nodes(which, rows[i]);
        see_constants(which, i, rows[i]);
    }
    bead.cycle = cycle;
    bead.time = time;
    return {};
}

void RecordCheck::see_nodes(std::size_t which, const TraceRow& row) {
    const int64_t cycle = row.integer(C::ncycle);
    const AuditSurface& surface = deck_.surfaces[deck_.interfaces[which].surface];
    const std::vector<uint32_t>& ids = surface.mesh.node_id;
    for (std::size_t k = 0; k < 4; ++k) {
        const Node now{cycle, vector_at(row, after(C::x1, 3 * k)), vector_at(row, after(C::vx1, 3 * k)),
                       row[after(C::m1, k)]};
        const auto local = std::lower_bound(ids.begin(), ids.end(), segment_of(row)[k]);
        if (local != ids.end() && *local == segment_of(row)[k])
            if (const double mass = surface.mass[static_cast<std::size_t>(local - ids.begin())]; mass > 0)
                deck_mass_.add(now.mass, mass, row, mass_tolerance * mass);
        const auto [at, is_new] =
            nodes_.try_emplace({deck_.interfaces[which].surface, row.integer(after(C::seg_n1, k))}, now);
        if (is_new) continue;
        Node& known = at->second;
        if (known.cycle == cycle) {
            position_.add(row, after(C::x1, 3 * k), known.x);
            velocity_.add(row, after(C::vx1, 3 * k), known.v);
            mass_.add(now.mass, known.mass, row);
            continue;
        }
        if (known.cycle + 1 == cycle)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double x = now.x.*axes[axis], before = known.x.*axes[axis],
                             step = row[C::dt1] * now.v.*axes[axis];
                motion_.add(x, before + step, row,
                            rounding * std::max({std::abs(before), std::abs(step), std::abs(x)}));
            }
        mass_over_run_.add(now.mass, known.mass, row);
        known = now;
    }
}

void RecordCheck::see_constants(std::size_t which, std::size_t i, const TraceRow& row) {
    const Constants now{row[C::stf], row[C::gapn], row[C::slopen_seg]};
    const auto [at, is_new] = constants_.try_emplace({which, segment_of(row)}, now);
    if (!is_new) {
        segment_.add(now.stiffness, at->second.stiffness, row);
        segment_.add(now.half_thickness, at->second.half_thickness, row);
        segment_.add(now.slope, at->second.slope, row);
    }
    if (beads_[which].cycle) slope_.add(row[C::slopen_ig], beads_[which].slope[i], row);
    beads_[which].slope[i] = row[C::slopen_ig];
}

} // namespace drawbead
