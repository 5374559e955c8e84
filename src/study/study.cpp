#include "study/study.h"

#include "base/parallel.h"
#include "force/plan.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace drawbead {

namespace {

constexpr std::size_t coarsest = 3, finest = 13; // powers of two of the steps
constexpr uint64_t shifts = 8;                   // of the grid, for orders
constexpr std::size_t most_compared = 20'000;    // ends of the scene's steps at which laws meet the reference
constexpr std::array<Quantity, quantity_count> quantities{
    Quantity::restraint,  Quantity::largest_restraint, Quantity::normal,    Quantity::work,
    Quantity::dissipated, Quantity::first_slip,        Quantity::worst_node};

double& of(Errors& e, Quantity q) {
    return e[static_cast<std::size_t>(q)];
}
double of(const Errors& e, Quantity q) {
    return e[static_cast<std::size_t>(q)];
}

/// |a − b| over |b|; where b is nothing beside `scale`, over that.
double relative(double a, double b, double scale) {
    const double apart = std::abs(a - b);
    if (apart == 0) return 0;
    const double by = std::abs(b) > 1e-6 * scale ? std::abs(b) : scale;
    return by > 0 ? apart / by : 1;
}

void raise(Errors& to, const Errors& by) {
    for (std::size_t i = 0; i < quantity_count; ++i)
        to[i] = std::max(to[i], by[i]);
}

BeadValues values_of(const BeadHistory& h, double absorbed) {
    BeadValues v;
    for (const StepTotals& s : h.steps) {
        v.largest_restraint = std::max(v.largest_restraint, norm(s.restraint));
        v.normal = std::max(v.normal, norm(s.normal));
    }
    v.work = absorbed;
    v.dissipated = absorbed - h.energy.stored;
    v.first_slip = h.first_slip;
    v.worst = h.worst_restraint;
    v.worst_node = h.worst_node;
    return v;
}

BeadValues values_of(const ReferenceBead& r) {
    return {r.restraint_largest, r.normal_largest, r.absorbed, r.dissipated(), r.worst,
            r.worst_node,        r.first_slip};
}

/// All but the restraint over time.
Errors errors_of(const BeadValues& v, const ReferenceBead& truth, double end) {
    const BeadValues t = values_of(truth);
    Errors e{};
    of(e, Quantity::largest_restraint) =
        relative(v.largest_restraint, t.largest_restraint, t.largest_restraint);
    of(e, Quantity::normal) = relative(v.normal, t.normal, t.normal);
    of(e, Quantity::work) = relative(v.work, t.work, truth.gross);
    of(e, Quantity::dissipated) = relative(v.dissipated, t.dissipated, truth.gross);
    of(e, Quantity::worst_node) = relative(v.worst, t.worst, t.worst);
    if (v.first_slip && t.first_slip)
        of(e, Quantity::first_slip) = relative(*v.first_slip, *t.first_slip, end);
    else if (v.first_slip || t.first_slip)
        of(e, Quantity::first_slip) = 1;
    return e;
}

/// Largest norm of the difference of restraints at every `stride`-th of `time`, which the reference knows.
/// And its mean over the steps.
double over_time(const std::vector<double>& time, const std::vector<StepTotals>& steps,
                 const ReferenceBead& truth, double* mean = nullptr, std::size_t stride = 1) {
    double most = 0, sum = 0;
    std::size_t at = 0, count = 0;
    for (std::size_t n = 0; n < time.size(); n += stride) {
        while (at + 1 < truth.time.size() && truth.time[at] < time[n])
            ++at;
        const double apart = norm(steps[n].restraint - truth.restraint[at]);
        most = std::max(most, apart);
        sum += apart;
        ++count;
    }
    if (mean && truth.restraint_largest > 0)
        *mean = std::max(*mean, sum / static_cast<double>(count) / truth.restraint_largest);
    return truth.restraint_largest > 0 ? most / truth.restraint_largest : most > 0 ? 1 : 0;
}

class StudyRun {
public:
    StudyRun(const EvaluationScene& scene, const std::vector<MotionSteps>& steps, const StudyOptions& options)
        : given_(scene), steps_(steps), options_(options), work_(scene), begin_(scene.time.front()),
          end_(scene.time.back()) {
        for (const EvaluationBead& bead : scene.beads)
            out_.points += bead.x.size();
        out_.stride = (scene.time.size() - 1 + most_compared - 1) / most_compared;
        out_.stride = std::max<std::size_t>(out_.stride, 1);
    }

