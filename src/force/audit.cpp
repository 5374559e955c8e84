#include "force/audit.h"

#include "contact/solver_search.h"
#include "force/comparison.h"
#include "force/record_check.h"
#include "force/solver_kernels.h"
#include "force/trace_walk.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace drawbead {

namespace {

using C = TraceColumn;

SegmentState<double> segment_state(const TraceRow& row) {
    SegmentState<double> segment;
    for (std::size_t k = 0; k < 4; ++k) {
        segment.x[k] = vector_at(row, after(C::x1, 3 * k));
        segment.v[k] = vector_at(row, after(C::vx1, 3 * k));
        segment.mass[k] = row[after(C::m1, k)];
    }
    segment.stiffness = row[C::stf];
    segment.half_thickness = row[C::gapn];
    return segment;
}

/// Recomputes the law.
class LawCheck {
public:
    explicit LawCheck(const std::vector<AuditInterface>& interfaces) {
        for (const AuditInterface& bead : interfaces)
            states_.emplace_back(bead.nodes.size());
    }

    void bead_cycle(const AuditInterface& bead, std::size_t which, std::span<const TraceRow> rows) {
        const bool varies = bead.law.fn_last != 0 || bead.law.ft_last != 0;
        const SolverKernel kernel = solver_kernel(effects_of(bead.law, bead.iform));
        const std::size_t n = rows.size();
        std::vector<double> s(n, 0.0);
        if (varies)
            for (std::size_t i = 1; i < n; ++i)
                s[i] = s[i - 1] + distance(vector_at(rows[i - 1], C::xi), vector_at(rows[i], C::xi));
        for (std::size_t i = 0; i < n; ++i) {
            const TraceRow& row = rows[i];
            NodeInput<double> node;
            node.x = vector_at(row, C::xi);
            node.half_chord = 0.5 * (vector_at(rows[std::min(i + 1, n - 1)], C::xi) -
                                     vector_at(rows[i > 0 ? i - 1 : 0], C::xi));
            node.s_fraction = varies && s.back() > 0 ? s[i] / s.back() : 0;
            node.slope = row[C::slopen_ig];
            node.dt = row[C::dt1];
            NodeState<double>& state = states_[which][i];
            const NodeForce<double> f = kernel(bead.law, segment_state(row), node, state);
            compare(row, f, state, bead, s[i], s.back());
        }
    }

    std::vector<const Comparison*> all() const {
        return {&inside_,        &xi_,          &weights_, &normal_,    &distance_,
                &depth_,         &penetration_, &arc_,     &across_,    &length_,
                &tributary_,     &speed_,       &limits_,  &restraint_, &normal_force_,
                &normal_vector_, &tangential_,  &total_,   &stored_};
    }

private:
    void compare(const TraceRow& row, const NodeForce<double>& f, const NodeState<double>& state,
                 const AuditInterface& bead, double s, double total) {
        inside_.add(row[C::xface], f.at.inside ? 1 : 0, row);
        xi_.add(row[C::ssc], f.at.xi, row);
        xi_.add(row[C::ttc], f.at.eta, row);
        for (std::size_t k = 0; k < 4; ++k)
            weights_.add(row[after(C::h1, k)], f.at.weight[k], row);
        // The Engine fills it where it computes the normal force, and leaves zeros elsewhere.
        normal_.add(row, C::segnx, bead.law.fn_first != 0 ? f.at.normal : Vec3{});
        distance_.add(row[C::dist], f.at.distance, row);
        depth_.add(row[C::depth], bead.law.depth, row);
        penetration_.add(row[C::pen], f.penetration, row);
        across_.add(row, C::tgx, f.across);
        length_.add(row[C::li2], f.length_squared, row);
        tributary_.add(row[C::trib], std::sqrt(f.length_squared), row);
        speed_.add(row[C::vv], f.speed, row);
        limits_.add(row[C::ftlim], f.ft_limit, row);
        limits_.add(row[C::fnlim], f.fn_limit, row);
        arc_.add(row[C::distlin], s, row);
        arc_.add(row[C::disttot], total, row);
        restraint_.add(row[C::fni], -f.restraint, row);
        normal_force_.add(row[C::fnni], f.normal_force, row);
        normal_vector_.add(row, C::fnx, f.normal);
        tangential_.add(row, C::ftx, f.tangential);
        total_.add(row, C::fx, f.total);
        stored_.add(row, C::ftsavx, state.stored);
    }

