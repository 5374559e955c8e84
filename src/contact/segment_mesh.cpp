#include "contact/segment_mesh.h"

#include "base/buffer.h"
#include "base/parallel.h"
#include "base/radix_order.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

namespace drawbead {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct BoundingBox {
    Vec3 lo{infinity, infinity, infinity}, hi{-infinity, -infinity, -infinity};

    void add(Vec3 p) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    void add(const BoundingBox& b) {
        add(b.lo);
        add(b.hi);
    }
    bool empty() const { return !(lo.x <= hi.x); }
};

using Cell = std::array<uint32_t, 3>;

/// Finds the coarse grid's cell of a point: per axis counted from 1; 0 below the grid and for a NaN, count +
/// 1 above it. Monotone. Apart from the NearMesh, so that a loop keeps it in registers.
class CellFinder {
public:
    explicit CellFinder(const NearMesh& m)
        : from_(m.cells_min), per_cell_(1 / m.cell_size), zero_(m.cell_size - m.cell_size),
          top_{m.cell_count[0] + 1.0, m.cell_count[1] + 1.0, m.cell_count[2] + 1.0} {}
    Cell operator()(Vec3 p) const {
        return {along(p.x, from_.x, top_.x), along(p.y, from_.y, top_.y), along(p.z, from_.z, top_.z)};
    }

private:
    Vec3 from_;
    double per_cell_;
    double zero_; ///< one that the compiler does not know: for 0 it would branch, and points lie at random
    Vec3 top_;

