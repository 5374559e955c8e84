#include "rules/srf/near_surface.h"

#include "base/parallel.h"
#include "base/radix_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace drawbead {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Cells of a box, numbered; what they hold is listed by counting.
class Cells {
public:
    Cells(Vec3 lo, Vec3 hi, double size, double most) : min_(lo), size_(std::max(size, 1e-300)) {
        const Vec3 extent = hi - lo;
        const auto cells = [&](double e) { return std::max(1.0, std::ceil(e / size_)); };
        while (cells(extent.x) * cells(extent.y) * cells(extent.z) > most)
            size_ *= 1.5;
        for (std::size_t k = 0; k < 3; ++k)
            count_[k] = static_cast<uint32_t>(cells(k == 0 ? extent.x : k == 1 ? extent.y : extent.z));
    }

    std::size_t size() const { return std::size_t{count_[0]} * count_[1] * count_[2]; }
    double cell() const { return size_; }
    std::array<uint32_t, 3> of(Vec3 x) const {
        return {axis(x.x - min_.x, 0), axis(x.y - min_.y, 1), axis(x.z - min_.z, 2)};
    }
    std::size_t number(const std::array<uint32_t, 3>& c) const {
        return (std::size_t{c[2]} * count_[1] + c[1]) * count_[0] + c[0];
    }
    template <class Visit>
    void each(Vec3 lo, Vec3 hi, Visit&& visit) const {
        const auto a = of(lo), b = of(hi);
        for (uint32_t z = a[2]; z <= b[2]; ++z)
            for (uint32_t y = a[1]; y <= b[1]; ++y)
                for (uint32_t x = a[0]; x <= b[0]; ++x)
                    visit(number({x, y, z}));
    }

private:
    Vec3 min_;
    double size_;
    std::array<uint32_t, 3> count_{};

    uint32_t axis(double at, std::size_t k) const {
        const double c = at / size_;
        return c > 0 ? static_cast<uint32_t>(std::min(c, count_[k] - 1.0)) : 0;
    }
};

/// Items by cell: begin[c] to begin[c + 1].
struct Listing {
    std::vector<uint32_t> begin, item;

    template <class EachCell>
    Listing(std::size_t cells, uint32_t items, EachCell&& cells_of) : begin(cells + 1, 0) {
        for (uint32_t i = 0; i < items; ++i)
            cells_of(i, [&](std::size_t c) { ++begin[c + 1]; });
        for (std::size_t c = 1; c < begin.size(); ++c)
            begin[c] += begin[c - 1];
        item.resize(begin.back());
        std::vector<uint32_t> next(begin.begin(), begin.end() - 1);
        for (uint32_t i = 0; i < items; ++i)
            cells_of(i, [&](std::size_t c) { item[next[c]++] = i; });
    }
    std::span<const uint32_t> in(std::size_t c) const {
        return {item.data() + begin[c], item.data() + begin[c + 1]};
    }
};

struct BoundingBox {
    Vec3 lo{infinity, infinity, infinity}, hi{-infinity, -infinity, -infinity};

    void add(Vec3 p, double r = 0) {
        lo = {std::min(lo.x, p.x - r), std::min(lo.y, p.y - r), std::min(lo.z, p.z - r)};
        hi = {std::max(hi.x, p.x + r), std::max(hi.y, p.y + r), std::max(hi.z, p.z + r)};
    }
    bool holds(Vec3 p) const { // without branches
        return bool(int{p.x >= lo.x} & int{p.y >= lo.y} & int{p.z >= lo.z} & int{p.x <= hi.x} &
                    int{p.y <= hi.y} & int{p.z <= hi.z});
    }
};

/// Segments picked evenly from the whole surface: where it is, roughly, and how large its segments are.
struct Sample {
    std::vector<Vec3> at;        ///< first corner
    std::vector<double> element; ///< root of the area
    double longest = 0;          ///< diagonal or side of any
    double largest = 0;          ///< element

