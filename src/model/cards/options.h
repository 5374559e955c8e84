#pragma once
// Cards of options that act on nodes: /TRANSFORM, /BOX, rigid bodies, conditions; /ADMESH/GLOBAL and /IOFLAG.
#include "deck/card.h"

namespace drawbead {

inline constexpr Field admesh_global_fields[] = {
    {.name = "Level", .column = 1},
    {.name = "Iadmrule", .column = 11},
    {.name = "Tdelay", .column = 21, .width = 20, .kind = Kind::real, .dimension = time_dimension},
    {.name = "Idt", .column = 41, .since = 90},
};
inline constexpr CardSchema admesh_global_card{"adaptive meshing", admesh_global_fields};

inline constexpr Field ioflag_fields[] = {{.name = "Ipri", .column = 1}};
inline constexpr CardSchema ioflag_card{"output flags", ioflag_fields};

/// First card of TRA (a vector), ROT and SYM (a point) and, with a fourth value, MATRIX (a row and a shift).
inline constexpr Field transform_first_fields[] = {
    {.name = "grnd_ID", .column = 1, .link = Link::node_group},
    {.name = "X", .column = 11, .width = 20, .kind = Kind::real, .dimension = length_dimension},
    {.name = "Y", .column = 31, .width = 20, .kind = Kind::real, .dimension = length_dimension},
    {.name = "Z", .column = 51, .width = 20, .kind = Kind::real, .dimension = length_dimension},
    {.name = "node_ID1", .column = 71, .link = Link::node},
    {.name = "node_ID2", .column = 81, .link = Link::node},
    {.name = "sub_ID", .column = 91, .link = Link::submodel},
};
inline constexpr CardSchema transform_first_card{"transformation", transform_first_fields};

inline constexpr Field transform_second_fields[] = {
    {.name = "X", .column = 11, .width = 20, .kind = Kind::real, .dimension = length_dimension},
    {.name = "Y", .column = 31, .width = 20, .kind = Kind::real, .dimension = length_dimension},
    {.name = "Z", .column = 51, .width = 20, .kind = Kind::real, .dimension = length_dimension},
    {.name = "angle", .column = 71, .width = 20, .kind = Kind::real},
};
inline constexpr CardSchema transform_second_card{"second point", transform_second_fields};

inline constexpr Field transform_row_fields[] = {
    {.name = "grnd_ID", .column = 1, .link = Link::node_group},
    {.name = "M1", .column = 11, .width = 20, .kind = Kind::real},
    {.name = "M2", .column = 31, .width = 20, .kind = Kind::real},
    {.name = "M3", .column = 51, .width = 20, .kind = Kind::real},
    {.name = "shift", .column = 71, .width = 20, .kind = Kind::real, .dimension = length_dimension},
    {.name = "sub_ID", .column = 91, .link = Link::submodel},
};
inline constexpr CardSchema transform_row_card{"row of a matrix", transform_row_fields};

inline constexpr Field box_first_fields[] = {
    {.name = "node_ID1", .column = 1, .link = Link::node},
    {.name = "node_ID2", .column = 11, .link = Link::node},
    {.name = "skew_ID", .column = 21},
    {.name = "diameter", .column = 31, .width = 20, .kind = Kind::real, .dimension = length_dimension},
};
inline constexpr CardSchema box_first_card{"box", box_first_fields};

inline constexpr Field point_fields[] = {
    {.name = "X", .column = 1, .width = 20, .kind = Kind::real, .dimension = length_dimension},
    {.name = "Y", .column = 21, .width = 20, .kind = Kind::real, .dimension = length_dimension},
    {.name = "Z", .column = 41, .width = 20, .kind = Kind::real, .dimension = length_dimension},
};
inline constexpr CardSchema point_card{"point", point_fields};

/// Options that hold or move the nodes of a group: the column of the group on the first card.
struct NodeHolder {
    std::string_view keyword;
    uint8_t group_column;
    uint8_t own_nodes; ///< how many nodes the first cells name that belong to the option as well
};
inline constexpr NodeHolder node_holders[] = {
    {"RBODY", 61, 1}, {"BCS", 21, 0}, {"IMPVEL", 41, 0}, {"IMPDISP", 41, 0},   {"IMPACC", 41, 0},
    {"RBE2", 31, 1},  {"RBE3", 0, 1}, {"RLINK", 21, 0},  {"CYL_JOINT", 21, 2},
};

} // namespace drawbead