    Study run() {
        levels();
        references();
        if (out_.rim) return std::move(out_);
        laws();
        rows();
        if (out_.rim) return std::move(out_);
        picks();
        if (!out_.rows.empty()) front();
        orders();
        times();
        return std::move(out_);
    }

private:
    void say(std::size_t done, std::size_t all, const std::string& what) const {
        if (options_.progress) options_.progress(done, all, what);
    }

    void levels() {
        const double cap = static_cast<double>(options_.most_evaluations) /
                           static_cast<double>(std::max<uint64_t>(out_.points, 1));
        last_level_ = coarsest + 3;
        while (last_level_ < finest && std::ldexp(1.0, static_cast<int>(last_level_) + 1) <= cap)
            ++last_level_;
        order_level_ = std::min<std::size_t>(last_level_, 9);
        grid_level_ = std::max(last_level_, order_level_ + 3); // shifts by eighths
    }

    uint64_t steps_at(std::size_t level) const { return uint64_t{1} << level; }

    /// Ends of the steps of every setting, and the scene's own.
    std::vector<double> reference_times(bool halved) const {
        EvaluationScene grid;
        set_steps(grid, begin_, end_, steps_at(halved ? grid_level_ - 1 : grid_level_));
        std::set<double> all(grid.time.begin(), grid.time.end());
        for (std::size_t n = 0; !halved && n < given_.time.size(); n += out_.stride)
            all.insert(given_.time[n]);
        if (!halved && options_.own) {
            set_steps(grid, begin_, end_, options_.own->steps);
            all.insert(grid.time.begin(), grid.time.end());
        }
        return {all.begin(), all.end()};
    }

    void references() {
        const std::vector<double> times = reference_times(false), coarse = reference_times(true);
        ReferenceOptions options{options_.truth, 5e-6, options_.threads};
        const std::size_t beads = given_.beads.size();
        std::map<Truth, Errors> readings;
        for (std::size_t b = 0; b < beads; ++b) {
            say(b, beads, "reference");
            options.truth = options_.truth;
            options.line_tolerance = 5e-6;
            out_.reference.push_back(reference_of(given_, b, times, options));
            const ReferenceBead& truth = out_.reference.back();
            options.line_tolerance = 3e-5;
            Errors apart = between(reference_of(given_, b, coarse, options), truth);
            for (const double e : apart)
                out_.reference_error = std::max(out_.reference_error, e);
            for (const Truth other : {Truth::line, Truth::nodes, Truth::arc}) {
                if (other == options_.truth) continue;
                options.truth = other;
                options.line_tolerance = 5e-6;
                ReferenceBead reading =
                    reference_of(given_, b, other == Truth::nodes ? times : coarse, options);
                raise(readings[other], between(reading, truth));
                if (other == Truth::nodes) nodes_.push_back(std::move(reading));
            }
            if (options_.truth == Truth::nodes) nodes_.push_back(truth);
            const EvaluationBead& bead = given_.beads[b];
            for (const double edge : {bead.t_start, bead.t_stop})
                out_.kinked = out_.kinked || (edge > begin_ && edge < end_);
            out_.kinked = out_.kinked || truth.at_a_blow;
        }
        for (const auto& [other, errors] : readings)
            out_.readings.emplace_back(other, errors);
        for (const Motion& motion : given_.motions) {
            const std::vector<double> corners = motion.corners(begin_, end_);
            double fastest = norm(motion.velocity(begin_));
            for (const double t : corners)
                fastest = std::max(fastest, norm(motion.velocity(t)));
            for (const double t : corners) {
                const double left = std::nextafter(t, begin_);
                const double jump = norm(motion.velocity(t) - motion.velocity(left));
                out_.kinked = out_.kinked || jump > 1e-6 * fastest;
                out_.kinked = out_.kinked ||
                              (motion.turn && motion.turn->angle.slope(t) != motion.turn->angle.slope(left));
            }
        }
    }

    Errors between(const ReferenceBead& a, const ReferenceBead& truth) const {
        Errors e = errors_of(values_of(a), truth, end_);
        std::vector<StepTotals> steps(a.time.size());
        for (std::size_t n = 0; n < steps.size(); ++n)
            steps[n].restraint = a.restraint[n];
        of(e, Quantity::restraint) = over_time(a.time, steps, truth);
        return e;
    }

