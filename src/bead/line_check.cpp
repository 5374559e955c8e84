#include "bead/line_check.h"

#include "bead/spanning_tree.h"
#include "geometry/point_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace drawbead {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr uint32_t none = 0xffffffffu;

double median(std::vector<double> v) {
    if (v.empty()) return 0;
    const auto middle = v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2);
    std::nth_element(v.begin(), middle, v.end());
    return *middle;
}

/// Angle between directions in degrees: 0 for the same, 180 for opposite ones, 0 when one has no length.
double turn(Vec3 u, Vec3 v) {
    if (u == Vec3{} || v == Vec3{}) return 0;
    return std::atan2(norm(cross(u, v)), dot(u, v)) * (180 / 3.14159265358979323846);
}

/// A few hops around one, ascending, for what is usual there: their median, but no less than that of the
/// whole line. Less than two say nothing.
struct Around {
    std::array<double, 6> hop{};
    std::size_t count = 0;

    void add(double length) {
        std::size_t at = count++;
        for (; at > 0 && hop[at - 1] > length; --at)
            hop[at] = hop[at - 1];
        hop[at] = length;
    }
    double usual(double of_line) const { return count < 2 ? infinity : std::max(hop[count / 2], of_line); }
};

/// What is usual around each hop of a list.
std::vector<double> usual_hops(std::span<const double> hop) {
    const double of_line = median({hop.begin(), hop.end()});
    std::vector<double> usual(hop.size());
    for (std::size_t i = 0; i < hop.size(); ++i) {
        Around around;
        for (std::size_t k = 1; k <= 3; ++k) {
            if (i >= k) around.add(hop[i - k]);
            if (i + k < hop.size()) around.add(hop[i + k]);
        }
        usual[i] = around.usual(of_line);
    }
    return usual;
}

/// A run of a list without jumps, as smooth legs between turns.
struct Legs {
    static constexpr double corner = 60, fold = 120; ///< degrees
    static constexpr double smooth = 45;             ///< degrees, of a walk that is no zigzag between legs
    static constexpr double regular = 1.8;           ///< of the median hop, or that part of it
    static constexpr std::size_t shortest = 3;       ///< hops of a leg that counts as one
    std::vector<double> hops;
    std::size_t hops_of_leg = 0, long_legs = 0, short_legs = 0;
    std::size_t folds = 0;
    bool before_is_fold = false, fine = true;

    void add(double hop) { hops.push_back(hop), ++hops_of_leg; }
    void end_leg(bool at_fold) {
        const bool is_long = hops_of_leg >= shortest;
        ++(is_long ? long_legs : short_legs);
        if (!is_long && (at_fold || before_is_fold)) fine = false;
        folds += at_fold;
        before_is_fold = at_fold;
        hops_of_leg = 0;
    }
    /// Few and long legs with regular steps: more so when they fold back, as every node out of order makes a
    /// fold. Only the hop from one leg over to the next may be short then.
    bool are_a_line(double gap_ratio) const {
        const double usual = median(hops), most = (folds > 0 ? regular : gap_ratio) * usual;
        const auto short_hops = static_cast<std::size_t>(
            std::count_if(hops.begin(), hops.end(), [&](double h) { return h < usual / regular; }));
        return fine && short_legs < std::max<std::size_t>(long_legs, 1) &&
               (folds == 0 || short_hops <= folds) &&
               std::all_of(hops.begin(), hops.end(), [&](double h) { return h <= most; });
    }
};

/// One change of a tour: a stretch turned round, or one node moved.
struct TourChange {
    uint32_t first = 0, last = 0; ///< of the stretch; or from where and to where the node goes
    bool turns = false;

    template <class T>
    void apply(std::vector<T>& tour) const {
        const auto at = [&](uint32_t i) { return tour.begin() + i; };
        if (turns)
            std::reverse(at(first), at(last) + 1);
        else if (first < last)
            std::rotate(at(first), at(first) + 1, at(last) + 1);
        else
            std::rotate(at(last), at(first), at(first) + 1);
    }
};

