#include "contact/solver_search.h"

#include "contact/segment_corner.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace drawbead {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array<double Vec3::*, 3> axes{&Vec3::x, &Vec3::y, &Vec3::z};

/// The Starter's cell of a coordinate: 1 .. count (cell 1 is twice as wide, the last one has no width).
uint32_t cell_number(double at, double min, double extent, uint32_t count) {
    if (!(extent > 0)) return 1;
    const double c = count * (at - min) / extent;
    return !(c >= 1) ? 1 : c >= count ? count : static_cast<uint32_t>(c);
}

double squared_distance(Vec3 a, Vec3 b) {
    return squared_norm(b - a);
}

double corner_test(const SegmentNodes& s, uint32_t nearest, std::span<const Vec3> x, Vec3 bead) {
    return drawbead::corner_test(segment_corner(s, nearest, x), bead);
}

/// Triangle areas against the centre (a) and against the bead node (b), for edges 1 to 4.
struct Areas {
    Vec3 normal;  ///< unit; zero for a segment without area
    double whole; ///< length of the sum of cross products: twice the area
    std::array<double, 4> a, b;
};

Areas areas(const Corners& x, Vec3 bead) {
    const Vec3 centre = 0.25 * (x[0] + x[1] + x[2] + x[3]);
    std::array<Vec3, 4> at_centre;
    Vec3 sum;
    for (std::size_t k = 0; k < 4; ++k) {
        at_centre[k] = cross(x[k] - centre, x[(k + 1) % 4] - centre);
        sum += at_centre[k];
    }
    Areas out{unit(sum), norm(sum), {}, {}};
    for (std::size_t k = 0; k < 4; ++k) {
        out.a[k] = dot(out.normal, at_centre[k]);
        out.b[k] = dot(out.normal, cross(x[k] - bead, x[(k + 1) % 4] - bead));
    }
    return out;
}

double normal_distance(const Corners& x, const std::array<double, 4>& h, Vec3 normal, Vec3 bead) {
    const Vec3 foot = h[0] * x[0] + h[1] * x[1] + h[2] * x[2] + h[3] * x[3];
    return dot(normal, bead - foot);
}

} // namespace

StartSearch::StartSearch(const NearMesh& mesh, std::span<const Vec3> bead) : mesh_(mesh) {
    Vec3 lo = mesh.surface_min, hi = mesh.surface_max;
    for (const Vec3& p : bead) {
        for (const auto axis : axes) {
            lo.*axis = std::min(lo.*axis, p.*axis);
            hi.*axis = std::max(hi.*axis, p.*axis);
        }
    }
    min_ = lo;
    part_min_ = {infinity, infinity, infinity}, part_max_ = -part_min_;
    for (const Vec3& p : bead)
        for (const auto axis : axes) {
            part_min_.*axis = std::min(part_min_.*axis, p.*axis - mesh.reach);
            part_max_.*axis = std::max(part_max_.*axis, p.*axis + mesh.reach);
        }
    const double dx = hi.x - lo.x, dy = hi.y - lo.y, dz = hi.z - lo.z;
    extent_ = {dx, dy, dz};
    const double density = 0.75 * std::sqrt(mesh.surface_nodes / (dx * dy + dy * dz + dz * dx));
    for (std::size_t k = 0; k < 3; ++k) {
        const double wanted = std::round(density * extent_[k]);
        count_[k] = !(wanted >= 1) ? 1 : wanted > 256 ? 256 : static_cast<uint32_t>(wanted);
    }

    const std::size_t cells = std::size_t{count_[0]} * count_[1] * count_[2];
    occupied_.assign(cells / 64 + 1, 0);
    std::vector<uint32_t> node, cell;
    for (uint32_t i = 0; i < mesh.x.size(); ++i) {
        const Vec3 p = mesh.x[i];
        if (p.x < part_min_.x || p.y < part_min_.y || p.z < part_min_.z || p.x > part_max_.x ||
            p.y > part_max_.y || p.z > part_max_.z)
            continue;
        const Cell c = cell_of(p);
        for (std::size_t k = 0; k < 3; ++k) {
            first_[k] = node.empty() ? c[k] : std::min(first_[k], c[k]);
            last_[k] = node.empty() ? c[k] : std::max(last_[k], c[k]);
        }
        node.push_back(i);
        cell.push_back(((c[2] - 1) * count_[1] + (c[1] - 1)) * count_[0] + (c[0] - 1));
        occupied_[cell.back() / 64] |= uint64_t{1} << cell.back() % 64;
    }
    rank_.resize(occupied_.size());
    uint32_t sum = 0;
    for (std::size_t w = 0; w < occupied_.size(); ++w) {
        rank_[w] = sum;
        sum += static_cast<uint32_t>(std::popcount(occupied_[w]));
    }
    const auto rank = [&](uint32_t c) {
        return rank_[c / 64] +
               static_cast<uint32_t>(std::popcount(occupied_[c / 64] & ((uint64_t{1} << c % 64) - 1)));
    };
    begin_.assign(sum + 1, 0);
    for (uint32_t& c : cell)
        ++begin_[(c = rank(c)) + 1];
    for (std::size_t r = 1; r < begin_.size(); ++r)
        begin_[r] += begin_[r - 1];
    std::vector<uint32_t> next(begin_.begin(), begin_.end() - 1);
    node_.resize(node.size());
    for (std::size_t i = 0; i < node.size(); ++i)
        node_[next[cell[i]]++] = node[i];
}