    /// Both laws at the scene's own steps.
    void laws() {
        for (const Law law : {Law::solver, Law::manual})
            for (std::size_t b = 0; b < given_.beads.size(); ++b) {
                const auto run = make_run(given_, steps_, b, law, EffectSet::all());
                run->advance(0, given_.time.size());
                run->finish();
                out_.rim = out_.rim || run->at_rim();
                const BeadHistory& h = run->history();
                Errors e =
                    errors_of(values_of(h, h.energy.dissipated + h.energy.stored), out_.reference[b], end_);
                of(e, Quantity::restraint) =
                    over_time(given_.time, h.steps, out_.reference[b], nullptr, out_.stride);
                raise(law == Law::solver ? out_.solver : out_.evaluate, e);
                (law == Law::solver ? out_.solver_of_bead : out_.evaluate_of_bead).push_back(e);
            }
    }

    StudyRow measured(const ManualSettings& settings) {
        StudyRow row;
        row.settings = settings;
        const std::size_t beads = given_.beads.size();
        row.values.resize(beads);
        row.errors.resize(beads);
        set_steps(work_, begin_, end_, settings.steps);
        for (std::size_t b = 0; b < beads; ++b)
            measure(row, b, settings);
        for (const Errors& e : row.errors)
            raise(row.worst, e);
        row.at_floor = row.error() <= 4 * floor();
        return row;
    }

    void measure(StudyRow& row, std::size_t b, const ManualSettings& settings) {
        measure(row, b, settings, out_.reference[b]);
    }
    void measure(StudyRow& row, std::size_t b, const ManualSettings& settings, const ReferenceBead& truth) {
        const auto run = make_stepped_run(work_, b, settings);
        run->advance(0, work_.time.size());
        run->finish();
        out_.rim = out_.rim || run->at_rim();
        row.cost += run->cost();
        row.values[b] = values_of(run->history(), run->absorbed());
        row.errors[b] = errors_of(row.values[b], truth, end_);
        of(row.errors[b], Quantity::restraint) =
            over_time(work_.time, run->history().steps, truth, &row.mean_restraint);
    }

    bool has_corners() const {
        for (const Motion& motion : given_.motions)
            if (!motion.corners(begin_, end_).empty()) return true;
        for (const EvaluationBead& bead : given_.beads)
            for (const double t : {bead.t_start, bead.t_stop})
                if (t > begin_ && t < end_) return true;
        return false;
    }

    double mean_deficit(std::size_t stride) const {
        double sum = 0;
        std::size_t count = 0;
        for (const EvaluationBead& bead : given_.beads)
            for (std::size_t i = stride; i + stride < bead.x.size(); i += stride) {
                const double hops =
                    0.5 * (distance(bead.x[i - stride], bead.x[i]) + distance(bead.x[i], bead.x[i + stride]));
                const double chord = 0.5 * norm(bead.x[i + stride] - bead.x[i - stride]);
                if (hops > 0) sum += 1 - chord / hops, ++count;
            }
        return count > 0 ? sum / static_cast<double>(count) : 0;
    }

    double floor() const { return std::max(out_.reference_error, 1e-13); }

    /// The row of these settings, measured when it is new.
    std::size_t row_of(const ManualSettings& settings) {
        const auto known = std::find_if(out_.rows.begin(), out_.rows.end(),
                                        [&](const StudyRow& row) { return row.settings == settings; });
        if (known != out_.rows.end()) return static_cast<std::size_t>(known - out_.rows.begin());
        out_.rows.push_back(measured(settings));
        return out_.rows.size() - 1;
    }