    std::vector<std::vector<NodeState<double>>> states_;
    Comparison inside_{"inside", Agreement::law}, xi_{"xi, eta", Agreement::law},
        weights_{"weights", Agreement::law}, normal_{"segment normal", Agreement::law},
        distance_{"distance", Agreement::law}, depth_{"depth", Agreement::law},
        penetration_{"penetration", Agreement::law}, arc_{"arc length", Agreement::law},
        across_{"tributary vector", Agreement::law}, length_{"squared length", Agreement::law},
        tributary_{"tributary length", Agreement::law}, speed_{"speed", Agreement::law},
        limits_{"limits", Agreement::law}, restraint_{"restraint", Agreement::law},
        normal_force_{"normal force", Agreement::law, true},
        normal_vector_{"normal vector", Agreement::law, true},
        tangential_{"tangential vector", Agreement::law, true}, total_{"total force", Agreement::law, true},
        stored_{"stored force", Agreement::law, true};
};

/// Compares what the Starter fixes per segment with the deck.
class DeckCheck {
public:
    explicit DeckCheck(const AuditDeck& deck) : deck_(deck) {
        for (const AuditSurface& surface : deck.surfaces) {
            auto& segments = segments_.emplace_back();
            const NearMesh& mesh = surface.mesh;
            for (uint32_t i = 0; i < mesh.segment.size(); ++i) {
                std::array<uint32_t, 4> ids;
                for (std::size_t k = 0; k < 4; ++k)
                    ids[k] = mesh.node_id[mesh.segment[i][k]];
                segments.emplace(ids, i);
            }
            double smallest = std::numeric_limits<double>::infinity();
            std::vector<double> k;
            for (const auto& one : surface.segment) {
                if (!one) break;
                smallest = std::min(smallest, one->smallest);
                k.push_back(one->k);
            }
            const bool all = k.size() == surface.segment.size();
            smallest_.push_back(all ? std::optional(smallest) : std::nullopt);
            k_.push_back(all ? std::move(k) : std::vector<double>{});
        }
    }

    Result<void> bead_cycle(const AuditInterface& bead, std::span<const TraceRow> rows, const Trace& trace) {
        const std::size_t s = bead.surface;
        const AuditSurface& surface = deck_.surfaces[s];
        std::optional<SlopeChoice> slope;
        if (smallest_[s]) slope = choose_slope(bead.law.fn_first, bead.law.depth, *smallest_[s]);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const TraceRow& row = rows[i];
            const auto [first, last] = segments_[s].equal_range(segment_of(row));
            if (first == last) {
                if (!deck_.adaptive)
                    return Error{"the surface of interface " + std::to_string(bead.id) + " has no segment " +
                                     std::to_string(row.integer(C::seg_n1)) + " " +
                                     std::to_string(row.integer(C::seg_n2)) + " " +
                                     std::to_string(row.integer(C::seg_n3)) + " " +
                                     std::to_string(row.integer(C::seg_n4)),
                                 trace.path, row.line, 0, "is this the trace of this deck?"};
                ++refined;
            } else if (std::next(first) != last || !surface.segment[first->second]) {
                ++unknown;
            } else {
                const SegmentStiffness& one = *surface.segment[first->second];
                stiffness_.add(row[C::stf], one.k, row);
                gap_.add(row[C::gapn], one.half_thickness, row);
                if (slope) slope_.add(row[C::slopen_seg], slope->of(one.k), row);
            }
            if (!slope) continue;
            const auto read = slope_read(*slope, k_[s], surface.segment.size(), i);
            if (read)
                slope_read_.add(row[C::slopen_ig], *read, row);
            else
                ++slope_outside;
        }
        return {};
    }