StartSearch::Cell StartSearch::cell_of(Vec3 p) const {
    return {cell_number(p.x, min_.x, extent_[0], count_[0]), cell_number(p.y, min_.y, extent_[1], count_[1]),
            cell_number(p.z, min_.z, extent_[2], count_[2])};
}

/// Whether all nodes of the surface in this box are in the cells.
bool StartSearch::covers(Vec3 lo, Vec3 hi) const {
    for (const auto axis : axes) {
        lo.*axis = std::max(lo.*axis, mesh_.surface_min.*axis);
        hi.*axis = std::min(hi.*axis, mesh_.surface_max.*axis);
        if (lo.*axis > hi.*axis) return true;
    }
    for (const auto axis : axes)
        if (lo.*axis < part_min_.*axis || hi.*axis > part_max_.*axis) return false;
    return mesh_.covers(lo, hi);
}

bool StartSearch::covers(const Cell& lo, const Cell& hi) const {
    Vec3 from, to;
    for (std::size_t k = 0; k < 3; ++k) {
        const double width = extent_[k] / count_[k], slack = 1e-9 * extent_[k];
        from.*axes[k] = min_.*axes[k] + (lo[k] == 1 ? 0 : lo[k]) * width - slack;
        to.*axes[k] = min_.*axes[k] + (hi[k] + 1) * width + slack;
    }
    return covers(from, to);
}

/// Nodes of the cells from lo to hi in the Starter's order: z outermost, x innermost, ascending in each cell.
/// Cells farther from `from` than the bound, which may shrink on the way, are left out.
template <class Visit>
void StartSearch::each_node(Cell lo, Cell hi, Vec3 from, const double& squared_bound, Visit&& visit) const {
    std::array<double, 3> width, at, start;
    for (std::size_t a = 0; a < 3; ++a) {
        lo[a] = std::max(lo[a], first_[a]);
        hi[a] = std::min(hi[a], last_[a]);
        width[a] = extent_[a] / count_[a];
        at[a] = from.*axes[a];
        start[a] = min_.*axes[a];
    }
    const auto squared_gap = [&](std::size_t a,
                                 uint32_t c) { // to the slab of a cell number, a little wider than it
        const double slack = 1e-9 * extent_[a];
        const double below = start[a] + (c == 1 ? 0 : c) * width[a] - slack;
        const double above = start[a] + (c + 1) * width[a] + slack;
        const double gap = std::max({below - at[a], at[a] - above, 0.0});
        return gap * gap;
    };
    if (lo[0] > hi[0]) return;
    for (uint32_t k = lo[2]; k <= hi[2]; ++k) {
        const double gap_z = squared_gap(2, k);
        if (gap_z > squared_bound) continue;
        for (uint32_t j = lo[1]; j <= hi[1]; ++j) {
            const double gap_zy = gap_z + squared_gap(1, j);
            if (gap_zy > squared_bound) continue;
            // Most cells of a row are empty: those that are not are ones in at most a few words.
            const uint32_t row = ((k - 1) * count_[1] + (j - 1)) * count_[0] - 1;
            const uint32_t begin = row + lo[0], end = row + hi[0];
            for (uint32_t w = begin / 64; w <= end / 64; ++w) {
                const uint64_t word = occupied_[w];
                uint64_t rest = word;
                if (w == begin / 64) rest &= ~uint64_t{0} << begin % 64;
                if (w == end / 64) rest &= ~uint64_t{0} >> (63 - end % 64);
                for (; rest != 0; rest &= rest - 1) {
                    const uint64_t below = (rest & -rest) - 1;
                    const uint32_t c = 64 * w + static_cast<uint32_t>(std::countr_zero(rest));
                    if (gap_zy + squared_gap(0, c - row) > squared_bound) continue;
                    const uint32_t r = rank_[w] + static_cast<uint32_t>(std::popcount(word & below));
                    for (uint32_t m = begin_[r]; m < begin_[r + 1]; ++m)
                        visit(node_[m]);
                }
            }
        }
    }
}