    /// Each line rule and way of stepping, with steps that double.
    void rows() {
        if (options_.own) row_of(*options_.own);
        std::vector<ManualSettings> columns;
        std::vector<std::pair<LineRule, Tributary>> lines{{{LineRule::Kind::nodes, 2}, Tributary::chord}};
        if (mean_deficit(1) > 1e-13) lines.push_back({{LineRule::Kind::nodes, 2}, Tributary::arc});
        for (const uint32_t m : {2u, 4u, 8u, 16u, 32u})
            lines.push_back({{LineRule::Kind::points, m}, Tributary::chord});
        lines.push_back({{LineRule::Kind::adaptive, 2}, Tributary::chord});
        for (const Kinks kinks : {Kinks::stepped, Kinks::split})
            for (const auto& [line, tributary] : lines) {
                if (kinks == Kinks::split && !has_corners()) continue;
                ManualSettings s;
                s.kinks = kinks;
                s.line = line;
                s.tributary = tributary;
                columns.push_back(s);
            }
        for (std::size_t c = 0; c < columns.size(); ++c) {
            int rested = 0;
            uint64_t evaluations = 0;
            double before = std::numeric_limits<double>::infinity();
            for (std::size_t level = coarsest; level <= last_level_ && !out_.rim; ++level) {
                ManualSettings s = columns[c];
                s.steps = steps_at(level);
                // Twice as many steps cost twice as much; what lines cost is seen with fewer.
                const uint64_t most = s.line.kind == LineRule::Kind::nodes ? options_.most_evaluations
                                                                           : options_.most_evaluations / 2;
                if (level > coarsest && 2 * evaluations > most) break;
                say(c, columns.size(), brief(s));
                const StudyRow& row = out_.rows[row_of(s)];
                evaluations = row.cost.evaluations;
                const double error = row.error();
                // The floor, be it rounding or another knob's: finer steps change nothing more.
                rested = error > 0.9 * before || error <= floor() ? rested + 1 : 0;
                before = std::min(before, error);
                if (rested >= 3 && (error <= 0.02 || s.kinks == Kinks::split)) break;
            }
        }
    }

    /// Errors below the floor are as good as one another: rounding chooses nothing.
    double counted_error(const StudyRow& row) const { return std::max(row.error(), floor()); }

    /// Where even the error ties, the knobs decide in a fixed order: what is nearer to the defaults comes
    /// first.
    auto price(const StudyRow& row) const {
        const StudyCounts& c = row.cost;
        const ManualSettings& s = row.settings;
        return std::tuple(c.evaluations, c.searches, s.projection, counted_error(row),
                          s.number != Number::twice, s.sum != Summing::compensated, s.tributary, s.line.kind,
                          s.line.points, s.kinks, s.steps, s.search);
    }

    std::optional<std::size_t> cheapest(double tolerance) const {
        std::optional<std::size_t> best;
        for (std::size_t i = 0; i < out_.rows.size(); ++i) {
            if (!(out_.rows[i].error() <= tolerance)) continue;
            if (!best || price(out_.rows[i]) < price(out_.rows[*best])) best = i;
        }
        return best;
    }

    /// What the other knobs of a row buy at the same number of evaluations.
    void add_beside(std::size_t row) {
        const ManualSettings base = out_.rows[row].settings;
        say(0, 1, "knobs beside " + brief(base));
        const auto beside = [&](auto change) {
            ManualSettings s = base;
            change(s);
            row_of(s);
        };
        using S = ManualSettings;
        beside([](S& s) { s.projection = Projecting::ratio; });
        beside([](S& s) { s.search = Searching::tracked; });
        beside([](S& s) { s.search = Searching::tracked, s.projection = Projecting::ratio; });
        beside([](S& s) { s.sum = Summing::plain; });
        beside([](S& s) { s.number = Number::single; });
    }

    /// The cheapest within each tolerance. First all rows, then the choice: what is chosen for one tolerance
    /// must not depend on which others are asked for.
    void picks() {
        const auto is_base = [](const ManualSettings& s) {
            const ManualSettings defaults;
            return s.projection == defaults.projection && s.search == defaults.search &&
                   s.sum == defaults.sum && s.number == defaults.number;
        };
        for (std::size_t before = 0; before != out_.rows.size();) {
            before = out_.rows.size();
            for (const double tolerance : options_.tolerances) {
                const auto first = cheapest(tolerance);
                if (!first) continue;
                add_beside(*first);
                // And those that cost as many evaluations: their other knobs may be cheaper still.
                const uint64_t evaluations = out_.rows[*first].cost.evaluations;
                for (std::size_t i = 0; i < before; ++i)
                    if (out_.rows[i].cost.evaluations == evaluations && out_.rows[i].error() <= tolerance &&
                        is_base(out_.rows[i].settings))
                        add_beside(i);
            }
        }
        for (const double tolerance : options_.tolerances) {
            StudyPick pick;
            pick.tolerance = tolerance;
            pick.row = cheapest(tolerance);
            for (std::size_t i = 0; i < out_.rows.size(); ++i)
                if (std::pair(counted_error(out_.rows[i]), price(out_.rows[i])) <
                    std::pair(counted_error(out_.rows[pick.best]), price(out_.rows[pick.best])))
                    pick.best = i;
            out_.picks.push_back(pick);
        }
    }