    std::vector<const Comparison*> all() const { return {&stiffness_, &gap_, &slope_, &slope_read_}; }

    uint64_t refined = 0;       ///< rows on segments that adaptive meshing made
    uint64_t unknown = 0;       ///< rows whose segment has a stiffness that the tool cannot work out
    uint64_t slope_outside = 0; ///< rows whose slope the Engine reads past the end of its table

private:
    const AuditDeck& deck_;
    std::vector<std::multimap<std::array<uint32_t, 4>, uint32_t>> segments_; ///< user ids -> local segment
    std::vector<std::optional<double>> smallest_;
    std::vector<std::vector<double>> k_; ///< in storage order
    Comparison stiffness_{"blank stiffness", Agreement::law}, gap_{"half thickness", Agreement::law},
        slope_{"slope of the segment", Agreement::law}, slope_read_{"slope read", Agreement::law};
};

/// Replays the search of one bead.
class SearchCheck {
public:
    SearchCheck(const NearMesh& mesh, const AuditInterface& bead) : mesh_(mesh), blank_(mesh) {
        if (mesh.segment.empty()) return;
        const StartSearch search(mesh, bead.start);
        for (const Vec3& x : bead.start)
            if (const auto start = solver_start(search, mesh, x)) track_.push_back(*start);
    }

    void bead_cycle(const AuditInterface& bead, bool adaptive, std::span<const TraceRow> rows,
                    AuditSearch& out) {
        if (track_.size() != rows.size()) {
            out.unchecked = "the start of the search is not known";
            return;
        }
        if (adaptive) {
            out.unchecked = "adaptive meshing makes nodes and segments that the deck does not have";
            return;
        }
        if (!blank_.follow(rows)) {
            out.unchecked =
                blank_.why_not() + ": positions of nodes outside the recorded segments are not known";
            return;
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const SolverHit hit = solver_step(track_[i], mesh_, blank_.x(), vector_at(rows[i], C::xi));
            const auto theirs = segment_of(rows[i]);
            ++out.rows;
            std::array<uint32_t, 4> ours;
            for (std::size_t k = 0; k < 4; ++k)
                ours[k] = mesh_.node_id[mesh_.segment[hit.segment][k]];
            if (ours == theirs) {
                ++out.same;
            } else if (out.line == 0) {
                out.line = rows[i].line;
                out.cycle = rows[i].integer(C::ncycle);
                out.interface_id = bead.id;
                out.node = rows[i].integer(C::node);
                std::copy(theirs.begin(), theirs.end(), out.recorded.begin());
                std::copy(ours.begin(), ours.end(), out.replayed.begin());
            }
        }
    }

private:
    const NearMesh& mesh_;
    RigidBlank blank_;
    std::vector<Track> track_;
};

/// Feeds one bead's book with recorded forces, weights and velocities.
class BeadEnergies {
public:
    explicit BeadEnergies(std::size_t nodes) : book_(nodes) {}

    /// Into the first cycle the force grows from 0, over the step that its stored force knows.
    void bead_cycle(std::span<const TraceRow> rows) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const TraceRow& row = rows[i];
            Vec3 velocity;
            for (std::size_t k = 0; k < 4; ++k)
                velocity += row[after(C::h1, k)] * vector_at(row, after(C::vx1, 3 * k));
            const double k = row[C::stf];
            const double stored = k > 0 ? squared_norm(vector_at(row, C::ftsavx)) / (2 * k) : 0;
            book_.step(i, {vector_at(row, C::fnx), vector_at(row, C::ftx), stored}, row[C::dt1] * velocity);
        }
    }

    BeadEnergy energy() const { return book_.energy(); }