std::optional<uint32_t> StartSearch::start_node(Vec3 bead) const {
    const Cell own = cell_of(bead);
    double best = infinity;
    uint32_t nearest = 0;
    const auto take_closer = [&](uint32_t node) {
        const double squared = squared_distance(mesh_.x[node], bead);
        if (squared < best) best = squared, nearest = node;
    };
    bool known_empty = true; // the cubes before the one with the first node
    for (uint32_t grown = 0;; ++grown) {
        Cell lo, hi;
        bool everything = true;
        for (std::size_t k = 0; k < 3; ++k) {
            lo[k] = own[k] > grown ? own[k] - grown : 1;
            hi[k] = std::min(own[k] + grown, count_[k]);
            everything = everything && lo[k] == 1 && hi[k] == count_[k];
        }
        each_node(lo, hi, bead, best, take_closer);
        if (best < infinity) break;
        if (everything) return {};
        known_empty = known_empty && covers(lo, hi);
    }
    const auto ball_is_covered = [&](double radius) {
        const Vec3 r{radius, radius, radius};
        return covers(bead - r, bead + r);
    };
    const double found = std::sqrt(best) * (1 + 1e-9);
    if (known_empty && ball_is_covered(found)) {
        // The Starter scans once more, with the *squared* distance for a reach. Cells farther than the
        // distance itself cannot change the outcome and are left out.
        const double reach = std::min(best, found);
        const Vec3 r{reach, reach, reach};
        each_node(cell_of(bead - r), cell_of(bead + r), bead, best, take_closer);
    } else {
        // The Starter may begin with a node that is not here. From one unit of length on, its second scan
        // then ends at the closest node all the same; which one of several, its way decides.
        const Vec3 r{found, found, found};
        each_node(cell_of(bead - r), cell_of(bead + r), bead, best, take_closer);
        if (best < 1 || !ball_is_covered(std::sqrt(best) * (1 + 1e-9))) return {};
        int closest = 0;
        each_node(cell_of(bead - r), cell_of(bead + r), bead, best,
                  [&](uint32_t node) { closest += squared_distance(mesh_.x[node], bead) == best; });
        if (closest > 1) return {};
    }

    if (!mesh_.is_complete(nearest)) return {};
    uint32_t refined = nearest;
    for (const uint32_t s : mesh_.segments_around(nearest))
        for (const uint32_t node : mesh_.segment[s]) {
            if (node == nearest) continue;
            const double squared = squared_distance(mesh_.x[node], bead);
            if (squared <= best) best = squared, refined = node;
        }
    return refined;
}

std::optional<Track> solver_start(const StartSearch& search, const NearMesh& mesh, Vec3 bead) {
    const std::optional<uint32_t> node = search.start_node(bead);
    if (!node || !mesh.is_complete(*node)) return {};
    Track track{*node, mesh.segments_around(*node).front()};
    double best = -infinity;
    for (const uint32_t s : mesh.segments_around(*node)) {
        const double b = corner_test(mesh.segment[s], *node, mesh.x, bead);
        if (b > best) best = b, track.segment = s;
        if (b >= 0) break;
    }
    return track;
}