    void front() {
        std::vector<std::size_t> order(out_.rows.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            const StudyRow &x = out_.rows[a], &y = out_.rows[b];
            return x.cost.evaluations != y.cost.evaluations ? x.cost.evaluations < y.cost.evaluations
                                                            : price(x) < price(y);
        });
        double best = std::numeric_limits<double>::infinity();
        for (const std::size_t i : order) {
            StudyRow& row = out_.rows[i];
            // Picks cost the least of those with as many evaluations, though not always with the least error.
            row.on_front = row.error() < best;
            best = std::min(best, row.error());
        }
        for (const StudyPick& pick : out_.picks)
            if (pick.row) out_.rows[*pick.row].on_front = true;
    }

    /// In steps: mean over grids that are shifted by parts of a step, so that where in its step a reversal
    /// falls makes no luck of it.
    void step_orders() {
        std::vector<double> size;
        std::vector<Errors> levels;
        ManualSettings s;
        const std::size_t first =
            order_level_ >= 5 ? std::max<std::size_t>(coarsest, order_level_ - 4) : coarsest;
        for (std::size_t level = first; level <= order_level_; ++level) {
            s.steps = steps_at(level);
            say(level - first, order_level_ - first + 1, "order in steps");
            Errors sum{};
            for (uint64_t shift = 0; shift < shifts; ++shift) {
                set_steps(work_, begin_, end_, s.steps * shifts);
                std::vector<double> time{begin_};
                for (std::size_t n = shift == 0 ? shifts : shift; n < work_.time.size() - 1; n += shifts)
                    time.push_back(work_.time[n]);
                time.push_back(end_);
                work_.time = std::move(time);
                work_.dt.assign(1, 0);
                for (std::size_t n = 1; n < work_.time.size(); ++n)
                    work_.dt.push_back(work_.time[n] - work_.time[n - 1]);
                Errors worst{};
                StudyRow row;
                row.values.resize(given_.beads.size());
                row.errors.resize(given_.beads.size());
                for (std::size_t b = 0; b < given_.beads.size(); ++b) {
                    // Nodes against nodes: without what the line adds.
                    measure(row, b, s, nodes_[b]);
                    raise(worst, row.errors[b]);
                }
                // The largest difference over time hangs on how reversals fall against each other; the mean
                // does not.
                of(worst, Quantity::restraint) = row.mean_restraint;
                for (std::size_t i = 0; i < quantity_count; ++i)
                    sum[i] += worst[i] / static_cast<double>(shifts);
            }
            size.push_back(1 / static_cast<double>(s.steps));
            levels.push_back(sum);
        }
        for (const Quantity q : quantities) {
            StudyOrder order;
            order.knob = "steps";
            order.quantity = q == Quantity::restraint ? "restraint, mean" : name(q);
            order.expected = out_.kinked ? 1 : 2;
            order.size = size;
            for (const Errors& e : levels)
                order.error.push_back(of(e, q));
            order.observed = observed_order(order.size, order.error, *order.expected, {1e-11, 0.1});
            out_.orders.push_back(std::move(order));
        }
    }

    /// In parts of a hop: by differences, with the same steps for all.
    void line_orders() {
        std::vector<StudyRow> rows;
        std::vector<double> size;
        ManualSettings s;
        s.kinks = Kinks::split;
        s.steps = steps_at(std::min<std::size_t>(last_level_, 6));
        s.line.kind = LineRule::Kind::points;
        for (const uint32_t m : {2u, 4u, 8u, 16u}) {
            s.line.points = m;
            say(size.size(), 4, "order along the line");
            rows.push_back(measured(s));
            size.push_back(1 / static_cast<double>(m));
        }
        const auto add = [&](Quantity q, double BeadValues::*value) {
            StudyOrder order;
            order.knob = "line";
            order.quantity = name(q);
            order.expected = 2;
            order.size = size;
            std::vector<double> values;
            double scale = 0;
            for (const StudyRow& row : rows) {
                double sum = 0;
                for (const BeadValues& v : row.values)
                    sum += v.*value;
                values.push_back(sum);
                scale = std::max(scale, std::abs(sum));
            }
            for (std::size_t i = 0; i + 1 < values.size(); ++i)
                order.error.push_back(scale > 0 ? std::abs(values[i] - values[i + 1]) / scale : 0);
            order.size.pop_back();
            order.observed = order_of_differences(values, 2, scale);
            out_.orders.push_back(std::move(order));
        };
        add(Quantity::largest_restraint, &BeadValues::largest_restraint);
        add(Quantity::normal, &BeadValues::normal);
        add(Quantity::work, &BeadValues::work);
    }