/// A change that makes the tour shorter by more than `worth`, among those that bring a node to one of its six
/// closest.
std::optional<TourChange> shorter(const std::vector<Vec3>& at, double worth) {
    constexpr uint32_t candidates = 6;
    const auto last = static_cast<uint32_t>(at.size() - 1);
    const PointTree points(at);
    std::array<PointTree::Near, candidates> near;
    const auto hop = [&](uint32_t i, uint32_t j) {
        return i == none || j == none ? 0 : distance(at[i], at[j]);
    };
    const auto before = [](uint32_t i) { return i > 0 ? i - 1 : none; };
    const auto after = [&](uint32_t i) { return i < last ? i + 1 : none; };
    for (uint32_t i = 0; i <= last; ++i) {
        const uint32_t found = points.nearest(i, candidates, near.data());
        const double leaving = hop(before(i), i) + hop(i, after(i)) - hop(before(i), after(i));
        for (uint32_t k = 0; k < found; ++k) {
            const uint32_t j = near[k].index;
            const double direct = hop(i, j);
            const uint32_t low = std::min(i, j), high = std::max(i, j);
            if (hop(i, after(i)) + hop(j, after(j)) - direct - hop(after(i), after(j)) > worth)
                return TourChange{low + 1, high, true};
            if (hop(before(i), i) + hop(before(j), j) - direct - hop(before(i), before(j)) > worth)
                return TourChange{low, high - 1, true};
            if (j != after(i) && before(j) != i &&
                leaving - (direct + hop(i, before(j)) - hop(before(j), j)) > worth)
                return TourChange{i, i < j ? j - 1 : j, false};
            if (j != before(i) && after(j) != i &&
                leaving - (direct + hop(i, after(j)) - hop(j, after(j))) > worth)
                return TourChange{i, i < j ? j : j + 1, false};
        }
    }
    return std::nullopt;
}

/// Different places in list order, joined by their spanning tree. Place numbers ascend along the list.
class Places {
public:
    Places(std::vector<Vec3> at, std::vector<double> element, const LineLimits& limits)
        : at_(std::move(at)), element_(std::move(element)), limits_(limits), tree_(spanning_tree(at_)) {
        begin_.assign(at_.size() + 1, 0);
        for (const TreeEdge& e : tree_)
            ++begin_[e.a], ++begin_[e.b];
        uint32_t sum = 0;
        for (uint32_t& b : begin_)
            sum = b += sum;
        link_.resize(2 * tree_.size());
        for (uint32_t k = 0; k < tree_.size(); ++k)
            link_[--begin_[tree_[k].a]] = link_[--begin_[tree_[k].b]] = k;
        std::vector<double> lengths;
        for (const TreeEdge& e : tree_)
            lengths.push_back(e.length);
        step_ = median(std::move(lengths));
        cut_at_gaps();
    }

    uint32_t size() const { return static_cast<uint32_t>(at_.size()); }
    Vec3 operator[](uint32_t i) const { return at_[i]; }
    double hop(uint32_t i, uint32_t j) const { return distance(at_[i], at_[j]); }
    double step() const { return step_; }
    uint32_t part(uint32_t i) const { return part_[i]; }
    uint32_t parts() const { return parts_; }

    double element(uint32_t i, uint32_t j, bool larger) const {
        if (element_.empty()) return 0;
        const double p = element_[i], q = element_[j];
        if (p <= 0 || q <= 0) return std::max({p, q, 0.0});
        return larger ? std::max(p, q) : std::min(p, q);
    }
    bool is_gap(double length, double usual, uint32_t i, uint32_t j) const {
        return length > limits_.gap_ratio * usual && length > limits_.gap_elements * element(i, j, true);
    }

    /// Neighbours of a place within its part.
    template <class Do>
    void each_neighbour(uint32_t i, Do&& act) const {
        for (uint32_t k = begin_[i]; k < begin_[i + 1]; ++k)
            if (!cut_[link_[k]]) act(other_end(link_[k], i));
    }
    uint32_t degree(uint32_t i) const {
        uint32_t count = 0;
        each_neighbour(i, [&](uint32_t) { ++count; });
        return count;
    }

