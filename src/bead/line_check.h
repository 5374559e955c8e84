#pragma once
// Is a list of nodes a walk along a line? What a list can be damaged by, told apart so that one damage gives
// one kind of finding. Precedence: repeated and coincident nodes are left out first; a scrambled list reports
// no gaps, folds, corners or spacing (hops of a wrong walk mean nothing); a gap is not also an uneven spacing
// or a fold.
#include "geometry/vec3.h"

#include <cstdint>
#include <span>
#include <vector>

namespace drawbead {

struct LineLimits {
    double gap_ratio = 3;      ///< a gap is longer than this times the usual hop around it,
    double gap_elements = 2;   ///< and than this many elements under it, when their size is known
    double coincident = 1e-6;  ///< of the median hop: closer than this is the same place
    double fold_degrees = 135; ///< turn between neighbouring hops
    double corner_degrees = 20;
    double closed_steps = 1.5; ///< ends closer than this many hops: a loop
    double over_element = 1;   ///< step over the element under it
    double fine_element = 0.2; ///< step under this part of the element
    double uneven_ratio = 3;   ///< neighbouring hops
};

/// A damage at a hop (between list positions `from` and `to`, which are neighbours unless something between
/// them was left out) or at a node.
struct LineHop {
    uint32_t from = 0, to = 0; ///< positions in the list
    double length = 0;
    double usual = 0; ///< what the neighbourhood would suggest: the usual hop, the element size …
};
struct LineTurn {
    uint32_t at = 0;    ///< position in the list
    double degrees = 0; ///< 0 straight on, 180 back
    double lost = 0;    ///< arc minus chord tributary at this node: length that carries no force
};
struct LinePair {
    uint32_t first = 0, second = 0; ///< positions in the list, first < second
};

/// How the places of a list hang together, found without looking at the list order.
struct LineWalk {
    std::vector<uint32_t>
        order; ///< list positions in walking order, all pieces one after the other, repeated and
               ///< coincident ones left out; starts at the end of the line listed earlier
    std::vector<uint32_t> pieces;   ///< where each piece starts in `order`
    std::vector<uint32_t> branches; ///< list positions where three or more arms meet (T, Y)
    bool closed = false;            ///< one piece whose ends meet
    bool unambiguous = false;       ///< no branches, and every node's way on is clearly the shortest
    double length = 0;              ///< of the hops within pieces
};

struct LineCheck {
    uint32_t nodes = 0;               ///< listed
    bool too_short = false;           ///< fewer than two different places
    std::vector<LinePair> repeated;   ///< the same node twice
    std::vector<LinePair> coincident; ///< two nodes at one place
    bool closed_by_repeat = false;    ///< the only repeated node is the first, listed again at the end
    bool scrambled = false;
    double list_length = 0; ///< tour in list order
    LineWalk walk;
    std::vector<LineHop> gaps;
    std::vector<LineTurn> folds;
    std::vector<LineTurn> corners;
    bool loop_open = false; ///< ends closer than a step but not joined: the last segment is missing
    LineHop closing;        ///< last to first, when loop_open
    std::vector<LineHop> over_element; ///< needs element sizes
    std::vector<LineHop> too_fine;     ///< needs element sizes
    std::vector<LineHop> uneven;       ///< the longer hop of a pair of neighbours; usual: the shorter
    double shortest_hop = 0, median_hop = 0, longest_hop = 0; ///< gaps left out

    /// Pieces of the list between gaps: first position of each, 0 first.
    std::vector<uint32_t> piece_starts() const;
};

/// `node`: an id or row per position, equal for equal nodes. `element_size`: edge length of the segment under
/// each node (0 where there is none), or empty. O(n log n).
LineCheck check_line(std::span<const Vec3> x, std::span<const uint32_t> node,
                     std::span<const double> element_size = {}, const LineLimits& = {});

/// The walk alone.
LineWalk walk_line(std::span<const Vec3> x, const LineLimits& = {});

} // namespace drawbead
