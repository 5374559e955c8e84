#include "rules/srf/edge_clash.h"

#include "base/buffer.h"
#include "base/parallel.h"
#include "contact/segment_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace drawbead {

namespace {

/// One segment's way along an edge, with the edge's smaller node first.
struct EdgeUse {
    uint32_t low, high;
    uint32_t segment;
    bool upward; ///< from low to high

    friend bool operator<(const EdgeUse& a, const EdgeUse& b) {
        if (a.low != b.low) return a.low < b.low;
        if (a.high != b.high) return a.high < b.high;
        return a.segment < b.segment;
    }
};

constexpr uint32_t hash(uint32_t node) {
    return static_cast<uint32_t>(node_hash(node) >> 32);
}

/// Nodes of segments as plain numbers; a copy of its own keeps all of it in a loop's registers.
class CornerReader {
public:
    CornerReader(const SegmentList& segments, uint32_t nodes)
        : first_(static_cast<const std::byte*>(segments.first_nodes())), stride_(segments.stride()),
          nodes_(nodes), stored_(segments.is_stored() ? &segments : nullptr) {}
    /// False when the segment takes no part.
    bool read(std::size_t segment, std::array<uint32_t, 4>& n) const {
        std::memcpy(&n, first_ + segment * stride_, sizeof n);
        if (std::max(std::max(n[0], n[1]), std::max(n[2], n[3])) >= nodes_) return false;
        return stored_ == nullptr || !stored_->solid_backed(segment);
    }

private:
    static_assert(sizeof(NodeRow) == sizeof(uint32_t));
    const std::byte* first_;
    std::size_t stride_;
    uint32_t nodes_;
    const SegmentList* stored_;
};

std::pair<std::size_t, std::size_t> piece_of(std::size_t count, std::size_t pieces, std::size_t piece) {
    return {count * piece / pieces, count * (piece + 1) / pieces};
}

/// Bit per node: the hashes around it do not cancel.
std::vector<uint64_t> open_nodes(const SegmentList& segments, uint32_t nodes, unsigned threads) {
    // One sum per thread; more than four would cost more memory than they save time.
    const std::size_t pieces = std::clamp<std::size_t>(threads, 1, 4);
    constexpr uint32_t in_cache = 1 << 16;
    const std::size_t ahead = nodes < in_cache ? segments.size() : 16;
    std::vector<Buffer<uint32_t>> sums(pieces);
    parallel_for(threads, pieces, [&](std::size_t piece) {
        sums[piece] = Buffer<uint32_t>::zeroed(nodes);
        uint32_t* const sum = sums[piece].data();
        const auto [begin, end] = piece_of(segments.size(), pieces, piece);
        const CornerReader corners(segments, nodes);
        std::array<uint32_t, 4> n;
        for (std::size_t i = begin; i < end; ++i) {
            // Where nodes are numbered at random every sum is far from the last one.
            if (i + ahead < end)
                for (const NodeRow row : segments.nodes(i + ahead))
                    if (index(row) < nodes) __builtin_prefetch(sum + index(row), 1);
            if (!corners.read(i, n)) continue;
            const uint32_t h0 = hash(n[0]), h1 = hash(n[1]), h2 = hash(n[2]);
            if (n[2] == n[3]) {
                sum[n[0]] += h1 - h2;
                sum[n[1]] += h2 - h0;
                sum[n[2]] += h0 - h1;
            } else {
                const uint32_t h3 = hash(n[3]);
                sum[n[0]] += h1 - h3;
                sum[n[1]] += h2 - h0;
                sum[n[2]] += h3 - h1;
                sum[n[3]] += h0 - h2;
            }
        }
    });

    std::vector<uint64_t> open((std::size_t{nodes} + 63) / 64, 0);
    const std::size_t word_pieces = std::max<std::size_t>(1, std::min<std::size_t>(open.size() / 1024, 64));
    parallel_for(threads, word_pieces, [&](std::size_t piece) {
        const auto [begin, end] = piece_of(open.size(), word_pieces, piece);
        for (std::size_t w = begin; w < end; ++w) {
            const std::size_t last = std::min<std::size_t>(nodes, (w + 1) * 64);
            uint64_t bits = 0;
            std::array<uint32_t, 64> sum{};
            for (const Buffer<uint32_t>& s : sums)
                for (std::size_t n = w * 64; n < last; ++n)
                    sum[n % 64] += s[n];
            for (std::size_t n = 0; n < 64; ++n)
                bits |= uint64_t{sum[n] != 0} << n;
            open[w] = bits;
        }
    });
    return open;
}

/// Uses of edges whose ends are both open, sorted.
std::vector<EdgeUse> open_edges(const SegmentList& segments, uint32_t nodes,
                                const std::vector<uint64_t>& open, unsigned threads) {
    const std::size_t pieces = std::max<std::size_t>(1, std::min<std::size_t>(segments.size() / 65536, 64));
    std::vector<std::vector<EdgeUse>> found(pieces);
    const auto is_open = [&](uint32_t n) { return (open[n / 64] >> (n % 64) & 1) != 0; };
    parallel_for(threads, pieces, [&](std::size_t piece) {
        std::vector<EdgeUse>& uses = found[piece];
        const auto [begin, end] = piece_of(segments.size(), pieces, piece);
        const CornerReader corners(segments, nodes);
        std::array<uint32_t, 4> n;
        for (std::size_t i = begin; i < end; ++i) {
            if (!corners.read(i, n)) continue;
            // Every edge has one end of either pair.
            if (!is_open(n[0]) && !is_open(n[2])) continue;
            if (!is_open(n[1]) && !is_open(n[3])) continue;
            const std::array<bool, 4> at{is_open(n[0]), is_open(n[1]), is_open(n[2]), is_open(n[3])};
            for (std::size_t k = 0; k < 4; ++k) {
                const uint32_t a = n[k], b = n[(k + 1) % 4];
                if (a == b || !at[k] || !at[(k + 1) % 4]) continue;
                uses.push_back({std::min(a, b), std::max(a, b), static_cast<uint32_t>(i), a < b});
            }
        }
    });

    std::size_t count = 0;
    for (const auto& uses : found)
        count += uses.size();
    std::vector<EdgeUse> all;
    all.reserve(count);
    // A surface whose segments disagree everywhere has millions: sorted in ranges of nodes, on all threads.
    const std::size_t ranges = count < 100000 ? 1 : 64;
    if (ranges == 1) {
        for (const auto& uses : found)
            all.insert(all.end(), uses.begin(), uses.end());
        std::sort(all.begin(), all.end());
        return all;
    }
    std::vector<std::vector<EdgeUse>> by_node(ranges);
    for (auto& uses : found) {
        for (const EdgeUse& use : uses)
            by_node[uint64_t{use.low} * ranges / nodes].push_back(use);
        std::vector<EdgeUse>().swap(uses);
    }
    parallel_for(threads, ranges, [&](std::size_t r) { std::sort(by_node[r].begin(), by_node[r].end()); });
    for (const auto& uses : by_node)
        all.insert(all.end(), uses.begin(), uses.end());
    return all;
}

bool same_nodes(std::array<NodeRow, 4> x, std::array<NodeRow, 4> y) {
    std::sort(x.begin(), x.end());
    std::sort(y.begin(), y.end());
    return x == y;
}

} // namespace