    /// Whether the list walks along the tree: every link joins list neighbours, or the list's ends (a loop).
    bool followed_by_list() const;
    bool is_orderly() const;
    bool is_improvable() const;
    /// Makes a walk in one piece shorter by single changes, as long as there is one.
    void improve(LineWalk&) const;
    /// Few places, whose walk is beyond doubt and without corners? A list that goes out and back on it is
    /// then taken for disorder, as chance makes such lists; many places do not fall into two legs by chance.
    bool are_few_and_smooth() const;
    std::vector<uint32_t> branches() const;
    /// Walks every part along the tree.
    LineWalk walk() const;

private:
    std::vector<Vec3> at_;
    std::vector<double> element_;
    LineLimits limits_;
    std::vector<TreeEdge> tree_;
    std::vector<uint32_t> begin_, link_; ///< tree edges at each place
    std::vector<bool> cut_;              ///< edge is a gap
    std::vector<uint32_t> part_;
    uint32_t parts_ = 0;
    double step_ = 0;

    double least_gain() const { return 0.05 * step_; }
    uint32_t other_end(uint32_t edge, uint32_t i) const { return tree_[edge].a + tree_[edge].b - i; }
    void cut_at_gaps();
    void walk_part(uint32_t from, std::vector<uint32_t>& below, std::vector<uint32_t>& order) const;
    bool way_is_clear(std::span<const uint32_t> path, const PointTree&, std::vector<uint32_t>& rank) const;
};

void Places::cut_at_gaps() {
    cut_.assign(tree_.size(), false);
    for (uint32_t e = 0; e < tree_.size(); ++e) {
        Around around;
        for (const uint32_t end : {tree_[e].a, tree_[e].b}) {
            uint32_t place = end, came = e;
            for (int k = 0; k < 3; ++k) {
                uint32_t best = none;
                for (uint32_t m = begin_[place]; m < begin_[place + 1]; ++m)
                    if (link_[m] != came && (best == none || tree_[link_[m]].length < tree_[best].length))
                        best = link_[m];
                if (best == none) break;
                around.add(tree_[best].length);
                place = other_end(best, place);
                came = best;
            }
        }
        cut_[e] = is_gap(tree_[e].length, around.usual(step_), tree_[e].a, tree_[e].b);
    }
    part_.assign(size(), none);
    std::vector<uint32_t> stack;
    for (uint32_t i = 0; i < size(); ++i) {
        if (part_[i] != none) continue;
        part_[i] = parts_;
        stack.push_back(i);
        while (!stack.empty()) {
            const uint32_t p = stack.back();
            stack.pop_back();
            each_neighbour(p, [&](uint32_t q) {
                if (part_[q] == none) part_[q] = parts_, stack.push_back(q);
            });
        }
        ++parts_;
    }
}

bool Places::followed_by_list() const {
    const uint32_t last = size() - 1;
    bool over_the_ends = false;
    std::vector<bool> on_tree(size(), false);
    // Where the last place is that of the first, the tree may take either for the other.
    const bool joined = last > 2 && distance(at_[0], at_[last]) <= limits_.coincident * step_;
    for (uint32_t e = 0; e < tree_.size(); ++e) {
        if (tree_[e].b - tree_[e].a == 1) on_tree[tree_[e].a] = true;
        if (cut_[e] || tree_[e].b - tree_[e].a == 1) continue;
        if (joined && tree_[e].a == 0 && tree_[e].b + 1 == last) {
            on_tree[last - 1] = true;
            continue;
        }
        if (joined && tree_[e].a == 1 && tree_[e].b == last) {
            on_tree[0] = true;
            continue;
        }
        if (tree_[e].a != 0 || tree_[e].b != last) return false;
        over_the_ends = true;
    }
    if (!over_the_ends) return true;
    // The list of a loop starts anywhere and goes on over the longest hop. A line listed from its middle
    // jumps back: further than ends that meet, and with a corner. Three nodes are no loop.
    if (last < 3) return false;
    for (uint32_t i = 0; i < last; ++i) {
        if (on_tree[i]) continue;
        const Vec3 jump = at_[i + 1] - at_[i];
        const double most = norm(jump) <= limits_.closed_steps * step_ ? limits_.fold_degrees : Legs::corner;
        if (i > 0 && turn(at_[i] - at_[i - 1], jump) > most) return false;
        if (i + 1 < last && turn(jump, at_[i + 2] - at_[i + 1]) > most) return false;
    }
    return true;
}