private:
    EnergyBook book_;
};

/// Each interface has rows in each cycle of its time window, and one time is that of all.
class Attendance {
public:
    explicit Attendance(const AuditDeck& deck) : deck_(deck), last_(deck.interfaces.size(), -1) {}

    Result<void> bead_cycle(std::size_t which, std::span<const TraceRow> rows, const Trace& trace) {
        const TraceRow& first = rows.front();
        if (first.integer(C::ncycle) != cycle_) {
            if (auto whole = finish(trace); !whole) return whole;
            cycle_ = first.integer(C::ncycle);
            time_ = first[C::tt];
            ++cycles_;
        } else if (first[C::tt] != time_) {
            return Error{"cycle " + std::to_string(cycle_) + " has two times", trace.path, first.line, 0,
                         "rows are damaged or swapped"};
        }
        last_[which] = cycle_;
        line_ = rows.back().line;
        return {};
    }

    /// At the end of a cycle.
    Result<void> finish(const Trace& trace) const {
        if (cycles_ == 0) return {};
        for (std::size_t which = 0; which < last_.size(); ++which) {
            const AuditInterface& bead = deck_.interfaces[which];
            if (last_[which] >= 0 && last_[which] != cycle_ && is_open(bead))
                return Error{"interface " + std::to_string(bead.id) + " has no rows in cycle " +
                                 std::to_string(cycle_) + ", but its time window is open",
                             trace.path, line_, 0, "the trace is cut: take the whole file"};
        }
        return {};
    }

    uint64_t cycles() const { return cycles_; }
    /// Whether the record says nothing of an interface.
    bool is_absent(std::size_t which) const { return last_[which] < 0; }

private:
    bool is_open(const AuditInterface& bead) const { return time_ >= bead.t_start && time_ <= bead.t_stop; }

    const AuditDeck& deck_;
    std::vector<int64_t> last_; ///< cycle with rows, by interface; -1: none so far
    int64_t cycle_ = -1;
    double time_ = 0;
    uint64_t line_ = 0, cycles_ = 0;
};

