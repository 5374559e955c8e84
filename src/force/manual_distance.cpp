#include "contact/closest_segment.h"
#include "force/audit.h"
#include "force/comparison.h"
#include "force/manual_law.h"
#include "force/trace_walk.h"

#include <algorithm>
#include <map>
#include <optional>

namespace drawbead {

namespace {

using C = TraceColumn;

using Kernel = ManualForce<double> (*)(const BeadLaw<double>&, const ManualContact<double>&,
                                       const ManualInput<double>&, double&);

/// Follows one bead under the manual's law.
class ManualBead {
public:
    ManualBead(const AuditSurface& surface, const AuditInterface& bead)
        : surface_(surface), bead_(bead), blank_(surface.mesh), closest_(surface.mesh),
          kernel_(bead.iform == 1 ? manual_node_force<double, Effects{Restraint::viscous, true, true}>
                                  : manual_node_force<double, Effects{Restraint::incremental, true, true}>),
          q_(bead.nodes.size(), 0.0), length_(bead.nodes.size(), 0.0) {
        for (std::size_t i = 1; i < bead.start.size(); ++i)
            length_[i] = length_[i - 1] + distance(bead.start[i - 1], bead.start[i]);
        for (uint32_t i = 0; i < surface.mesh.segment.size(); ++i) {
            std::array<uint32_t, 4> ids;
            for (std::size_t k = 0; k < 4; ++k)
                ids[k] = surface.mesh.node_id[surface.mesh.segment[i][k]];
            local_.emplace(ids, i);
        }
    }

    void cycle(std::span<const TraceRow> rows, ManualDistance& out) {
        const bool rigid = blank_.follow(rows);
        if (!rigid) out.whole_surface = false;
        const std::size_t n = rows.size();
        const int64_t cycle = rows.front().integer(C::ncycle);
        const double dt = cycle == last_cycle_ + 1 ? rows.front()[C::dt1] : 0;
        for (const TraceRow& row : rows)
            for (std::size_t k = 0; k < 4; ++k)
                mass_[row.integer(after(C::seg_n1, k))] = row[after(C::m1, k)];
        // The window is half open: at Tstop the manual's forces are 0 already.
        const bool open = rows.front()[C::tt] < bead_.t_stop;
        Vec3 restraint, normal, solver_restraint, solver_normal;
        std::vector<Vec3> x;
        for (const TraceRow& row : rows)
            x.push_back(vector_at(row, C::xi));
        for (std::size_t i = 0; i < n; ++i) {
            const TraceRow& row = rows[i];
            solver_normal += vector_at(row, C::fnx);
            solver_restraint += vector_at(row, C::ftx);
            if (!open) continue;
            const ManualContact<double> at = rigid ? on_surface(x[i], row) : on_segment(x[i], row);
            ManualInput<double> in;
            in.half_chord = 0.5 * (x[std::min(i + 1, n - 1)] - x[i > 0 ? i - 1 : 0]);
            in.tributary = norm(in.half_chord);
            in.s_fraction = length_.back() > 0 ? length_[i] / length_.back() : 0;
            if (rigid) {
                in.velocity = blank_.velocity();
            } else {
                for (std::size_t k = 0; k < 4; ++k)
                    in.velocity += row[after(C::h1, k)] * vector_at(row, after(C::vx1, 3 * k));
            }
            if (dt > 0) in.velocity = in.velocity - (x[i] - x_[i]) / dt;
            in.displacement = dt * in.velocity;
            const ManualForce<double> f = kernel_(bead_.law, at, in, q_[i]);
            normal += -f.normal_force * f.normal;
            restraint += -f.restraint * f.across;
        }
        const TraceRow& first = rows.front();
        add(out.restraint, solver_restraint, restraint, first);
        add(out.normal, solver_normal, normal, first);
        ++cycles_;
        last_cycle_ = cycle;
        x_ = std::move(x);
    }

    void finish(ManualDistance& out) const {
        for (ManualDistance::Total* total : {&out.restraint, &out.normal})
            if (cycles_ > 0) total->mean /= static_cast<double>(cycles_);
    }

private:
    static void add(ManualDistance::Total& to, Vec3 solver, Vec3 manual, const TraceRow& row) {
        const double apart = norm(solver - manual);
        to.largest_solver = std::max(to.largest_solver, norm(solver));
        to.largest_manual = std::max(to.largest_manual, norm(manual));
        to.mean += apart;
        if (apart > to.largest || to.line == 0) {
            to.largest = apart;
            to.line = row.line;
            to.cycle = row.integer(C::ncycle);
        }
    }