// A list that leaves the shortest walk may still be a line: two legs closer than the steps along them, a
// fold. A disorderly list turns back all the time or jumps. A jump is fine only to another part, each listed
// in one go.
bool Places::is_orderly() const {
    std::vector<double> hops;
    for (uint32_t i = 0; i + 1 < size(); ++i)
        hops.push_back(hop(i, i + 1));
    const std::vector<double> usual = usual_hops(hops);
    std::vector<bool> jump(hops.size());
    std::vector<bool> seen(parts_, false);
    bool jumps = false;
    for (uint32_t i = 0; i + 1 < size(); ++i) {
        jump[i] = is_gap(hops[i], usual[i], i, i + 1);
        if (!jump[i]) continue;
        jumps = true;
        if (seen[part_[i]] || part_[i] == part_[i + 1]) return false;
        seen[part_[i]] = true;
    }
    if (jumps && seen[part_[size() - 1]]) return false;

    Legs legs;
    for (uint32_t i = 0; i + 1 < size(); ++i) {
        if (jump[i]) continue;
        if (jumps && part_[i] != part_[i + 1]) return false;
        legs.add(hops[i]);
        if (i + 2 < size() && !jump[i + 1]) {
            const double degrees = turn(at_[i + 1] - at_[i], at_[i + 2] - at_[i + 1]);
            if (degrees > Legs::corner) legs.end_leg(degrees > Legs::fold);
        } else {
            legs.end_leg(false);
            if (!legs.are_a_line(limits_.gap_ratio)) return false;
            legs = {};
        }
    }
    return true;
}

bool Places::is_improvable() const {
    return shorter(at_, least_gain()).has_value();
}

void Places::improve(LineWalk& walk) const {
    std::vector<Vec3> at;
    for (const uint32_t i : walk.order)
        at.push_back(at_[i]);
    constexpr int most = 100; // each is worth a part of a step; what is left of a wild list is a guess anyway
    for (int k = 0; k < most; ++k) {
        const auto change = shorter(at, least_gain());
        if (!change) break;
        change->apply(at);
        change->apply(walk.order);
    }
    walk.length = 0;
    for (std::size_t k = 1; k < at.size(); ++k)
        walk.length += distance(at[k - 1], at[k]);
    walk.unambiguous = false;
}

bool Places::are_few_and_smooth() const {
    constexpr uint32_t few = 12;
    if (size() > few) return false;
    const LineWalk walk = this->walk();
    if (!walk.unambiguous || walk.pieces.size() != 1) return false;
    for (std::size_t k = 1; k + 1 < walk.order.size(); ++k) {
        const Vec3 before = at_[walk.order[k - 1]], here = at_[walk.order[k]], after = at_[walk.order[k + 1]];
        if (turn(here - before, after - here) > Legs::smooth) return false;
    }
    return true;
}

std::vector<uint32_t> Places::branches() const {
    std::vector<uint32_t> found;
    for (uint32_t i = 0; i < size(); ++i) {
        if (degree(i) < 3) continue;
        uint32_t arms = 0; // of two nodes at least: a single node beside the line is no arm
        each_neighbour(i, [&](uint32_t j) { arms += degree(j) > 1; });
        if (arms > 2) found.push_back(i);
    }
    return found;
}

/// Preorder from one end; at a fork the shorter arms first. `below`: zeros, one per place, and zeros again
/// after.
void Places::walk_part(uint32_t from, std::vector<uint32_t>& below, std::vector<uint32_t>& order) const {
    struct Step {
        uint32_t place, came;
    };
    std::vector<Step> visit{{from, none}};
    for (std::size_t k = 0; k < visit.size(); ++k) {
        const Step s = visit[k];
        each_neighbour(s.place, [&](uint32_t q) {
            if (q != s.came) visit.push_back({q, s.place});
        });
    }
    for (std::size_t k = visit.size(); k-- > 0;) {
        below[visit[k].place] += 1;
        if (visit[k].came != none) below[visit[k].came] += below[visit[k].place];
    }
    std::vector<Step> stack{{from, none}};
    std::vector<uint32_t> arms;
    while (!stack.empty()) {
        const Step s = stack.back();
        stack.pop_back();
        order.push_back(s.place);
        arms.clear();
        each_neighbour(s.place, [&](uint32_t q) {
            if (q != s.came) arms.push_back(q);
        });
        std::sort(arms.begin(), arms.end(),
                  [&](uint32_t p, uint32_t q) { return below[p] != below[q] ? below[p] > below[q] : p > q; });
        for (const uint32_t q : arms)
            stack.push_back({q, s.place});
    }
    for (const Step& s : visit)
        below[s.place] = 0;
}

