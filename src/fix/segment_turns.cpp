#include "fix/segment_turns.h"

#include "base/buffer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <optional>

namespace drawbead {

namespace {

/// Islands of segments, and whether a segment runs the other way round than its island's root.
class Islands {
public:
    explicit Islands(std::size_t count) : parent_(count), turned_(count) {
        for (std::size_t i = 0; i < count; ++i)
            parent_[i] = static_cast<uint32_t>(i);
        if (count) std::memset(turned_.data(), 0, count);
    }

    struct Found {
        uint32_t root;
        bool turned;
    };
    Found find(uint32_t i) {
        // Every second link is shortened on the way, with the turns along it.
        bool turned = false;
        while (parent_[i] != i) {
            const uint32_t up = parent_[i];
            if (parent_[up] != up) {
                turned_[i] = turned_[i] != turned_[up];
                parent_[i] = parent_[up];
            }
            turned = turned != (turned_[i] != 0);
            i = parent_[i];
        }
        return {i, turned};
    }
    /// False when the two were joined before with the opposite turn.
    bool join(uint32_t a, uint32_t b, bool opposite) {
        const Found p = find(a), q = find(b);
        const bool turned = (p.turned != q.turned) != opposite;
        if (p.root == q.root) return !turned;
        const uint32_t low = std::min(p.root, q.root), high = std::max(p.root, q.root);
        parent_[high] = low;
        turned_[high] = turned;
        return true;
    }

private:
    Buffer<uint32_t> parent_;
    Buffer<uint8_t> turned_;
};

/// Segments as they meet across edges; returns segments of islands that have no two sides.
std::vector<uint32_t> join_neighbours(const SegmentList& segments, uint32_t nodes, Islands& islands) {
    struct Use {
        uint32_t high, segment; ///< the edge's larger node; twice the segment, plus 1 from low to high
    };
    const auto each_edge = [&](uint32_t s, auto&& visit) {
        const Segment segment = segments[s];
        if (segment.solid_backed) return;
        for (const NodeRow n : segment.n)
            if (index(n) >= nodes) return;
        for (std::size_t k = 0; k < 4; ++k) {
            const uint32_t a = index(segment.n[k]), b = index(segment.n[(k + 1) % 4]);
            if (a != b) visit(std::min(a, b), std::max(a, b), a < b);
        }
    };
    const auto count = static_cast<uint32_t>(segments.size());
    Buffer<uint32_t> begin(std::size_t{nodes} + 2);
    std::memset(begin.data(), 0, begin.size() * sizeof(uint32_t));
    for (uint32_t s = 0; s < count; ++s)
        each_edge(s, [&](uint32_t low, uint32_t, bool) { ++begin[std::size_t{low} + 2]; });
    for (std::size_t n = 1; n < begin.size(); ++n)
        begin[n] += begin[n - 1];
    Buffer<Use> uses(std::max<std::size_t>(begin[begin.size() - 1], 1));
    for (uint32_t s = 0; s < count; ++s)
        each_edge(s, [&](uint32_t low, uint32_t high, bool up) {
            uses[begin[std::size_t{low} + 1]++] = {high, 2 * s + up};
        });
    // begin[n] is now where the uses of node n's edges begin.
    std::vector<uint32_t> bad;
    for (std::size_t n = 0; n < nodes; ++n)
        for (uint32_t i = begin[n]; i < begin[n + 1]; ++i) {
            uint32_t other = i, found = 0;
            bool first = true;
            for (uint32_t k = begin[n]; k < begin[n + 1]; ++k) {
                if (k == i || uses[k].high != uses[i].high) continue;
                ++found;
                other = k;
                first = first && k > i;
            }
            if (found != 1 || !first) continue;
            const uint32_t a = uses[i].segment, b = uses[other].segment;
            if (a / 2 != b / 2 && !islands.join(a / 2, b / 2, a % 2 == b % 2)) bad.push_back(a / 2);
        }
    return bad;
}

/// By island: whether its root has to be turned.
using Wish = std::map<uint32_t, bool>;

/// Empty when the bead contradicts itself, or says nothing.
std::optional<Wish> wish_of(const BeadVotes& bead, Islands& islands, const std::vector<uint32_t>& bad) {
    struct Count {
        std::array<uint64_t, 2> start{}, other{};
    };
    std::map<uint32_t, Count> counts;
    for (const SegmentVote& vote : bead.votes) {
        const Islands::Found at = islands.find(vote.segment);
        Count& count = counts[at.root];
        ++(vote.start ? count.start : count.other)[vote.away != at.turned];
    }
    Wish wish;
    for (const auto& [root, count] : counts) {
        const auto& votes = count.start[0] + count.start[1] > 0 ? count.start : count.other;
        if (votes[0] > 0 && votes[1] > 0) return std::nullopt;
        if (std::binary_search(bad.begin(), bad.end(), root)) return std::nullopt;
        wish[root] = votes[1] > 0;
    }
    if (wish.empty()) return std::nullopt;
    return wish;
}

bool go_together(const Wish& a, const Wish& b) {
    return std::all_of(a.begin(), a.end(), [&](const auto& one) {
        const auto other = b.find(one.first);
        return other == b.end() || other->second == one.second;
    });
}

} // namespace

SegmentTurns find_turns(const SegmentList& segments, uint32_t nodes, std::span<const BeadVotes> beads) {
    SegmentTurns out;
    Islands islands(segments.size());
    std::vector<uint32_t> bad = join_neighbours(segments, nodes, islands);
    for (uint32_t& s : bad)
        s = islands.find(s).root;
    std::sort(bad.begin(), bad.end());

    std::vector<Wish> wishes;
    for (uint32_t b = 0; b < beads.size(); ++b) {
        const std::optional<Wish> wish = wish_of(beads[b], islands, bad);
        if (!wish) {
            out.undecided.push_back(b);
            continue;
        }
        std::size_t g = 0;
        while (g < wishes.size() && !go_together(wishes[g], *wish))
            ++g;
        if (g == wishes.size()) {
            wishes.emplace_back();
            out.groups.emplace_back();
        }
        wishes[g].insert(wish->begin(), wish->end());
        out.groups[g].beads.push_back(b);
    }
    if (wishes.empty()) return out;

    // Per island a bit for each group, so that the segments are looked at once.
    constexpr std::size_t most = 8;
    for (std::size_t from = 0; from < wishes.size(); from += most) {
        const std::size_t to = std::min(wishes.size(), from + most);
        std::map<uint32_t, std::array<uint8_t, 2>> known; // groups that judge the island, that turn its root
        for (std::size_t g = from; g < to; ++g)
            for (const auto& [root, turn] : wishes[g]) {
                known[root][0] |= static_cast<uint8_t>(1u << (g - from));
                if (turn) known[root][1] |= static_cast<uint8_t>(1u << (g - from));
            }
        uint32_t last = 0xffffffffu;
        std::array<uint8_t, 2> now{};
        for (uint32_t s = 0; s < segments.size(); ++s) {
            if (segments.solid_backed(s)) continue;
            const Islands::Found at = islands.find(s);
            if (at.root != last) {
                const auto found = known.find(at.root);
                now = found == known.end() ? std::array<uint8_t, 2>{} : found->second;
                last = at.root;
            }
            const unsigned turns = now[0] & (at.turned ? ~now[1] : now[1]);
            for (std::size_t g = from; turns != 0 && g < to; ++g)
                if (turns >> (g - from) & 1) out.groups[g].segments.push_back(s);
        }
    }
    std::stable_partition(out.groups.begin(), out.groups.end(),
                          [](const TurnGroup& g) { return g.segments.empty(); });
    return out;
}

} // namespace drawbead