    uint32_t along(double at, double from, double top) const {
        const double c = (at - from) * per_cell_ + 1;
        const double above = c > zero_ ? c : zero_;
        return static_cast<uint32_t>(static_cast<int32_t>(above < top ? above : top));
    }
};

/// Calls act(word, its bits) for the cells of the grid from lo to hi, a word of `cells` at a time, until it
/// returns true; says whether it did.
template <class Do>
bool any_word(const NearMesh& m, Cell lo, Cell hi, Do&& act) {
    for (std::size_t a = 0; a < 3; ++a) {
        lo[a] = std::max(lo[a], 1u);
        hi[a] = std::min(hi[a], m.cell_count[a]);
    }
    if (lo[0] > hi[0]) return false;
    for (uint32_t k = lo[2]; k <= hi[2]; ++k)
        for (uint32_t j = lo[1]; j <= hi[1]; ++j) {
            const uint64_t row = (uint64_t{k - 1} * m.cell_count[1] + (j - 1)) * m.cell_count[0];
            const uint64_t first = row + lo[0] - 1, last = row + hi[0] - 1;
            for (uint64_t w = first >> 6; w <= last >> 6; ++w) {
                uint64_t bits = ~uint64_t{0};
                if (w == first >> 6) bits &= ~uint64_t{0} << (first & 63);
                if (w == last >> 6) bits &= ~uint64_t{0} >> (63 - (last & 63));
                if (act(w, bits)) return true;
            }
        }
    return false;
}

bool is_marked(const NearMesh& m, uint64_t bit) {
    return m.cells[bit >> 6] >> (bit & 63) & 1;
}

constexpr std::size_t in_cache = 1 << 16; ///< words that need no prefetching

constexpr uint32_t most_per_axis = 509; ///< cells of the grid: 0 to 510 have nine bits and one to spare

/// What is known of a node row is one word: its cell, nine bits per axis with one between them for what a
/// subtraction borrows, and flags: a node of the surface, a node of the part, a cell that is marked, one that
/// is or lies beside one that is.
constexpr uint32_t used = 1u << 30, near = 1u << 31, in_marked = 1u << 19, hot = 1u << 9;
constexpr uint32_t ones = 1u | 1u << 10 | 1u << 20, between = ones << 9, cell_bits = between - ones;

/// A cell as one number.
uint32_t pack(const Cell& c) {
    return c[0] | c[1] << 10 | c[2] << 20;
}
Cell unpacked(uint32_t packed) {
    return {packed & 511, packed >> 10 & 511, packed >> 20 & 511};
}

/// 0 where two packed cells are the same or neighbours, also across an edge or a corner.
uint32_t apart(uint32_t a, uint32_t b) {
    // Per axis 512 + 1 + a - b: the difference then is 0, 1 or 2 above 512.
    const uint32_t d = (a | between) + ones - b;
    return ((d ^ between) & ~ones & ~(ones << 1)) | (d & ones & (d >> 1));
}

/// Flags for every cell and those around the grid, in the places that node words keep them: `hot` and
/// `in_marked`.
std::vector<uint32_t> cell_flags(const NearMesh& m) {
    const uint64_t nx = uint64_t{m.cell_count[0]} + 2, ny = uint64_t{m.cell_count[1]} + 2;
    std::vector<uint32_t> out(nx * ny * (m.cell_count[2] + 2), 0);
    uint64_t bit = 0;
    for (uint32_t k = 0; k < m.cell_count[2]; ++k)
        for (uint32_t j = 0; j < m.cell_count[1]; ++j)
            for (uint32_t i = 0; i < m.cell_count[0]; ++i, ++bit) {
                if (!is_marked(m, bit)) continue;
                for (uint32_t z = k; z < k + 3; ++z)
                    for (uint32_t y = j; y < j + 3; ++y) {
                        uint32_t* const row = &out[(z * ny + y) * nx + i];
                        row[0] |= hot, row[1] |= hot, row[2] |= hot;
                    }
                out[((k + 1) * ny + j + 1) * nx + i + 1] |= in_marked;
            }
    return out;
}

/// Words of the corners of a segment.
using CornerWords = std::array<uint32_t, 4>;

bool touches_marked(const CornerWords& word) {
    return ((word[0] | word[1] | word[2] | word[3]) & in_marked) != 0;
}

/// Whether, with no corner in a marked cell, there may be one between them. Without branches, as segments of
/// all kinds may follow one another.
bool may_span_marked(const CornerWords& word) {
    const uint32_t first = word[0] & cell_bits;
    const uint32_t other = ((word[0] ^ word[1]) | (word[0] ^ word[2]) | (word[0] ^ word[3])) & cell_bits;
    const bool close = (apart(first, word[1] & cell_bits) | apart(first, word[2] & cell_bits) |
                        apart(first, word[3] & cell_bits)) == 0;
    // Far from the points no cell beside the first corner's is marked. Along one axis there are no other
    // cells than those of the corners.
    const int axes = ((other & 511) != 0) + ((other >> 10 & 511) != 0) + ((other >> 20 & 511) != 0);
    const int surely_not = int{axes == 0} | (int{close} & (int{(word[0] & hot) == 0} | int{axes == 1}));
    return surely_not == 0;
}

/// Whether one of the cells from corner to corner is marked.
bool spans_marked(const NearMesh& m, const CornerWords& word) {
    Cell lo = unpacked(word[0]), hi = lo;
    for (std::size_t k = 1; k < 4; ++k) {
        const Cell c = unpacked(word[k]);
        for (std::size_t a = 0; a < 3; ++a)
            lo[a] = std::min(lo[a], c[a]), hi[a] = std::max(hi[a], c[a]);
    }
    return any_word(m, lo, hi, [&](uint64_t w, uint64_t bits) { return (m.cells[w] & bits) != 0; });
}

/// Grid over the points and their reach, cells within reach of a point marked.
void mark_cells(NearMesh& m, std::span<const Vec3> points, double reach) {
    BoundingBox box;
    for (const Vec3& p : points)
        box.add(p);
    const Vec3 r{reach, reach, reach};
    const Vec3 lo = box.lo - r, size = box.hi - box.lo + 2 * r;
    double longest = std::max({size.x, size.y, size.z});
    if (!(longest > 0)) longest = 1;
    constexpr double most_cells = 1 << 22;
    double c = std::max(reach / 3, longest / (most_per_axis - 2));
    const auto count = [](double length, double step) { return static_cast<uint32_t>(length / step) + 1; };
    while (static_cast<double>(count(size.x, c)) * count(size.y, c) * count(size.z, c) > most_cells)
        c *= 1.25;
    m.cells_min = lo;
    m.cell_size = c;
    m.cell_count = {count(size.x, c), count(size.y, c), count(size.z, c)};
    m.cells.assign((uint64_t{m.cell_count[0]} * m.cell_count[1] * m.cell_count[2] + 63) / 64, 0);
    const CellFinder cell_of(m);
    Cell last_lo{}, last_hi{};
    for (const Vec3& p : points) {
        const Cell from = cell_of(p - r), to = cell_of(p + r);
        if (from == last_lo && to == last_hi) continue;
        last_lo = from, last_hi = to;
        any_word(m, from, to, [&](uint64_t w, uint64_t bits) {
            m.cells[w] |= bits;
            return false;
        });
    }
}

} // namespace

bool NearMesh::covers(Vec3 lo, Vec3 hi) const {
    if (cells.empty()) return true;
    lo = {std::max(lo.x, surface_min.x), std::max(lo.y, surface_min.y), std::max(lo.z, surface_min.z)};
    hi = {std::min(hi.x, surface_max.x), std::min(hi.y, surface_max.y), std::min(hi.z, surface_max.z)};
    if (lo.x > hi.x || lo.y > hi.y || lo.z > hi.z) return true;
    const CellFinder cell_of(*this);
    const Cell from = cell_of(lo), to = cell_of(hi);
    for (std::size_t a = 0; a < 3; ++a)
        if (from[a] < 1 || to[a] > cell_count[a]) return false;
    return !any_word(*this, from, to, [&](uint64_t w, uint64_t bits) { return (~cells[w] & bits) != 0; });
}