// No chord over a node that is nearly as short as the way over it, and no other stretch of the line nearly as
// close as the next node. `rank`: `none` for every place, and again after.
bool Places::way_is_clear(std::span<const uint32_t> path, const PointTree& points,
                          std::vector<uint32_t>& rank) const {
    constexpr uint32_t candidates = 8;
    std::vector<double> along(path.size(), 0);
    for (uint32_t k = 0; k < path.size(); ++k) {
        if (k > 0) along[k] = along[k - 1] + hop(path[k - 1], path[k]);
        rank[path[k]] = k;
    }
    const auto longer_hop = [&](uint32_t k) {
        return std::max(k > 0 ? along[k] - along[k - 1] : 0.0,
                        k + 1 < path.size() ? along[k + 1] - along[k] : 0.0);
    };
    std::array<PointTree::Near, candidates> near;
    bool clear = true;
    for (uint32_t k = 0; k < path.size() && clear; ++k) {
        if (k > 0 && k + 1 < path.size()) {
            const double a = along[k] - along[k - 1], b = along[k + 1] - along[k];
            if (hop(path[k - 1], path[k + 1]) < std::max(a, b) + 0.2 * std::min(a, b)) clear = false;
        }
        const uint32_t found = points.nearest(path[k], candidates, near.data());
        for (uint32_t m = 0; m < found; ++m) {
            const uint32_t other = rank[near[m].index];
            if (other == none || other <= k + 2) continue;
            const double straight = std::sqrt(near[m].squared), way = along[other] - along[k];
            const bool closes_loop = k == 0 && other + 1 == path.size();
            if (!closes_loop && straight < 0.5 * way &&
                straight < 1.2 * std::max(longer_hop(k), longer_hop(other)))
                clear = false;
        }
    }
    for (const uint32_t p : path)
        rank[p] = none;
    return clear;
}

/// Ends of a path that meet: a loop. Legs that come back side by side are none.
bool ends_meet(std::span<const Vec3> path, double length, double step, const LineLimits& limits) {
    const std::size_t n = path.size();
    if (n < 4) return false;
    const double seam = distance(path[n - 1], path[0]);
    return seam <= limits.closed_steps * step && length > 3 * seam &&
           turn(path[n - 1] - path[n - 2], path[1] - path[0]) < 135;
}

LineWalk Places::walk() const {
    LineWalk walk;
    const PointTree points(at_);
    walk.unambiguous = true;
    std::vector<bool> done(parts_, false);
    std::vector<uint32_t> path, below(size(), 0), rank(size(), none);
    for (uint32_t i = 0; i < size(); ++i) {
        if (done[part_[i]]) continue;
        done[part_[i]] = true;
        // The end that is listed first: the parts are found by ascending place, ends are places with one
        // neighbour.
        path.clear();
        walk_part(i, below, path);
        uint32_t start = none;
        bool forks = false;
        for (const uint32_t p : path) {
            const uint32_t d = degree(p);
            if (d <= 1) start = std::min(start, p);
            forks = forks || d > 2;
        }
        path.clear();
        walk_part(start, below, path);
        double length = 0;
        for (std::size_t k = 1; k < path.size(); ++k)
            length += hop(path[k - 1], path[k]);
        walk.unambiguous = walk.unambiguous && !forks && way_is_clear(path, points, rank);
        std::vector<Vec3> x;
        for (const uint32_t p : path)
            x.push_back(at_[p]);
        if (parts_ == 1 && !forks && ends_meet(x, length, step_, limits_)) {
            // A loop has no end: start where the list does, towards the neighbour that is listed earlier.
            walk.closed = true;
            length += hop(path.back(), path.front());
            std::rotate(path.begin(), std::find(path.begin(), path.end(), i), path.end());
            if (path.back() < path[1]) std::reverse(path.begin() + 1, path.end());
            length -= hop(path.back(), path.front());
        }
        walk.length += length;
        walk.pieces.push_back(static_cast<uint32_t>(walk.order.size()));
        walk.order.insert(walk.order.end(), path.begin(), path.end());
    }
    return walk;
}

