#pragma once
// Reads the node and element tables of a deck in parallel pieces. Rows stand in deck order and are the same
// for any count of threads; plain lines go through wide kernels, every other line through one exact path.
#include "deck/deck.h"
#include "model/ids.h"
#include "model/model.h"
#include "model/tables.h"

#include <vector>

namespace drawbead {

/// What is read. Blocks that nothing asks for are not touched.
struct TableRequest {
    enum class Elements : uint8_t {
        none,
        of_parts, ///< blocks of the parts in `parts` only
        all,
    };

    bool counts = false;      ///< rows of all tables, without looking into cells
    bool coordinates = false; ///< node ids, their map, coordinates
    Elements elements = Elements::none;
    std::vector<PartId> parts; ///< global part ids, in any order
    bool shells = true;        ///< the kinds of elements that `elements` means
    bool solids = true;
    bool thickness = false; ///< thickness on shell cards
    bool element_ids =
        false; ///< maps of element ids to rows, and duplicates among the elements that are read
};

struct Tables {
    /// Data lines (neither comment nor blank) of node tables, elements of element tables, /PART blocks.
    /// Complete with TableRequest::counts, else only what was read is counted. Rows that were left out are
    /// counted too.
    Counts counts;
    NodeTable nodes;
    ShellTable shells4, shells3;
    SolidTable solids;
    /// In the order nodes, shells4, shells3, solids; each kind of issue at most `issue_limit` times per
    /// table.
    std::vector<ReadIssue> issues;
};

inline constexpr std::size_t issue_limit = 100;

/// Reads the tables that `request` names.
///
/// Without `coordinates`, elements get ids, parts and places only: `nodes` of their tables stays empty.
/// Coordinates and thicknesses are in work units, not yet moved by /TRANSFORM. A row is left out, with an
/// issue, when its id is 0, negative, not a number or above 2147483647 (offset included). Unreadable
/// coordinates become 0, with an issue. When more issues of a kind occur than are listed, the last listed one
/// has the remaining ones in its `count`.
Tables read_tables(const Deck&, const TableRequest&, unsigned threads);

} // namespace drawbead