NearMesh near_mesh(const SegmentMesh& mesh, std::span<const Vec3> points, double reach, unsigned threads) {
    NearMesh m;
    const bool whole = !(reach < infinity) || points.empty();
    if (!whole) mark_cells(m, points, m.reach = reach);

    // Per node row one word, so that a segment touches one place per corner.
    const std::size_t rows = mesh.x.size(), segments = mesh.segment.size();
    constexpr std::size_t piece = 1 << 16;
    const auto pieces = [](std::size_t count) { return (count + piece - 1) / piece; };
    Buffer<uint32_t> at_row(rows);
    const std::vector<uint32_t> flags = whole ? std::vector<uint32_t>() : cell_flags(m);
    std::vector<BoundingBox> boxes(pieces(rows));
    parallel_for(threads, pieces(rows), [&](std::size_t p) {
        const CellFinder cell_of(m);
        const uint64_t nx = uint64_t{m.cell_count[0]} + 2, ny = uint64_t{m.cell_count[1]} + 2;
        const Vec3* const x = mesh.x.data();
        uint32_t* const word = at_row.data();
        const std::size_t begin = p * piece, end = std::min(rows, begin + piece);
        BoundingBox box;
        for (std::size_t row = begin; row < end; ++row)
            box.add(x[row]);
        if (whole) {
            std::fill(word + begin, word + end, 0);
        } else {
            for (std::size_t row = begin; row < end; ++row) {
                const Cell c = cell_of(x[row]);
                word[row] = pack(c) | flags[(c[2] * ny + c[1]) * nx + c[0]];
            }
        }
        boxes[p] = box;
    });

    // The segments that span a marked cell.
    std::vector<std::vector<uint32_t>> found(pieces(segments));
    parallel_for(threads, pieces(segments), [&](std::size_t p) {
        // Enough for the look-ups of some segments to wait together, where they have to.
        const std::size_t ahead = rows < in_cache ? segments : 16;
        const std::size_t begin = p * piece, end = std::min(segments, begin + piece);
        const auto candidates = std::make_unique_for_overwrite<uint32_t[]>(end - begin);
        std::size_t count = 0;
        // Copies that a loop keeps in registers.
        const SegmentArray segment = mesh.segment;
        const std::size_t row_count = rows;
        uint32_t* const word_of = at_row.data();
        const auto take = [word_of](uint32_t row) {
            // Several threads may come here, with the same value.
            const std::atomic_ref<uint32_t> word(word_of[row]);
            const uint32_t value = word.load(std::memory_order_relaxed);
            word.store(value | used, std::memory_order_relaxed);
            return value;
        };
        for (std::size_t s = begin; s < end; ++s) {
            if (s + ahead < end)
                for (const uint32_t row : segment[s + ahead])
                    if (row < row_count) __builtin_prefetch(word_of + row, 1);
            const SegmentNodes n = segment[s];
            if (std::max(std::max(n[0], n[1]), std::max(n[2], n[3])) >= row_count) continue;
            const CornerWords words{take(n[0]), take(n[1]), take(n[2]), take(n[3])};
            candidates[count] = static_cast<uint32_t>(s);
            count += int{whole} | int{touches_marked(words)} | int{may_span_marked(words)};
        }
        for (std::size_t i = 0; i < count; ++i) {
            const SegmentNodes n = mesh.segment[candidates[i]];
            CornerWords words;
            for (std::size_t k = 0; k < 4; ++k)
                words[k] = std::atomic_ref(at_row[n[k]]).load(std::memory_order_relaxed);
            if (whole || touches_marked(words) || spans_marked(m, words)) found[p].push_back(candidates[i]);
        }
    });
    for (const auto& f : found)
        for (const uint32_t s : f)
            for (const uint32_t row : mesh.segment[s])
                at_row[row] |= near;

    std::vector<uint32_t> used_rows(pieces(rows), 0);
    std::vector<std::vector<uint32_t>> near_rows(pieces(rows));
    parallel_for(threads, pieces(rows), [&](std::size_t p) {
        const std::size_t begin = p * piece, end = std::min(rows, begin + piece);
        const uint32_t* const word = at_row.data();
        uint32_t count = 0;
        for (std::size_t row = begin; row < end; ++row)
            count += word[row] >> 30 & 1;
        for (std::size_t row = begin; row < end; ++row)
            if (word[row] & near) near_rows[p].push_back(static_cast<uint32_t>(row));
        used_rows[p] = count;
        if (count == end - begin) return; // the box of all is theirs
        boxes[p] = {};
        for (std::size_t row = begin; row < end; ++row)
            if (at_row[row] & used) boxes[p].add(mesh.x[row]);
    });
    BoundingBox all;
    for (const BoundingBox& b : boxes)
        if (!b.empty()) all.add(b);
    if (!all.empty()) m.surface_min = all.lo, m.surface_max = all.hi;
    for (const uint32_t count : used_rows)
        m.surface_nodes += count;

    for (const auto& f : found)
        m.segment_index.insert(m.segment_index.end(), f.begin(), f.end());
    if (mesh.storage_key) {
        std::vector<uint64_t> key;
        key.reserve(m.segment_index.size());
        for (const uint32_t s : m.segment_index)
            key.push_back(mesh.storage_key(s));
        put_in_order(m.segment_index, std::span<const uint64_t>(key));
    }

    for (const auto& r : near_rows)
        m.node_row.insert(m.node_row.end(), r.begin(), r.end());
    std::vector<uint32_t> node_id;
    node_id.reserve(m.node_row.size());
    for (const uint32_t row : m.node_row)
        node_id.push_back(mesh.node_id[row]);
    put_in_order(m.node_row, std::span<const uint32_t>(node_id));
    if (!whole) m.complete.reserve(m.node_row.size());
    m.node_id.reserve(m.node_row.size());
    m.x.reserve(m.node_row.size());
    Buffer<uint32_t>& local = at_row; // cells and flags are done with, node by node
    for (uint32_t i = 0; i < m.node_row.size(); ++i) {
        const uint32_t row = m.node_row[i];
        if (!whole) m.complete.push_back((local[row] & in_marked) != 0);
        local[row] = i;
        m.node_id.push_back(mesh.node_id[row]);
        m.x.push_back(mesh.x[row]);
    }
    m.segment.reserve(m.segment_index.size());
    m.around_begin.assign(m.node_row.size() + 1, 0);
    for (const uint32_t s : m.segment_index) {
        SegmentNodes n = mesh.segment[s];
        for (uint32_t& row : n)
            row = local[row];
        m.segment.push_back(mesh.turn && mesh.turn(s) ? turned(n) : n);
    }

    // Segments around nodes, ascending: a node that a segment repeats has it once.
    const auto distinct = [](const SegmentNodes& n, std::size_t k) {
        for (std::size_t e = 0; e < k; ++e)
            if (n[e] == n[k]) return false;
        return true;
    };
    for (const SegmentNodes& n : m.segment)
        for (std::size_t k = 0; k < 4; ++k)
            if (distinct(n, k)) ++m.around_begin[n[k] + 1];
    for (std::size_t i = 1; i < m.around_begin.size(); ++i)
        m.around_begin[i] += m.around_begin[i - 1];
    m.around.resize(m.around_begin.back());
    std::vector<uint32_t> next(m.around_begin.begin(), m.around_begin.end() - 1);
    for (uint32_t s = 0; s < m.segment.size(); ++s)
        for (std::size_t k = 0; k < 4; ++k)
            if (distinct(m.segment[s], k)) m.around[next[m.segment[s][k]]++] = s;
    return m;
}