bool solver_follow(Track& track, const NearMesh& mesh, std::span<const Vec3> x, Vec3 bead) {
    // One ring per cycle; ties to the smaller user id, which is the smaller local number.
    uint32_t nearest = track.nearest;
    double closest = squared_distance(x[nearest], bead);
    for (const uint32_t s : mesh.segments_around(track.nearest))
        for (const uint32_t node : mesh.segment[s]) {
            const double squared = squared_distance(x[node], bead);
            if (squared < closest || (squared == closest && node < nearest))
                closest = squared, nearest = node;
        }
    const bool complete = mesh.is_complete(track.nearest) && mesh.is_complete(nearest);
    track.nearest = nearest;

    double best = corner_test(mesh.segment[track.segment], nearest, x, bead);
    if (best >= 0) return complete;
    const uint32_t kept = track.segment;
    for (const uint32_t s : mesh.segments_around(nearest)) {
        if (s == kept) continue;
        const double b = corner_test(mesh.segment[s], nearest, x, bead);
        if (b > best || (b == best && mesh.segment[s] < mesh.segment[track.segment]))
            best = b, track.segment = s;
        if (b >= 0) break;
    }
    return complete;
}

SolverHit solver_step(Track& track, const NearMesh& mesh, std::span<const Vec3> x, Vec3 bead) {
    const bool complete = solver_follow(track, mesh, x, bead);
    const SegmentNodes& n = mesh.segment[track.segment];
    SolverHit hit = solver_project({x[n[0]], x[n[1]], x[n[2]], x[n[3]]}, is_triangle(n), bead);
    hit.segment = track.segment;
    hit.at_rim = !complete;
    return hit;
}

SolverHit solver_project(const Corners& x, bool triangle, Vec3 bead) {
    const Areas s = areas(x, bead);
    SolverHit hit;
    hit.normal = s.normal;
    const double xi_below = s.a[1] * s.b[3] + s.b[1] * s.a[3];
    hit.xi = xi_below == 0 ? 0 : (s.a[1] * s.b[3] - s.b[1] * s.a[3]) / xi_below;
    if (triangle) {
        hit.eta = s.a[0] == 0 ? 0 : (s.b[0] - s.a[0]) / s.a[0];
    } else {
        const double eta_below = s.b[0] * s.a[2] + s.a[0] * s.b[2];
        hit.eta = eta_below == 0 ? 0 : (s.b[0] * s.a[2] - s.b[2] * s.a[0]) / eta_below;
    }
    hit.inside = std::abs(hit.xi) <= 1.05 && std::abs(hit.eta) <= 1.05;
    if (hit.inside) {
        hit.xi = std::clamp(hit.xi, -1.0, 1.0);
        hit.eta = std::clamp(hit.eta, -1.0, 1.0);
    }
    hit.h = bilinear_weights(hit.xi, hit.eta);
    hit.d = normal_distance(x, hit.h, hit.normal, bead);
    return hit;
}

bool warns_346(const Corners& x, bool triangle, Vec3 bead, int ipri) {
    constexpr double vanishing = 1e-10, tolerance = 1.02;
    const Areas s = areas(x, bead);
    const auto counts = [&](double value) { return s.whole > 0 && std::abs(value) / s.whole > vanishing; };
    double xi = 0, eta = 0;
    const double xi_below = s.a[1] * s.b[3] + s.b[1] * s.a[3];
    if (counts(xi_below)) xi = (s.a[1] * s.b[3] - s.b[1] * s.a[3]) / xi_below;
    if (!triangle && counts(s.a[2])) {
        const double eta_below = s.b[0] * s.a[2] + s.a[0] * s.b[2];
        eta = eta_below == 0 ? 0 : (s.b[0] * s.a[2] - s.b[2] * s.a[0]) / eta_below;
    } else if (s.a[0] != 0) {
        eta = (s.b[0] - s.a[0]) / s.a[0];
    }
    const bool inside = std::abs(xi) <= tolerance && std::abs(eta) <= tolerance;
    if (inside) {
        xi = std::clamp(xi, -1.0, 1.0);
        eta = std::clamp(eta, -1.0, 1.0);
    } else if (ipri >= 1) {
        return false;
    }
    return normal_distance(x, bilinear_weights(xi, eta), s.normal, bead) < 0;
}

double solver_penetration(const SolverHit& hit, double depth, double half_thickness) {
    if (!(depth > 0)) return 1;
    return hit.inside ? depth - hit.d + half_thickness : 0;
}

SolverTributary solver_tributary(Vec3 normal, Vec3 half_chord) {
    const Vec3 t = cross(normal, half_chord);
    const double l2 = std::max(dot(t, t), 1e-20);
    return {t, l2, std::sqrt(l2)};
}

} // namespace drawbead
