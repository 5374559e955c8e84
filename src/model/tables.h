#pragma once
// Nodes and elements as rows, in deck order, in work units.
#include "base/buffer.h"
#include "deck/deck.h"
#include "geometry/vec3.h"
#include "model/id_map.h"
#include "model/ids.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace drawbead {

/// Rows [row_begin, row_end) of a table come from consecutive data lines (neither comment nor blank) of one
/// block.
struct RowPiece {
    uint32_t row_begin = 0, row_end = 0;
    uint32_t block = 0;      ///< index into Deck::blocks()
    uint64_t byte_begin = 0; ///< start of a line in the block's file
    uint32_t lines_per_row = 1;
};

/// The data line of a row: one local scan from the start of its piece.
Span row_line(const Deck&, std::span<const RowPiece> pieces, uint32_t row);

/// row_line for many rows: ascending rows of a piece are found in one scan.
class RowLines {
public:
    RowLines(const Deck& deck, std::span<const RowPiece> pieces) : deck_(&deck), pieces_(pieces) {}
    Span line(uint32_t row);

private:
    const Deck* deck_;
    std::span<const RowPiece> pieces_;
    uint32_t row_ = 0xffffffffu; ///< found last, and where
    uint64_t byte_ = 0;
};

struct NodeTable {
    Buffer<uint32_t> id; ///< user ids (global: with offsets)
    Buffer<Vec3> x;      ///< coordinates after /TRANSFORM, work length unit
    IdMap map;
    std::vector<RowPiece> pieces;

    uint32_t size() const { return static_cast<uint32_t>(id.size()); }
    std::optional<NodeRow> row(NodeId) const;
    NodeId user_id(NodeRow r) const { return NodeId{id[index(r)]}; }
    const Vec3& operator[](NodeRow r) const { return x[index(r)]; }
};

/// Elements that come from one block: one part, rows in order.
struct ElementRange {
    uint32_t row_begin = 0, row_end = 0;
    PartId part = 0;
    uint32_t block = 0;
};

/// Shells with 4 nodes, or with 3 (then n[3] == n[2]).
struct ShellTable {
    Buffer<uint32_t> id;
    Buffer<std::array<NodeRow, 4>> nodes; ///< no_node where the node does not exist
    std::vector<ElementRange> ranges;     ///< ascending rows
    std::vector<RowPiece> pieces;
    std::vector<std::pair<uint32_t, double>>
        thickness; ///< rows with a thickness of their own (work units), ascending
    IdMap map;     ///< built only when Needs::all_element_ids, or when something refers to elements by id

    uint32_t size() const { return static_cast<uint32_t>(id.size()); }
    PartId part(uint32_t row) const;
    double own_thickness(uint32_t row) const; ///< 0 when none
};

enum class SolidKind : uint8_t { brick, tetra4, penta6, tetra10, bric20, shel16 };

/// Solids by their 8 corners: a tetra repeats nodes as the solver stores it, mid-side nodes of tetra10 in
/// `mid`.
struct SolidTable {
    Buffer<uint32_t> id;
    Buffer<std::array<NodeRow, 8>> nodes; ///< tetra: n1 n2 n3 n4 then no_node; penta: six, then no_node
    Buffer<SolidKind> kind;
    Buffer<std::array<NodeRow, 6>> mid; ///< parallel to `nodes` only when any tetra10 exists, else empty
    std::vector<ElementRange> ranges;
    std::vector<RowPiece> pieces;
    IdMap map;

    uint32_t size() const { return static_cast<uint32_t>(id.size()); }
    PartId part(uint32_t row) const;
};

} // namespace drawbead