/// What is wrong with the hops and turns of a list that is in order. `list`: positions, `x` their places.
void measure_hops(LineCheck& check, std::span<const uint32_t> list, std::span<const Vec3> x,
                  const std::vector<bool>& between_parts, const Places& places, const LineLimits& limits,
                  bool joined) {
    const auto n = static_cast<uint32_t>(list.size());
    std::vector<double> hop(n - 1);
    for (uint32_t i = 0; i + 1 < n; ++i)
        hop[i] = distance(x[list[i]], x[list[i + 1]]);
    const auto size_under = [&](uint32_t i, bool larger) { return places.element(i, i + 1, larger); };
    const std::vector<double> usual = usual_hops(hop);
    std::vector<bool> gap(n - 1, false);
    std::vector<double> regular;
    for (uint32_t i = 0; i + 1 < n; ++i) {
        gap[i] = between_parts[i] || places.is_gap(hop[i], usual[i], i, i + 1);
        if (gap[i])
            check.gaps.push_back(
                {list[i], list[i + 1], hop[i], usual[i] < infinity ? usual[i] : places.step()});
        else
            regular.push_back(hop[i]);
    }
    check.median_hop = median(regular);
    if (!regular.empty()) {
        check.shortest_hop = *std::min_element(regular.begin(), regular.end());
        check.longest_hop = *std::max_element(regular.begin(), regular.end());
    }
    for (uint32_t i = 0; i + 1 < n; ++i) {
        if (gap[i]) continue;
        if (const double under = size_under(i, true); under > 0 && hop[i] > limits.over_element * under)
            check.over_element.push_back({list[i], list[i + 1], hop[i], under});
        if (const double under = size_under(i, false); under > 0 && hop[i] < limits.fine_element * under)
            check.too_fine.push_back({list[i], list[i + 1], hop[i], under});
        if (i == 0 || gap[i - 1]) continue;
        const uint32_t longer = hop[i] > hop[i - 1] ? i : i - 1, shorter = longer == i ? i - 1 : i;
        if (hop[longer] > limits.uneven_ratio * hop[shorter])
            check.uneven.push_back({list[longer], list[longer + 1], hop[longer], hop[shorter]});
        const Vec3 u = x[list[i]] - x[list[i - 1]], v = x[list[i + 1]] - x[list[i]];
        const double degrees = turn(u, v);
        const LineTurn here{list[i], degrees, 0.5 * (norm(u) + norm(v)) - 0.5 * norm(u + v)};
        if (degrees > limits.fold_degrees)
            check.folds.push_back(here);
        else if (degrees > limits.corner_degrees)
            check.corners.push_back(here);
    }
    std::vector<Vec3> path;
    for (const uint32_t p : list)
        path.push_back(x[p]);
    const double length = std::accumulate(hop.begin(), hop.end(), 0.0);
    check.walk.closed = joined || ends_meet(path, length, check.median_hop, limits);
    if (check.walk.closed && !joined) {
        check.loop_open = true;
        check.closing = {list[n - 1], list[0], distance(path[n - 1], path[0]), check.median_hop};
    }
}

} // namespace

std::vector<uint32_t> LineCheck::piece_starts() const {
    std::vector<uint32_t> starts{0};
    for (const LineHop& gap : gaps)
        starts.push_back(gap.to);
    return starts;
}