    /// How much shorter chords are than hops, when every node, every second, every fourth is kept.
    void chord_order() {
        StudyOrder order;
        order.knob = "chord angle";
        order.quantity = "length";
        order.expected = 2;
        for (const std::size_t stride : {4u, 2u, 1u}) {
            order.size.push_back(static_cast<double>(stride));
            order.error.push_back(mean_deficit(stride));
        }
        order.observed = observed_order(order.size, order.error, 2, {1e-13, 0.1});
        // A line with a corner has no small angles.
        if (order.observed.verdict == OrderVerdict::below) order.observed.verdict = OrderVerdict::unresolved;
        out_.orders.push_back(std::move(order));
    }

    /// The sum of limits that vary along a straight line, against mean times length.
    void limit_order() {
        bool any = false;
        double worst = 0;
        for (const EvaluationBead& bead : given_.beads) {
            const BeadLaw<double>& law = bead.law;
            if (law.fn_last == 0 && law.ft_last == 0) continue;
            const std::size_t last = bead.x.size() - 1;
            std::vector<double> s(bead.x.size(), 0.0);
            for (std::size_t i = 1; i <= last; ++i)
                s[i] = s[i - 1] + distance(bead.x[i - 1], bead.x[i]);
            if (!(s[last] > 0) || distance(bead.x[0], bead.x[last]) < s[last] * (1 - 1e-12)) continue;
            for (const auto& [first, end] :
                 {std::pair{law.fn_first, law.fn_last}, {law.ft_first, law.ft_last}}) {
                if (end == 0 || first < 0 || end < 0) continue;
                double sum = 0;
                for (std::size_t i = 0; i <= last; ++i) {
                    const double L = 0.5 * norm(bead.x[std::min(i + 1, last)] - bead.x[i > 0 ? i - 1 : 0]);
                    sum += (first + s[i] / s[last] * (end - first)) * L;
                }
                const double exact = 0.5 * (first + end) * s[last];
                worst = std::max(worst, std::abs(sum - exact) / exact);
                any = true;
            }
        }
        if (!any) return;
        StudyOrder order;
        order.knob = "linear limits";
        order.quantity = "sum of limits";
        order.size = {1};
        order.error = {worst};
        order.observed.verdict = worst <= 1e-13 ? OrderVerdict::exact : OrderVerdict::below;
        out_.orders.push_back(std::move(order));
    }

    void orders() {
        step_orders();
        line_orders();
        chord_order();
        limit_order();
    }

    /// Of the settings on the front, and of those beside the picks.
    void times() {
        if (options_.repeats == 0) return;
        using Clock = std::chrono::steady_clock;
        for (std::size_t i = 0; i < out_.rows.size(); ++i) {
            StudyRow& row = out_.rows[i];
            if (!row.on_front && row.cost.evaluations > 3000) continue;
            say(i, out_.rows.size(), "times");
            set_steps(work_, begin_, end_, row.settings.steps);
            std::vector<double> seconds;
            for (unsigned repeat = 0; repeat < options_.repeats; ++repeat) {
                const auto start = Clock::now();
                for (std::size_t b = 0; b < given_.beads.size(); ++b) {
                    const auto run = make_stepped_run(work_, b, row.settings);
                    run->advance(0, work_.time.size());
                    run->finish();
                }
                seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
            }
            std::sort(seconds.begin(), seconds.end());
            row.median = seconds[seconds.size() / 2];
            row.least = seconds.front();
        }
    }

    const EvaluationScene& given_;
    const std::vector<MotionSteps>& steps_;
    const StudyOptions& options_;
    EvaluationScene work_; ///< with the steps of the run at hand
    double begin_, end_;
    std::vector<ReferenceBead> nodes_; ///< the sum over nodes with chords, by bead
    std::size_t last_level_ = 0, order_level_ = 0, grid_level_ = 0;
    Study out_;
};

} // namespace

std::string_view name(Quantity q) {
    static constexpr std::array<std::string_view, quantity_count> names{
        "restraint", "largest restraint", "normal force", "work", "dissipated", "first slip", "worst node"};
    return names[static_cast<std::size_t>(q)];
}

double StudyRow::error() const {
    return *std::max_element(worst.begin(), worst.end());
}

Study accuracy_study(const EvaluationScene& scene, const std::vector<MotionSteps>& steps,
                     const StudyOptions& options) {
    return StudyRun(scene, steps, options).run();
}

} // namespace drawbead
