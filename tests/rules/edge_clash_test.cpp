#include "rules/srf/edge_clash.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

using namespace drawbead;

namespace {

Segment segment(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    Segment s;
    s.n = {NodeRow{a}, NodeRow{b}, NodeRow{c}, NodeRow{d}};
    return s;
}

void reverse(Segment& s) {
    if (s.n[2] == s.n[3])
        std::swap(s.n[0], s.n[1]);
    else
        std::reverse(s.n.begin(), s.n.end());
}

/// columns x rows cells, node (i, j) at row j * (columns + 1) + i; every third cell is two triangles when
/// asked.
std::vector<Segment> plate(uint32_t columns, uint32_t rows, bool triangles = false) {
    std::vector<Segment> all;
    for (uint32_t j = 0; j < rows; ++j)
        for (uint32_t i = 0; i < columns; ++i) {
            const uint32_t a = j * (columns + 1) + i, b = a + 1, d = a + columns + 1, c = d + 1;
            if (triangles && (i + j) % 3 == 0) {
                all.push_back(segment(a, b, c, c));
                all.push_back(segment(a, c, d, d));
            } else {
                all.push_back(segment(a, b, c, d));
            }
        }
    return all;
}

EdgeClashes clashes(const std::vector<Segment>& s, uint32_t nodes, unsigned threads = 1) {
    Buffer<Segment> stored(s.size());
    std::copy(s.begin(), s.end(), stored.begin());
    return edge_clashes(SegmentList(std::move(stored)), nodes, threads);
}

/// Every edge in a map: the definition.
std::vector<std::array<uint32_t, 4>> by_definition(const std::vector<Segment>& segments) {
    struct Use {
        uint32_t segment;
        bool upward;
    };
    std::map<std::pair<uint32_t, uint32_t>, std::vector<Use>> edges;
    for (uint32_t i = 0; i < segments.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k) {
            const uint32_t a = index(segments[i].n[k]), b = index(segments[i].n[(k + 1) % 4]);
            if (a != b) edges[{std::min(a, b), std::max(a, b)}].push_back({i, a < b});
        }
    std::vector<std::array<uint32_t, 4>> out;
    for (const auto& [nodes, uses] : edges)
        if (uses.size() == 2 && uses[0].upward == uses[1].upward) {
            const auto [low, high] = nodes;
            out.push_back(
                {uses[0].segment, uses[1].segment, uses[0].upward ? low : high, uses[0].upward ? high : low});
        }
    std::sort(out.begin(), out.end());
    return out;
}

std::vector<std::array<uint32_t, 4>> flat(const EdgeClashes& c) {
    std::vector<std::array<uint32_t, 4>> out;
    for (const EdgeClash& e : c.edges)
        out.push_back({e.first, e.second, index(e.from), index(e.to)});
    std::sort(out.begin(), out.end());
    return out;
}

} // namespace

TEST_CASE("a surface of one orientation has no clash, turned or not") {
    std::vector<Segment> s = plate(12, 7, true);
    CHECK(clashes(s, 13 * 8).edges.empty());
    std::for_each(s.begin(), s.end(), reverse);
    CHECK(clashes(s, 13 * 8).edges.empty());
    CHECK(clashes({}, 0).edges.empty());
}

TEST_CASE("one turned segment clashes along each of its inner edges") {
    std::vector<Segment> s = plate(3, 3);
    reverse(s[4]);
    const EdgeClashes middle = clashes(s, 16);
    CHECK(middle.edges.size() == 4);
    CHECK(middle.segments == 5);
    CHECK(flat(middle) == by_definition(s));

    s = plate(3, 3);
    reverse(s[0]); // at a corner of the plate: its outer edges have no neighbour
    CHECK(clashes(s, 16).edges.size() == 2);
    CHECK(clashes(s, 16).segments == 3);
}

TEST_CASE("edges of three segments, segments listed twice and solid-backed ones say nothing") {
    std::vector<Segment> s = plate(2, 1); // nodes 0..5, inner edge 1-4
    s.push_back(segment(1, 4, 7, 6));     // a third sheet at the inner edge
    reverse(s[1]);
    CHECK(clashes(s, 8).edges.empty());

    s = plate(1, 1);
    s.push_back(s[0]);
    CHECK(clashes(s, 4).edges.empty());

    s = plate(2, 1);
    reverse(s[1]);
    CHECK(clashes(s, 6).edges.size() == 1);
    s[1].solid_backed = true;
    CHECK(clashes(s, 6).edges.empty());
}

TEST_CASE("nodes that do not exist and repeated nodes do no harm") {
    std::vector<Segment> s = plate(2, 1);
    s.push_back(segment(0, 1, 2, 0xffffffffu));
    s.push_back(segment(3, 3, 4, 4));
    CHECK(clashes(s, 6).edges.empty());
}

TEST_CASE("clashes are those of the definition, for any numbering, order and count of threads") {
    std::mt19937 random(7);
    for (const double turned : {0.0, 0.01, 0.3, 0.5}) {
        for (int round = 0; round < 5; ++round) {
            const uint32_t columns = 40, rows = 33, nodes = (columns + 1) * (rows + 1);
            std::vector<Segment> s = plate(columns, rows, round % 2 == 1);
            std::vector<uint32_t> number(nodes);
            std::iota(number.begin(), number.end(), 0u);
            std::shuffle(number.begin(), number.end(), random);
            for (Segment& one : s) {
                for (NodeRow& n : one.n)
                    n = NodeRow{number[index(n)]};
                if (std::bernoulli_distribution(turned)(random)) reverse(one);
            }
            std::shuffle(s.begin(), s.end(), random);
            const auto expected = by_definition(s);
            const EdgeClashes one = clashes(s, nodes);
            CHECK(flat(one) == expected);
            for (const unsigned threads : {2u, 3u, 8u})
                CHECK(flat(clashes(s, nodes, threads)) == expected);
        }
    }
}

TEST_CASE("a large surface is split among threads without a change") {
    std::vector<Segment> s = plate(700, 500);
    for (std::size_t i = 0; i < s.size() / 3; ++i)
        reverse(s[i]);
    const uint32_t nodes = 701 * 501;
    const EdgeClashes one = clashes(s, nodes, 1), four = clashes(s, nodes, 4);
    CHECK(flat(one) == by_definition(s));
    CHECK(flat(four) == flat(one));
    CHECK(four.segments == one.segments);
}