Result<void> check_rows(std::span<const TraceRow> rows, const AuditDeck& deck, const Trace& trace) {
    const TraceRow& first = rows.front();
    const auto fail = [&](const TraceRow& row, const std::string& message) {
        return Error{message, trace.path, row.line, 0, "is this the trace of this deck?"};
    };
    const int64_t nin = first.integer(C::nin);
    if (nin < 1 || static_cast<std::size_t>(nin) > deck.interfaces.size())
        return fail(first, "interface number " + std::to_string(nin) + ", the deck has " +
                               std::to_string(deck.interfaces.size()));
    const AuditInterface& bead = deck.interfaces[static_cast<std::size_t>(nin - 1)];
    if (rows.size() != bead.nodes.size())
        return fail(first, std::to_string(rows.size()) + " nodes in cycle " +
                               std::to_string(first.integer(C::ncycle)) + ", the group of interface " +
                               std::to_string(bead.id) + " has " + std::to_string(bead.nodes.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].integer(C::node) != bead.nodes[i])
            return fail(rows[i], "node " + std::to_string(rows[i].integer(C::node)) +
                                     " where the group of interface " + std::to_string(bead.id) +
                                     " lists node " + std::to_string(bead.nodes[i]));
    if (first.integer(C::ncycle) == 0) { // nothing has moved yet
        double size = 0;
        for (const Vec3& x : bead.start)
            size = std::max({size, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (distance(vector_at(rows[i], C::xi), bead.start[i]) > 1e-9 * size)
                return fail(rows[i], "node " + std::to_string(bead.nodes[i]) +
                                         " begins in another place than in the deck");
    }
    if (first[C::tt] < bead.t_start || first[C::tt] > bead.t_stop)
        return fail(first, "a row outside the time window of interface " + std::to_string(bead.id));
    return {};
}

} // namespace

void number_by_drawbead(Trace& trace, const AuditDeck& deck) {
    std::map<int64_t, std::size_t> place;
    for (std::size_t i = 0; i < deck.interfaces.size(); ++i)
        place.emplace(deck.interfaces[i].rank, i + 1);
    for (const TraceRow& row : trace.rows)
        if (!place.contains(row.integer(C::nin))) return;
    for (TraceRow& row : trace.rows)
        row.value[static_cast<std::size_t>(C::nin)] = static_cast<double>(place[row.integer(C::nin)]);
}

Result<AuditResult> audit(const Trace& trace, const AuditDeck& deck, const AuditOptions& options) {
    AuditResult result;
    LawCheck law(deck.interfaces);
    DeckCheck starter(deck);
    RecordCheck record(deck);
    std::vector<SearchCheck> search;
    std::vector<BeadEnergies> books;
    for (const AuditInterface& bead : deck.interfaces) {
        search.emplace_back(deck.surfaces[bead.surface].mesh, bead);
        books.emplace_back(bead.nodes.size());
    }
    Attendance attendance(deck);
    std::optional<Error> failure;
    each_bead_cycle(trace, [&](std::span<const TraceRow> rows) {
        if (failure) return;
        const auto fits = [&](const Result<void>& check) {
            if (!check) failure = check.error();
            return !failure;
        };
        if (!fits(check_rows(rows, deck, trace))) return;
        const auto which = static_cast<std::size_t>(rows.front().integer(C::nin) - 1);
        const AuditInterface& bead = deck.interfaces[which];
        if (!fits(attendance.bead_cycle(which, rows, trace)) ||
            !fits(starter.bead_cycle(bead, rows, trace)) || !fits(record.bead_cycle(which, rows, trace)))
            return;
        law.bead_cycle(bead, which, rows);
        search[which].bead_cycle(bead, deck.adaptive, rows, result.search);
        books[which].bead_cycle(rows);
    });
    if (!failure)
        if (const auto whole = attendance.finish(trace); !whole) failure = whole.error();
    if (failure) return *failure;
    result.rows = trace.rows.size();
    result.cycles = attendance.cycles();
    for (const BeadEnergies& book : books)
        result.energies.push_back(book.energy());

    for (const Comparison* c : law.all())
        if (c->is_force()) result.force_scale = std::max(result.force_scale, c->scale());
    const auto judge = [&](const std::vector<const Comparison*>& all) {
        for (const Comparison* c : all) {
            if (!c->used()) continue;
            result.quantities.push_back(c->result(c->is_force() ? result.force_scale : c->scale(),
                                                  options.tolerance, deck.interfaces));
            const AuditQuantity& q = result.quantities.back();
            result.within = result.within && q.within;
            if (!q.applies) result.notes.push_back(q.name + ": not followed by this run, so not checked");
        }
    };
    judge(law.all());
    judge(starter.all());
    judge(record.all());
    if (result.search.same != result.search.rows) result.within = false;
    const auto note = [&](uint64_t rows, const std::string& what) {
        if (rows > 0) result.notes.push_back(std::to_string(rows) + " rows: " + what);
    };
    note(starter.slope_outside,
         "the slope is taken from the trace, because the Engine read it past the end of its "
         "table (more bead nodes than segments)");
    note(starter.refined, "on segments that adaptive meshing made, which the deck cannot confirm");
    note(starter.unknown, "on segments whose stiffness the deck does not tell; it is taken from the trace");
    for (std::size_t i = 0; i < deck.interfaces.size(); ++i)
        if (attendance.is_absent(i))
            result.notes.push_back("no rows of interface " + std::to_string(deck.interfaces[i].id));
    if (!result.search.unchecked.empty())
        result.notes.push_back("segment choice not checked: " + result.search.unchecked);
    return result;
}

} // namespace drawbead