EdgeClashes edge_clashes(const SegmentList& segments, uint32_t nodes, unsigned threads) {
    EdgeClashes out;
    if (segments.empty() || nodes == 0) return out;
    const std::vector<EdgeUse> uses =
        open_edges(segments, nodes, open_nodes(segments, nodes, threads), threads);
    for (std::size_t i = 0; i < uses.size();) {
        std::size_t end = i + 1;
        while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high)
            ++end;
        const EdgeUse &a = uses[i], &b = uses[i + 1 < uses.size() ? i + 1 : i];
        if (end - i == 2 && a.upward == b.upward && a.segment != b.segment &&
            !same_nodes(segments.nodes(a.segment), segments.nodes(b.segment))) {
            const NodeRow low{a.low}, high{a.high};
            out.edges.push_back({a.segment, b.segment, a.upward ? low : high, a.upward ? high : low});
        }
        i = end;
    }
    std::sort(out.edges.begin(), out.edges.end(), [](const EdgeClash& a, const EdgeClash& b) {
        return std::pair(a.first, a.second) < std::pair(b.first, b.second);
    });
    std::vector<uint32_t> touched;
    touched.reserve(out.edges.size() * 2);
    for (const EdgeClash& e : out.edges)
        touched.insert(touched.end(), {e.first, e.second});
    std::sort(touched.begin(), touched.end());
    out.segments = static_cast<uint64_t>(std::unique(touched.begin(), touched.end()) - touched.begin());
    return out;
}

} // namespace drawbead
