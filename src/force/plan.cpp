#include "force/plan.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace drawbead {

std::string_view name(Effect e) {
    static constexpr std::array<std::string_view, effect_count> names{
        "window",          "search",      "normal",  "ramp",        "thickness",   "reset",
        "ft-ramp",         "variation",   "viscous", "incremental", "stick-reset", "moving",
        "deforming-blank", "moving-tool", "edge",    "energy"};
    return names[static_cast<std::size_t>(e)];
}

std::string_view what(Effect e) {
    static constexpr std::array<std::string_view, effect_count> texts{
        "test of Tstart and Tstop",
        "search for the segment, and projection",
        "normal force",
        "normal force below DEPTH",
        "half thickness",
        "ramp slope by segment",
        "restraint scaled on the ramp",
        "limits along the bead",
        "viscous restraint",
        "incremental restraint",
        "stored force forgotten at lift-off",
        "every step computed",
        "blank deforms",
        "bead moves",
        "contact lost beside the blank",
        "work and energies"};
    return texts[static_cast<std::size_t>(e)];
}

std::string_view name(Verdict v) {
    return v == Verdict::off ? "OFF" : v == Verdict::partly ? "PARTLY" : "ON";
}

EffectSet BeadPlan::needed() const {
    EffectSet set;
    for (std::size_t i = 0; i < effect_count; ++i)
        if (effect[i].verdict != Verdict::off) set.add(static_cast<Effect>(i));
    return set;
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array<double Vec3::*, 3> axes{&Vec3::x, &Vec3::y, &Vec3::z};

struct Box {
    Vec3 lo{infinity, infinity, infinity}, hi{-infinity, -infinity, -infinity};

    void take(Vec3 p) {
        for (const auto axis : axes) {
            lo.*axis = std::min(lo.*axis, p.*axis);
            hi.*axis = std::max(hi.*axis, p.*axis);
        }
    }
};

std::string text(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.4g", value);
    return buffer;
}

std::string with_unit(double value, const std::string& unit) {
    return text(value) + (unit.empty() ? "" : " " + unit);
}

/// Where a motion takes things over the run; empty for a rotation. Exact at the steps, and for the manual's
/// law between them too: the translation has no extremes but where a velocity is zero.
std::optional<Box> travel(const EvaluationScene& scene, const Motion& motion, const MotionSteps& steps,
                          Law law) {
    if (motion.turn) return {};
    Box box;
    box.take({});
    if (!steps.moves) return box;
    if (law == Law::solver) {
        Vec3 at;
        for (const Vec3& step : steps.increment)
            box.take(at += step);
    } else {
        for (const double t : scene.time)
            box.take(motion.displacement(t));
        for (const double t : motion.corners(scene.time.front(), scene.time.back()))
            box.take(motion.displacement(t));
    }
    return box;
}

class Planner {
public:
    Planner(const EvaluationScene& scene, const std::vector<MotionSteps>& steps, std::size_t bead, Law law,
            const PlanOptions& options)
        : scene_(scene), steps_(steps), bead_(scene.beads[bead]), surface_(scene.surfaces[bead_.surface]),
          mesh_(surface_.mesh), law_(law), options_(options), nodes_(bead_.x.size()) {}

    BeadPlan make() {
        look_at_motion();
        look_at_distance();
        steps_open_ = 0;
        for (const double t : scene_.time)
            steps_open_ += in_window(t);
        window();
        motion();
        forces();
        search();
        contact();
        estimate();
        return std::move(plan_);
    }

private:
    using V = Verdict;

    void say(Effect e, Verdict verdict, std::string reason) { plan_[e] = {verdict, std::move(reason), 0}; }
    bool is(Effect e) const { return plan_[e].verdict != V::off; }
    std::string length(double v) const { return with_unit(v, options_.units.length); }
    std::string time(double v) const { return with_unit(v, options_.units.time); }
    bool in_window(double t) const {
        return t >= bead_.t_start && (law_ == Law::solver ? t <= bead_.t_stop : t < bead_.t_stop);
    }

    void look_at_motion() {
        const auto classes = [](std::vector<uint32_t> all) {
            std::sort(all.begin(), all.end());
            all.erase(std::unique(all.begin(), all.end()), all.end());
            return all;
        };
        blank_ = classes(surface_.motion);
        tool_ = classes(bead_.motion);
        const auto still = [&](const std::vector<uint32_t>& motions) {
            return std::all_of(motions.begin(), motions.end(), [&](uint32_t m) {
                return !steps_[m].moves && scene_.motions[m].initial_velocity == Vec3{};
            });
        };
        blank_still_ = still(blank_);
        tool_still_ = still(tool_);
    }

    /// Bounds of the distance of every bead node from every segment near the bead, over the run. Where the
    /// surface deforms or anything turns, nothing is said.
    void look_at_distance() {
        if (blank_.size() != 1 || mesh_.segment.empty()) return;
        const auto blank = travel(scene_, scene_.motions[blank_[0]], steps_[blank_[0]], law_);
        if (!blank) return;
        std::vector<Box> swept(nodes_); // by each node, against the blank
        for (const uint32_t m : tool_) {
            const auto tool = travel(scene_, scene_.motions[m], steps_[m], law_);
            if (!tool) return;
            for (std::size_t i = 0; i < nodes_; ++i)
                if (bead_.motion[i] == m)
                    swept[i] = {bead_.x[i] + tool->lo - blank->hi, bead_.x[i] + tool->hi - blank->lo};
            way_ = std::max(way_, norm(tool->hi - tool->lo));
        }
        way_ += norm(blank->hi - blank->lo);
        // A tracked node is never farther away than the first one plus the path since then, the closest point
        // never farther than that node plus the way.
        const double further = way_ + (law_ == Law::solver ? path() : way_);
        constexpr std::size_t most_pairs = 20'000'000;
        if (nodes_ * mesh_.segment.size() > most_pairs) return;
        std::vector<Facet> facets;
        facets.reserve(mesh_.segment.size());
        for (uint32_t s = 0; s < mesh_.segment.size(); ++s)
            if (!add_facet(s, facets)) return;

        double low = infinity, high = -infinity, size = 0;
        for (std::size_t i = 0; i < nodes_; ++i) {
            const double start = distance(mesh_.x[bead_.track[i].nearest], bead_.x[i]);
            const double reach = (start + further) * (1 + 1e-9);
            if (!mesh_.cells.empty() && mesh_.reach < reach) return; // some of it may be missing
            for (const Facet& facet : facets)
                if (apart(facet.box, swept[i]) <= reach) take_bounds(facet, swept[i], low, high);
            size = std::max({size, norm(swept[i].lo), norm(swept[i].hi)});
        }
        const double slack = 1e-9 * 3 * size;
        plan_.d_low = low - slack;
        plan_.d_high = high + slack;
        plan_.bounded = true;
    }

    /// A segment with the normals that it has: one for the solver, those of its corners by the manual.
    struct Facet {
        Corners corners;
        Box box;
        std::array<Vec3, 5> normal;
        std::size_t normals = 1;
        double spread = 1; ///< least product of two unit normals, the first with another
    };

    /// False: hardly a patch any more.
    bool add_facet(uint32_t segment, std::vector<Facet>& facets) const {
        Facet facet;
        facet.corners = mesh_.corners(segment);
        const Corners& c = facet.corners;
        for (const Vec3& corner : c)
            facet.box.take(corner);
        facet.normal[0] = unit(area_vector(c));
        if (law_ == Law::manual && !is_triangle(c)) // its normal changes over a warped segment
            for (std::size_t k = 0; k < 4; ++k)
                facet.normal[facet.normals++] = patch_normal(c, k == 1 || k == 2 ? 1 : -1, k >= 2 ? 1 : -1);
        for (std::size_t a = 0; a < facet.normals; ++a) {
            if (facet.normal[a] == Vec3{}) return false;
            facet.spread = std::min(facet.spread, dot(facet.normal[0], facet.normal[a]));
        }
        facets.push_back(facet);
        return facet.spread >= 0.5;
    }

    /// Bounds of the signed distance of all points of `node` from all points of a facet.
    static void take_bounds(const Facet& facet, const Box& node, double& low, double& high) {
        double least = infinity, most = -infinity;
        for (std::size_t a = 0; a < facet.normals; ++a)
            for (const Vec3& corner : facet.corners) {
                double from = 0, to = 0;
                for (const auto axis : axes) {
                    const double n = facet.normal[a].*axis;
                    const double p = n * (node.lo.*axis - corner.*axis),
                                 q = n * (node.hi.*axis - corner.*axis);
                    from += std::min(p, q);
                    to += std::max(p, q);
                }
                least = std::min(least, from);
                most = std::max(most, to);
            }
        low = std::min(low, least > 0 ? least * facet.spread : least);
        high = std::max(high, most > 0 ? most / facet.spread : most);
    }

    static double apart(const Box& a, const Box& b) {
        Vec3 gap;
        for (const auto axis : axes)
            gap.*axis = std::max({a.lo.*axis - b.hi.*axis, b.lo.*axis - a.hi.*axis, 0.0});
        return norm(gap);
    }

    /// Length of the path of bead nodes against the blank, at most.
    double path() const {
        const std::vector<Vec3>& blank = steps_[blank_[0]].increment;
        double sum = 0;
        for (std::size_t n = 1; n < scene_.time.size(); ++n) {
            double most = 0;
            for (const uint32_t m : tool_) {
                const std::vector<Vec3>& tool = steps_[m].increment;
                most = std::max(
                    most, norm((tool.empty() ? Vec3{} : tool[n]) - (blank.empty() ? Vec3{} : blank[n])));
            }
            sum += most;
        }
        return sum;
    }

    void window() {
        const double begin = scene_.time.front(), end = scene_.time.back();
        if (steps_open_ == scene_.time.size())
            say(Effect::window, V::off,
                "open from " + time(bead_.t_start) + ", run " + time(begin) + " to " + time(end));
        else
            say(Effect::window, steps_open_ == 0 ? V::on : V::partly,
                "open from " + time(bead_.t_start) + " to " + time(bead_.t_stop) + ": " +
                    std::to_string(steps_open_) + " of " + std::to_string(scene_.time.size()) + " steps");
    }

    void motion() {
        const bool pushed_at_rest =
            law_ == Law::solver && bead_.iform != 1 && (bead_.law.ft_first < 0 || bead_.law.ft_last < 0);
        if (!blank_still_ || !tool_still_)
            say(Effect::moving, V::on, "relative travel up to " + length(way_));
        else if (pushed_at_rest)
            say(Effect::moving, V::on, "a negative Ft pushes at rest too");
        else
            say(Effect::moving, V::off, "nothing moves: one step stands for all");
        if (blank_.size() > 1)
            say(Effect::deforming_blank, V::on,
                std::to_string(blank_.size()) + " groups of its nodes move differently");
        else if (!blank_.empty() && scene_.motions[blank_[0]].turn)
            say(Effect::deforming_blank, V::on, "the blank turns");
        else
            say(Effect::deforming_blank, V::off, "the blank moves as one");
        if (tool_still_)
            say(Effect::moving_tool, V::off, "the bead stands still");
        else
            say(Effect::moving_tool, V::on, std::to_string(tool_.size()) + " motions of bead nodes");
        if (blank_still_ && tool_still_ && !pushed_at_rest)
            say(Effect::energy, V::off, "nothing moves: no work");
        else
            say(Effect::energy, V::on, "work of the forces on blank and bead");
    }

    void forces() {
        const BeadLaw<double>& law = bead_.law;
        const bool manual = law_ == Law::manual;
        const auto per_length = [&](double v) { return with_unit(v, options_.units.force_per_length); };
        const bool fn =
            manual ? law.fn_first > 0 || (law.fn_first != 0 && law.fn_last > 0) : law.fn_first != 0;
        say(Effect::normal, fn ? V::on : V::off,
            "Fn_first = " + per_length(law.fn_first) +
                (law.fn_first == 0 && law.fn_last != 0 ? ": Fn_last alone does nothing" : ""));
        const bool varies = (fn && law.fn_last != 0 && law.fn_last != law.fn_first) ||
                            (law.ft_last != 0 && law.ft_last != law.ft_first);
        say(Effect::variation, varies ? V::on : V::off,
            varies ? "Fn " + text(law.fn_first) + " to " + text(law.fn_last) + ", Ft " + text(law.ft_first) +
                         " to " + text(law.ft_last)
                   : "limits are constant");

        const Effect own = bead_.iform == 1 ? Effect::viscous : Effect::incremental;
        const Effect other = bead_.iform == 1 ? Effect::incremental : Effect::viscous;
        say(other, V::off, "Iform = " + std::to_string(bead_.iform));
        const bool limit =
            manual ? law.ft_first > 0 || law.ft_last > 0 : law.ft_first != 0 || law.ft_last != 0;
        const bool positive = law.ft_first >= 0 && law.ft_last >= 0;
        const bool still = blank_still_ && (!manual || tool_still_);
        if (!limit)
            say(own, V::off, "Ft = 0");
        else if (still && positive)
            say(own, V::off, manual ? "nothing moves" : "the blank stands still");
        else
            say(own, V::on, "Iform = " + std::to_string(bead_.iform) + ", Ft = " + per_length(law.ft_first));
    }

    void search() {
        const double reach = bead_.law.depth + largest_g();
        const bool forces = is(Effect::normal) || is(Effect::viscous) || is(Effect::incremental);
        if (options_.node_output)
            say(Effect::search, V::on, "the output of nodes names their segments");
        else if (steps_open_ == 0 && law_ == Law::solver)
            say(Effect::search, V::off,
                "the window is closed at all " + std::to_string(scene_.time.size()) + " steps");
        else if (bead_.t_start > scene_.time.back() || bead_.t_stop <= scene_.time.front())
            say(Effect::search, V::off, "the window is closed over the whole run");
        else if (plan_.bounded && plan_.d_low > std::max(reach, 0.0) && bead_.law.depth > 0)
            say(Effect::search, V::off,
                "nearest approach " + length(plan_.d_low) + " > DEPTH + t/2 = " + length(reach));
        else if (!plan_.bounded)
            say(Effect::search, V::on,
                "no bound for the distance: the blank deforms or turns, or is too large");
        else if (!(bead_.law.depth > 0))
            say(Effect::search, V::on, "DEPTH = " + length(bead_.law.depth) + ": no distance is too large");
        else
            say(Effect::search, V::on,
                "approach down to " + length(plan_.d_low) + " <= DEPTH + t/2 = " + length(reach) +
                    (forces ? "" : " (first contact is asked for, forces are not)"));
    }

    double largest_g() const {
        double g = 0;
        for (const SegmentStiffness& s : surface_.stiffness)
            g = std::max(g, s.half_thickness);
        for (const double t : surface_.thickness)
            g = std::max(g, 0.5 * t);
        return g;
    }

    void contact() {
        const BeadLaw<double>& law = bead_.law;
        const bool manual = law_ == Law::manual;
        const bool fn = is(Effect::normal);
        const bool ft = is(Effect::viscous) || is(Effect::incremental);
        const bool gate = law.depth > 0;
        const double g = largest_g();
        if (g == 0)
            say(Effect::thickness, V::off, "no segment has a thickness");
        else if (!gate && !manual)
            say(Effect::thickness, V::off, "DEPTH = " + length(law.depth) + ": the distance does not count");
        else
            say(Effect::thickness, V::on, "t/2 up to " + length(g));

        // On the ramp somewhere?
        double least_g = infinity;
        for (std::size_t s = 0; s < surface_.stiffness.size(); ++s)
            least_g = std::min(least_g,
                               manual ? 0.5 * surface_.thickness[s] : surface_.stiffness[s].half_thickness);
        const bool below = plan_.bounded && plan_.d_high < least_g;
        if (manual) {
            if (below && never_reset())
                say(Effect::ramp, V::off,
                    "d <= " + length(plan_.d_high) + " < t/2 = " + length(least_g) +
                        ": always on the plateau");
            else
                say(Effect::ramp, V::on,
                    plan_.bounded ? "d up to " + length(plan_.d_high) : "no bound for the distance");
        } else if (!fn) {
            say(Effect::ramp, V::off, "no normal force");
        } else if (!gate) {
            say(Effect::ramp, V::off, "DEPTH = " + length(law.depth) + ": always on the plateau");
        } else if (below) {
            say(Effect::ramp, V::off,
                "d <= " + length(plan_.d_high) + " < t/2 = " + length(least_g) + ": always on the plateau");
        } else {
            say(Effect::ramp, V::on,
                plan_.bounded ? "d up to " + length(plan_.d_high) : "no bound for the distance");
        }
        const bool ramp = is(Effect::ramp);
        const std::string slope =
            bead_.slope.kind == Slope::none ? "" : "Fn/DEPTH = " + text(bead_.slope.ramp);
        if (manual) {
            say(Effect::reset, ramp && fn ? V::on : V::off,
                ramp && fn ? "decided per node, with its own length" : "no ramp");
            say(Effect::ft_ramp, ramp && ft ? V::on : V::off,
                ramp && ft ? "restraint follows the ramp" : "no ramp under a restraint");
        } else {
            const bool own = bead_.slope.kind == Slope::reset || bead_.slope.kind == Slope::depth_absent;
            say(Effect::reset, ramp && own ? V::on : V::off,
                !ramp ? "no ramp"
                : own ? slope + " exceeds the smallest k"
                      : slope + " holds on every segment");
            bool scales = own; // slopes are read by another index: any pair may meet
            for (const SegmentStiffness& s : surface_.stiffness)
                scales = scales || bead_.slope.ramp < s.k;
            if (!ramp || !ft)
                say(Effect::ft_ramp, V::off, !ramp ? "no ramp" : "no restraint");
            else
                say(Effect::ft_ramp, scales ? V::on : V::off,
                    slope + (scales ? " is below a segment's k" : " is nowhere below k"));
        }
        if (!manual)
            say(Effect::stick_reset, V::off, "the solver keeps its stored force");
        else if (!is(Effect::incremental))
            say(Effect::stick_reset, V::off, "nothing is stored");
        else
            say(Effect::stick_reset, V::on, "lift-off is not excluded");
        say(Effect::edge, V::on, "not bounded");
    }

    /// Whether P/DEPTH <= k at every node of the manual's law.
    bool never_reset() const {
        if (!(bead_.law.depth > 0) || tool_.size() != 1) return false;
        double k = infinity, hop = 0;
        for (std::size_t s = 0; s < surface_.stiffness.size(); ++s) {
            const SegmentStiffness& one = surface_.stiffness[s];
            // A thickness on the element's card counts in the manual's stiffness.
            const double own = one.half_thickness > 0 ? 0.5 * surface_.thickness[s] / one.half_thickness : 1;
            k = std::min(k, one.k * own);
        }
        for (std::size_t i = 1; i < nodes_; ++i)
            hop = std::max(hop, distance(bead_.x[i - 1], bead_.x[i]));
        const double most = std::max(std::abs(bead_.law.fn_first), std::abs(bead_.law.fn_last)) * hop;
        return most / bead_.law.depth <= 0.5 * k;
    }

    void estimate() {
        const uint64_t all = steps_open_ * nodes_;
        const uint64_t computed = is(Effect::moving) ? all : std::min<uint64_t>(all, 3 * nodes_);
        const bool searched = is(Effect::search);
        for (std::size_t i = 0; i < effect_count; ++i) {
            EffectVerdict& one = plan_.effect[i];
            const auto e = static_cast<Effect>(i);
            if (one.verdict == V::off)
                one.estimated = 0;
            else if (e == Effect::window)
                one.estimated = scene_.time.size();
            else if (e == Effect::moving)
                one.estimated = steps_open_;
            else if (e == Effect::moving_tool)
                one.estimated = (scene_.time.size() - 1) * nodes_;
            else
                one.estimated = searched ? computed : 0;
        }
    }

    const EvaluationScene& scene_;
    const std::vector<MotionSteps>& steps_;
    const EvaluationBead& bead_;
    const EvaluationSurface& surface_;
    const NearMesh& mesh_;
    Law law_;
    const PlanOptions& options_;
    std::size_t nodes_;
    std::vector<uint32_t> blank_, tool_; ///< motions
    bool blank_still_ = false, tool_still_ = false;
    double way_ = 0; ///< of bead against blank, at most
    uint64_t steps_open_ = 0;
    BeadPlan plan_;
};

} // namespace

BeadPlan plan(const EvaluationScene& scene, const std::vector<MotionSteps>& steps, std::size_t bead, Law law,
              const PlanOptions& options) {
    return Planner(scene, steps, bead, law, options).make();
}

} // namespace drawbead
