#pragma once
// Options that TYPE8 looks at, as read: ids are global, numbers in work units, places kept for messages and
// repairs.
#include "base/buffer.h"
#include "deck/card.h"
#include "deck/deck.h"
#include "model/ids.h"
#include "model/segment_list.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace drawbead {

using BlockIndex = uint32_t; ///< into Deck::blocks()

struct Part {
    PartId id = 0;
    PropertyId property = 0;
    MaterialId material = 0;
    int64_t subset = 0;
    BlockIndex block = 0;
    std::string title;
};

struct Property {
    PropertyId id = 0;
    int type = -1;              ///< 0, 1, 2, 6, 9 … 51; -1 for a name that is not known
    bool has_thickness = false; ///< a shell property whose card was read
    double thickness = 0;
    BlockIndex block = 0;
};

struct Material {
    enum class Stiffness : uint8_t {
        known,     ///< young and bulk are the solver's PM(20) and PM(32)
        none,      ///< a law that is void, or fluid or foam: no usable modulus
        unknown,   ///< a law that the tool has no card for
        encrypted, ///< exists, values unreadable
    };
    MaterialId id = 0;
    std::string law; ///< canonical: "LAW1" …, or as written when not known
    Stiffness stiffness = Stiffness::unknown;
    bool is_void = false;
    double density = 0, young = 0, bulk = 0;
    BlockIndex block = 0;
};

/// One entry of a node list as written.
struct ListedNode {
    int64_t written = 0;   ///< as in the deck, before the offset; may be 0 or negative
    NodeRow row = no_node; ///< no_node: zero, negative or not existing
    Span place;
};

/// A node group that an interface refers to.
struct NodeGroup {
    enum class Order : uint8_t {
        unsorted,    ///< NODENS, GRNODNS, or a /SET with one NODENS clause: as the solver wants it
        sorted,      ///< error 112
        lost_in_set, ///< /SET with several NODENS clauses, or _D / _I on one
    };
    GroupId id = 0;
    BlockIndex block = 0;
    std::string type; ///< "NODENS", "NODE", "SET" …
    Order order = Order::sorted;
    std::vector<NodeRow> nodes; ///< in the solver's order, existing nodes only, duplicates kept
    std::vector<ListedNode>
        listed; ///< entries of NODENS / NODE lists as written, zeros and all; empty for other types
    std::vector<Span> nodens_clauses; ///< /SET: places of the NODENS clause keys
    std::vector<BlockIndex> users;    ///< other options that name the group; with Needs::surface_users
    bool evaluated = true;            ///< false: a type that the tool cannot expand (nodes is empty then)
    std::string title;
};

/// A segment of SEG lines that has a solid behind it and whose stiffness a shell gives: the solid's stiffness
/// counts in the surface's minimum all the same.
struct CoatedSolid {
    uint32_t segment = 0; ///< index into Surface::segments
    uint32_t solid = 0;   ///< row in the table of solids
};

/// One thing that a surface is made of, as written in its block; what a repair would edit.
struct SurfaceSource {
    enum class Kind : uint8_t {
        segment_lines,
        part,
        subset,
        material,
        property,
        shell_group,
        sh3n_group,
        brick_group,
        surface,
        set_clause,
        other
    };
    Kind kind = Kind::other;
    int64_t id = 0; ///< global id of the part, group, surface …; its sign as written
    Span place;
};

/// A main surface, expanded into oriented segments. The solver stores segments from SEG lines first, as
/// listed, then 4-node shells, then 3-node shells, each by ascending element id; `Model::storage_key` orders
/// them so.
struct Surface {
    SurfaceId id = 0;
    BlockIndex block = 0;
    std::string type;             ///< "PART", "SEG", "GRSHEL", "PART/EXT", "SET" …
    SegmentList segments;         ///< in the order of the tables that they come from
    bool in_storage_order = true; ///< whether that is the solver's storage order
    std::vector<Span>
        lines; ///< SEG lines of segments [0, lines.size()), in their own order; empty without SEG
    std::vector<SurfaceSource> sources;
    std::vector<int64_t> unknown_nodes;   ///< of SEG lines, which are left out of `segments`
    std::vector<Span> unknown_node_lines; ///< parallel to unknown_nodes
    std::vector<CoatedSolid> coated;      ///< ascending segments
    std::vector<BlockIndex> users;        ///< other options that name the surface; with Needs::surface_users
    bool evaluated = true;                ///< false: a type that the tool cannot expand
    std::string title;
};

/// A /INTER/TYPE8 as written and as the solver takes it.
struct Drawbead {
    InterfaceId id = 0;
    BlockIndex block = 0;
    std::string title;
    Span title_line;
    bool title_missing = false;
    std::array<Card, 3> cards; ///< cells in the deck's input units; [2] has fields only from layout 2022 on
    std::vector<Span> extra;   ///< data lines after the last card
    std::optional<uint32_t> group;   ///< index into Model::groups(); empty when the id is 0 or unknown
    std::optional<uint32_t> surface; ///< index into Model::surfaces()
    GroupId group_id = 0;
    SurfaceId surface_id = 0;
    int iform = 2;                                               ///< 0 is already 2
    double fn_first = 0, ft_first = 0, fn_last = 0, ft_last = 0; ///< force per length, work units
    double depth = 0;                                            ///< length
    double t_start = 0, t_stop = 1e30;                           ///< time; a Tstop of 0 is already 1e30
    bool unit_known = true; ///< false: its unit id has no /UNIT (the values are then unconverted)

    bool fn_varies() const { return fn_last != 0; }
    bool ft_varies() const { return ft_last != 0; }
};

/// What holds or moves a node.
struct Attachment {
    enum class Kind : uint8_t {
        rigid_body,
        boundary_condition,
        imposed_velocity,
        imposed_displacement,
        other
    };
    Kind kind = Kind::other;
    int64_t id = 0;
    BlockIndex block = 0;
};

/// /ADMESH/GLOBAL
struct Admesh {
    BlockIndex block = 0;
    int64_t level = 0;
    int64_t idt = 0; ///< static condensation flag, called Idt in the manual
};

} // namespace drawbead