    explicit Sample(const SegmentMesh& mesh) {
        constexpr std::size_t most = 1 << 16;
        const std::size_t step = mesh.segment.size() / most + 1;
        for (std::size_t s = 0; s < mesh.segment.size(); s += step) {
            constexpr std::size_t ahead = 8;
            if (s + ahead * step < mesh.segment.size())
                for (const uint32_t row : mesh.segment[s + ahead * step])
                    if (row < mesh.x.size()) __builtin_prefetch(&mesh.x[row]);
            const SegmentNodes n = mesh.segment[s];
            if (std::max({n[0], n[1], n[2], n[3]}) >= mesh.x.size()) continue;
            const Corners c{mesh.x[n[0]], mesh.x[n[1]], mesh.x[n[2]], mesh.x[n[3]]};
            at.push_back(c[0]);
            element.push_back(std::sqrt(area(c)));
            largest = std::max(largest, element.back());
            for (std::size_t k = 0; k < 4; ++k)
                longest = std::max(longest, squared_norm(c[(k + 1) % 4] - c[k]));
            longest = std::max({longest, squared_norm(c[2] - c[0]), squared_norm(c[3] - c[1])});
        }
        longest = std::sqrt(longest);
    }
};

/// For each point the closest of the sampled corners: no segment farther than it can be closest.
struct Bound {
    double distance = infinity, element = 0;
};
std::vector<Bound> bounds(const Sample& sample, std::span<const Vec3> points, unsigned threads) {
    BoundingBox box;
    for (const Vec3& p : sample.at)
        box.add(p);
    const Vec3 extent = box.hi - box.lo;
    const double longest = std::max({extent.x, extent.y, extent.z});
    const Cells cells(box.lo, box.hi, longest / 256, 1 << 17);
    const Listing listing(cells.size(), static_cast<uint32_t>(sample.at.size()),
                          [&](uint32_t i, auto&& visit) { visit(cells.number(cells.of(sample.at[i]))); });
    std::vector<Bound> out(points.size());
    constexpr std::size_t chunk = 256;
    parallel_for(threads, (points.size() + chunk - 1) / chunk, [&](std::size_t piece) {
        uint32_t near = 0; // of the point before: neighbours on the bead have nearly the same
        for (std::size_t i = piece * chunk; i < std::min(points.size(), (piece + 1) * chunk); ++i) {
            const Vec3 p = points[i];
            double best = squared_norm(sample.at[near] - p);
            if (i == piece * chunk) // a first idea from a few hundred of them
                for (uint32_t s = 0; s < sample.at.size();
                     s += std::max<uint32_t>(1, static_cast<uint32_t>(sample.at.size() / 512)))
                    if (const double d = squared_norm(sample.at[s] - p); d < best) best = d, near = s;
            const double r = std::sqrt(best);
            cells.each(p - Vec3{r, r, r}, p + Vec3{r, r, r}, [&](std::size_t c) {
                for (const uint32_t s : listing.in(c))
                    if (const double d = squared_norm(sample.at[s] - p); d < best) best = d, near = s;
            });
            out[i] = {std::sqrt(best), sample.element[near]};
        }
    });
    return out;
}

struct Ball {
    Vec3 centre;
    double radius;
};

/// Points that stand close together, as on a fine bead, share a ball.
std::vector<Ball> merged(const std::vector<Ball>& balls) {
    std::vector<Ball> out;
    for (const Ball& b : balls) {
        if (!out.empty()) {
            const double apart = distance(out.back().centre, b.centre);
            if (apart + b.radius <= 1.2 * out.back().radius) continue;
        }
        out.push_back(b);
    }
    for (Ball& b : out)
        b.radius *= 1.2;
    return out;
}