    /// The closest point of the whole surface: the bead is moved back instead of the blank.
    ManualContact<double> on_surface(Vec3 x, const TraceRow& row) const {
        const ClosestHit hit = closest_.find(x - blank_.moved());
        ManualContact<double> at = constants(hit.found() ? std::optional(hit.segment) : std::nullopt, row);
        if (!hit.found()) {
            at.on_surface = false;
            return at;
        }
        at.normal = hit.foot.normal;
        at.distance = hit.d;
        at.on_surface = hit.in_contact_range();
        at.mass = 0;
        const SegmentNodes& nodes = surface_.mesh.segment[hit.segment];
        const std::size_t count = is_triangle(nodes) ? 3 : 4;
        for (std::size_t k = 0; k < count; ++k) {
            const auto known = mass_.find(surface_.mesh.node_id[nodes[k]]);
            const double mass = known != mass_.end() ? known->second : row[C::m1];
            at.mass += mass / static_cast<double>(count);
        }
        return at;
    }

    ManualContact<double> on_segment(Vec3 x, const TraceRow& row) const {
        Corners corners;
        for (std::size_t k = 0; k < 4; ++k)
            corners[k] = vector_at(row, after(C::x1, 3 * k));
        const Foot foot = closest_point(corners, x);
        const auto local = local_.find(segment_of(row));
        ManualContact<double> at =
            constants(local != local_.end() ? std::optional(local->second) : std::nullopt, row);
        at.normal = foot.normal;
        at.distance = std::copysign(foot.distance, dot(foot.normal, x - foot.point));
        at.on_surface = row[C::xface] != 0;
        at.mass = is_triangle(corners) ? (row[C::m1] + row[C::m2] + row[C::m3]) / 3
                                       : 0.25 * (row[C::m1] + row[C::m2] + row[C::m3] + row[C::m4]);
        return at;
    }

    /// Stiffness and thickness by the deck, else as recorded.
    ManualContact<double> constants(std::optional<uint32_t> segment, const TraceRow& row) const {
        ManualContact<double> at;
        at.stiffness = row[C::stf];
        at.half_thickness = row[C::gapn];
        if (!segment) return at;
        if (surface_.segment[*segment]) at.stiffness = surface_.segment[*segment]->k;
        at.half_thickness = 0.5 * surface_.thickness[*segment];
        // A thickness on the element's card counts in the manual's stiffness too, where the property's does
        // for the solver.
        if (surface_.segment[*segment] && surface_.segment[*segment]->half_thickness > 0)
            at.stiffness *= at.half_thickness / surface_.segment[*segment]->half_thickness;
        return at;
    }

    const AuditSurface& surface_;
    const AuditInterface& bead_;
    RigidBlank blank_;
    ClosestSegment closest_;
    Kernel kernel_;
    std::vector<double> q_, length_; ///< slider force; arc length along the deck's coordinates
    std::vector<Vec3> x_;            ///< of the cycle before
    std::map<int64_t, double> mass_; ///< of nodes seen so far
    std::map<std::array<uint32_t, 4>, uint32_t> local_;
    int64_t last_cycle_ = -2;
    uint64_t cycles_ = 0;
};

} // namespace

double ManualDistance::Total::percent(double difference) const {
    const double scale = largest_manual > 0 ? largest_manual : largest_solver;
    return scale > 0 ? 100 * difference / scale : 0;
}

std::vector<ManualDistance> manual_distance(const Trace& trace, const AuditDeck& deck) {
    std::vector<ManualDistance> out;
    std::vector<ManualBead> beads;
    beads.reserve(deck.interfaces.size());
    for (const AuditInterface& bead : deck.interfaces) {
        out.emplace_back().interface_id = bead.id;
        beads.emplace_back(deck.surfaces[bead.surface], bead);
    }
    each_bead_cycle(trace, [&](std::span<const TraceRow> rows) {
        const auto which = static_cast<std::size_t>(rows.front().integer(C::nin) - 1);
        beads[which].cycle(rows, out[which]);
    });
    for (std::size_t b = 0; b < beads.size(); ++b)
        beads[b].finish(out[b]);
    return out;
}

} // namespace drawbead