double first_reach(const SegmentMesh& mesh, double around_elements) {
    constexpr std::size_t samples = 256;
    double sum = 0;
    std::size_t count = 0;
    const std::size_t stride = std::max<std::size_t>(mesh.segment.size() / samples, 1);
    for (std::size_t s = 0; s < mesh.segment.size(); s += stride) {
        const SegmentNodes n = mesh.segment[s];
        if (std::any_of(n.begin(), n.end(), [&](uint32_t row) { return row >= mesh.x.size(); })) continue;
        sum += distance(mesh.x[n[0]], mesh.x[n[2]]);
        ++count;
    }
    const double diagonal = sum / static_cast<double>(count), side = diagonal / std::sqrt(2.0);
    const double reach = 3 * diagonal + around_elements * side;
    return reach > 0 ? reach : whole_surface; // no segment, or none that has a size
}

double next_reach(const NearMesh& part, std::span<const Vec3> points, double wanted) {
    BoundingBox box;
    for (const Vec3& p : points) {
        box.add(p);
        const auto gap = [](double lo, double hi, double at) { return std::max({lo - at, at - hi, 0.0}); };
        const Vec3 away{gap(part.surface_min.x, part.surface_max.x, p.x),
                        gap(part.surface_min.y, part.surface_max.y, p.y),
                        gap(part.surface_min.z, part.surface_max.z, p.z)};
        wanted = std::max(wanted, 1.25 * norm(away));
    }
    box.add(part.surface_min), box.add(part.surface_max);
    return wanted > part.reach && wanted < norm(box.hi - box.lo) ? wanted : whole_surface;
}

} // namespace drawbead