/// Bit per node row: it lies in a ball.
std::vector<uint64_t> rows_in(const std::vector<Ball>& balls, std::span<const Vec3> x, unsigned threads) {
    std::vector<uint64_t> bits((x.size() + 63) / 64, 0);
    if (balls.empty()) return bits;
    BoundingBox box;
    double sum = 0;
    for (const Ball& b : balls) {
        box.add(b.centre, b.radius);
        sum += b.radius;
    }
    const Cells cells(box.lo, box.hi, sum / static_cast<double>(balls.size()) / 2, 1 << 18);
    const Listing listing(cells.size(), static_cast<uint32_t>(balls.size()), [&](uint32_t i, auto&& visit) {
        const Vec3 r{balls[i].radius, balls[i].radius, balls[i].radius};
        cells.each(balls[i].centre - r, balls[i].centre + r, visit);
    });
    std::vector<uint64_t> occupied((cells.size() + 63) / 64, 0);
    for (std::size_t c = 0; c < cells.size(); ++c)
        if (!listing.in(c).empty()) occupied[c / 64] |= uint64_t{1} << (c % 64);
    constexpr std::size_t words = 1024;
    parallel_for(threads, (bits.size() + words - 1) / words, [&](std::size_t piece) {
        for (std::size_t w = piece * words; w < std::min(bits.size(), (piece + 1) * words); ++w) {
            // Rows may stand in any order, so that no branch can be foreseen: first the box of all, for all
            // rows.
            const std::size_t begin = w * 64, count = std::min<std::size_t>(64, x.size() - begin);
            uint64_t word = 0;
            for (std::size_t k = 0; k < count; ++k)
                word |= uint64_t{box.holds(x[begin + k])} << k;
            for (uint64_t left = word; left != 0; left &= left - 1) {
                const auto k = static_cast<std::size_t>(std::countr_zero(left));
                const Vec3 p = x[begin + k];
                const std::size_t c = cells.number(cells.of(p));
                const auto in_ball = [&](uint32_t b) {
                    return squared_norm(p - balls[b].centre) <= balls[b].radius * balls[b].radius;
                };
                const auto near = listing.in(c);
                if ((occupied[c / 64] >> (c % 64) & 1) == 0 ||
                    std::none_of(near.begin(), near.end(), in_ball))
                    word &= ~(uint64_t{1} << k);
            }
            bits[w] = word;
        }
    });
    return bits;
}

bool test(const std::vector<uint64_t>& bits, uint32_t i) {
    return (bits[i / 64] >> (i % 64) & 1) != 0;
}

/// Segments with a corner whose bit is set, ascending.
std::vector<uint32_t> segments_at(const SegmentArray& segment, const std::vector<uint64_t>& bits,
                                  std::size_t rows, unsigned threads) {
    constexpr std::size_t piece_size = 1 << 16;
    std::vector<std::vector<uint32_t>> found((segment.size() + piece_size - 1) / piece_size);
    parallel_for(threads, found.size(), [&](std::size_t piece) {
        for (std::size_t s = piece * piece_size; s < std::min(segment.size(), (piece + 1) * piece_size);
             ++s) {
            const SegmentNodes n = segment[s];
            if (std::max({n[0], n[1], n[2], n[3]}) >= rows) continue;
            if (test(bits, n[0]) || test(bits, n[1]) || test(bits, n[2]) || test(bits, n[3]))
                found[piece].push_back(static_cast<uint32_t>(s));
        }
    });
    std::vector<uint32_t> all;
    for (const auto& f : found)
        all.insert(all.end(), f.begin(), f.end());
    return all;
}

void sort_by_storage(const SegmentMesh& mesh, std::vector<uint32_t>& segments, unsigned threads) {
    if (!mesh.storage_key) return;
    std::vector<uint64_t> key(segments.size());
    constexpr std::size_t chunk = 4096;
    parallel_for(threads, (key.size() + chunk - 1) / chunk, [&](std::size_t piece) {
        for (std::size_t i = piece * chunk; i < std::min(key.size(), (piece + 1) * chunk); ++i)
            key[i] = mesh.storage_key(segments[i]);
    });
    put_in_order(segments, std::span<const uint64_t>(key));
}