LineCheck check_line(std::span<const Vec3> x, std::span<const uint32_t> node,
                     std::span<const double> element_size, const LineLimits& limits) {
    LineCheck check;
    const auto n = static_cast<uint32_t>(x.size());
    check.nodes = n;

    // Nodes listed twice: the first listing counts.
    std::vector<uint32_t> by_node(n);
    std::iota(by_node.begin(), by_node.end(), 0u);
    std::sort(by_node.begin(), by_node.end(),
              [&](uint32_t i, uint32_t j) { return node[i] != node[j] ? node[i] < node[j] : i < j; });
    std::vector<bool> dropped(n, false);
    for (uint32_t k = 1, first = 0; k < n; ++k) {
        if (node[by_node[k]] != node[by_node[first]]) {
            first = k;
            continue;
        }
        check.repeated.push_back({by_node[first], by_node[k]});
        dropped[by_node[k]] = true;
    }
    const auto by_second = [](const LinePair& p, const LinePair& q) { return p.second < q.second; };
    std::sort(check.repeated.begin(), check.repeated.end(), by_second);
    check.closed_by_repeat = n > 3 && check.repeated.size() == 1 && check.repeated[0].first == 0 &&
                             check.repeated[0].second == n - 1;

    // Steps of no length: different nodes at one place, one after the other.
    std::vector<uint32_t> list;
    std::vector<double> hops;
    for (uint32_t i = 0; i < n; ++i) {
        if (dropped[i]) continue;
        if (!list.empty()) hops.push_back(distance(x[list.back()], x[i]));
        list.push_back(i);
    }
    std::erase(hops, 0.0);
    const double same_place = limits.coincident * median(std::move(hops));
    std::vector<uint32_t> apart;
    for (const uint32_t i : list) {
        if (!apart.empty() && distance(x[apart.back()], x[i]) <= same_place)
            check.coincident.push_back({apart.back(), i});
        else
            apart.push_back(i);
    }
    list = std::move(apart);
    // A loop may be joined by a node of its own at the first one's place.
    const bool joined = list.size() > 3 && distance(x[list.front()], x[list.back()]) <= same_place;
    if (list.size() < 2) {
        check.too_short = true;
        check.walk.order = list;
        if (!list.empty()) check.walk.pieces.push_back(0);
        return check;
    }

    std::vector<Vec3> at;
    std::vector<double> element;
    for (const uint32_t p : list) {
        at.push_back(x[p]);
        if (!element_size.empty()) element.push_back(element_size[p]);
    }
    const Places places(std::move(at), std::move(element), limits);
    for (uint32_t i = 1; i < places.size(); ++i)
        check.list_length += places.hop(i - 1, i);

    const bool follows = places.followed_by_list();
    if (!follows && (places.are_few_and_smooth() || !places.is_orderly())) {
        check.walk = places.walk();
        check.walk.branches = places.branches();
        const auto is_list = [&] {
            return std::is_sorted(check.walk.order.begin(), check.walk.order.end()) ||
                   std::is_sorted(check.walk.order.rbegin(), check.walk.order.rend());
        };
        const bool improvable = places.is_improvable();
        // At a fork the tree may lead as the list does, although a shorter walk is near.
        if (improvable && is_list() && check.walk.pieces.size() == 1) places.improve(check.walk);
        check.scrambled = check.walk.branches.empty() && (improvable || check.walk.unambiguous) && !is_list();
        for (uint32_t& p : check.walk.branches)
            p = list[p];
        if (check.scrambled || !check.walk.branches.empty()) {
            for (uint32_t& p : check.walk.order)
                p = list[p];
            return check;
        }
    }

    // The parts are those of the shortest walk, which an orderly list with close legs does not take.
    std::vector<bool> between_parts(list.size() - 1, false);
    for (uint32_t i = 1; follows && i < places.size(); ++i)
        between_parts[i - 1] = places.part(i - 1) != places.part(i);
    check.walk = {};
    measure_hops(check, list, x, between_parts, places, limits, joined);
    check.walk.order = list;
    check.walk.unambiguous = follows;
    check.walk.length = check.list_length;
    for (const LineHop& hop : check.gaps)
        check.walk.length -= hop.length;
    check.walk.pieces.push_back(0);
    std::size_t gap = 0;
    for (uint32_t k = 1; k < list.size() && gap < check.gaps.size(); ++k)
        if (check.gaps[gap].to == list[k]) check.walk.pieces.push_back(k), ++gap;
    return check;
}

LineWalk walk_line(std::span<const Vec3> x, const LineLimits& limits) {
    std::vector<uint32_t> all(x.size());
    std::iota(all.begin(), all.end(), 0u);
    if (x.size() < 2) {
        LineWalk walk;
        walk.order = all;
        if (!all.empty()) walk.pieces.push_back(0);
        return walk;
    }
    const Places places({x.begin(), x.end()}, {}, limits);
    LineWalk walk = places.walk();
    walk.branches = places.branches();
    return walk;
}

} // namespace drawbead