/// The segments with local node numbers, which ascend with the rows.
NearMesh renumbered(const SegmentMesh& mesh, std::vector<uint32_t> segments) {
    NearMesh m;
    m.segment.reserve(segments.size());
    for (const uint32_t s : segments)
        m.segment.push_back(mesh.segment[s]);
    std::vector<uint64_t> used((mesh.x.size() + 63) / 64, 0);
    for (const SegmentNodes& n : m.segment)
        for (const uint32_t row : n)
            used[row / 64] |= uint64_t{1} << (row % 64);
    std::vector<uint32_t> rank(used.size() + 1, 0); // nodes before each word
    for (std::size_t w = 0; w < used.size(); ++w)
        rank[w + 1] = rank[w] + static_cast<uint32_t>(std::popcount(used[w]));
    m.node_row.reserve(rank.back());
    for (std::size_t w = 0; w < used.size(); ++w)
        for (uint64_t bits = used[w]; bits != 0; bits &= bits - 1)
            m.node_row.push_back(static_cast<uint32_t>(w * 64) +
                                 static_cast<uint32_t>(std::countr_zero(bits)));
    m.node_id.reserve(m.node_row.size());
    m.x.reserve(m.node_row.size());
    for (const uint32_t row : m.node_row) {
        m.node_id.push_back(mesh.node_id[row]);
        m.x.push_back(mesh.x[row]);
    }
    m.surface_nodes = static_cast<uint32_t>(m.node_row.size());
    const auto local = [&](uint32_t row) {
        return rank[row / 64] +
               static_cast<uint32_t>(std::popcount(used[row / 64] & ((uint64_t{1} << (row % 64)) - 1)));
    };

    m.around_begin.assign(m.node_row.size() + 1, 0);
    const auto each_node = [](const SegmentNodes& n, auto&& visit) { // a node that is repeated once
        for (std::size_t k = 0; k < 4; ++k)
            if (std::find(n.begin(), n.begin() + static_cast<std::ptrdiff_t>(k), n[k]) ==
                n.begin() + static_cast<std::ptrdiff_t>(k))
                visit(n[k]);
    };
    for (std::size_t i = 0; i < segments.size(); ++i) {
        SegmentNodes& n = m.segment[i];
        for (uint32_t& node : n)
            node = local(node);
        if (mesh.turn && mesh.turn(segments[i])) n = turned(n);
        each_node(n, [&](uint32_t node) { ++m.around_begin[node + 1]; });
    }
    for (std::size_t i = 1; i < m.around_begin.size(); ++i)
        m.around_begin[i] += m.around_begin[i - 1];
    m.around.resize(m.around_begin.back());
    std::vector<uint32_t> next(m.around_begin.begin(), m.around_begin.end() - 1);
    for (uint32_t s = 0; s < m.segment.size(); ++s)
        each_node(m.segment[s], [&](uint32_t node) { m.around[next[node]++] = s; });
    m.segment_index = std::move(segments);
    return m;
}

} // namespace

NearSurface near_surface(const SegmentMesh& mesh, std::span<const Vec3> points, double elements,
                         double least_margin, unsigned threads) {
    NearSurface out;
    const Sample sample(mesh);
    if (points.empty() || sample.at.empty()) return out;
    out.element = sample.largest;
    const std::vector<Bound> bound = bounds(sample, points, threads);
    std::vector<Ball> balls;
    balls.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        out.margin.push_back(std::max(elements * bound[i].element, least_margin));
        // A point of a segment is no farther from one of its corners than the segment is long.
        balls.push_back({points[i], (bound[i].distance + out.margin.back() + sample.longest) * (1 + 1e-12)});
    }
    std::vector<uint32_t> segments =
        segments_at(mesh.segment, rows_in(merged(balls), mesh.x, threads), mesh.x.size(), threads);
    sort_by_storage(mesh, segments, threads);
    out.mesh = renumbered(mesh, std::move(segments));
    return out;
}

} // namespace drawbead
