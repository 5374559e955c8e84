#pragma once
// Cards that prescribe how nodes move: /BCS, /IMPVEL, /IMPDISP, /INIVEL, /CLOAD, /RBODY, /FUNCT.
#include "deck/card.h"

namespace drawbead {

inline constexpr Dimension velocity_dimension{0, 1, -1};

/// One digit for each translation and rotation that is held.
inline constexpr Field bcs_fields[] = {
    {.name = "Tx", .column = 4, .width = 1}, {.name = "Ty", .column = 5, .width = 1},
    {.name = "Tz", .column = 6, .width = 1}, {.name = "Rx", .column = 8, .width = 1},
    {.name = "Ry", .column = 9, .width = 1}, {.name = "Rz", .column = 10, .width = 1},
    {.name = "skew_ID", .column = 11},       {.name = "grnd_ID", .column = 21, .link = Link::node_group},
};
inline constexpr CardSchema bcs_card{"boundary condition", bcs_fields};

inline constexpr Field imposed_first_fields[] = {
    {.name = "funct_IDT", .column = 1, .link = Link::function},
    {.name = "Dir", .column = 11, .kind = Kind::text},
    {.name = "skew_ID", .column = 21},
    {.name = "sensor_ID", .column = 31},
    {.name = "grnd_ID", .column = 41, .link = Link::node_group},
    {.name = "frame_ID", .column = 51},
    {.name = "Icoor", .column = 61},
};
inline constexpr CardSchema imposed_first_card{"imposed motion", imposed_first_fields};

inline constexpr Field imposed_velocity_fields[] = {
    {.name = "Ascale_x", .column = 1, .width = 20, .kind = Kind::real, .dimension = time_dimension},
    {.name = "Fscale_Y", .column = 21, .width = 20, .kind = Kind::real, .dimension = velocity_dimension},
    {.name = "Tstart", .column = 41, .width = 20, .kind = Kind::real, .dimension = time_dimension},
    {.name = "Tstop", .column = 61, .width = 20, .kind = Kind::real, .dimension = time_dimension},
};
inline constexpr CardSchema imposed_velocity_card{"scales of an imposed velocity", imposed_velocity_fields};

inline constexpr Field imposed_displacement_fields[] = {
    {.name = "Ascale_x", .column = 1, .width = 20, .kind = Kind::real, .dimension = time_dimension},
    {.name = "Fscale_Y", .column = 21, .width = 20, .kind = Kind::real, .dimension = length_dimension},
    {.name = "Tstart", .column = 41, .width = 20, .kind = Kind::real, .dimension = time_dimension},
    {.name = "Tstop", .column = 61, .width = 20, .kind = Kind::real, .dimension = time_dimension},
};
inline constexpr CardSchema imposed_displacement_card{"scales of an imposed displacement",
                                                      imposed_displacement_fields};

inline constexpr Field load_fields[] = {
    {.name = "funct_IDT", .column = 1, .link = Link::function},
    {.name = "Dir", .column = 11, .kind = Kind::text},
    {.name = "skew_ID", .column = 21},
    {.name = "sensor_ID", .column = 31},
    {.name = "grnd_ID", .column = 41, .link = Link::node_group},
    {.name = "Itypfun", .column = 51},
    {.name = "Ascale_x", .column = 61, .width = 20, .kind = Kind::real, .dimension = time_dimension},
    {.name = "Fscale_Y", .column = 81, .width = 20, .kind = Kind::real, .dimension = force_dimension},
};
inline constexpr CardSchema load_card{"concentrated load", load_fields};

/// Of /INIVEL/AXIS.
inline constexpr Field initial_axis_fields[] = {
    {.name = "Dir", .column = 1, .kind = Kind::text},
    {.name = "frame_ID", .column = 11},
    {.name = "grnd_ID", .column = 21, .link = Link::node_group},
};
inline constexpr CardSchema initial_axis_card{"initial velocity about an axis", initial_axis_fields};

inline constexpr Field initial_velocity_fields[] = {
    {.name = "Vx", .column = 1, .width = 20, .kind = Kind::real, .dimension = velocity_dimension},
    {.name = "Vy", .column = 21, .width = 20, .kind = Kind::real, .dimension = velocity_dimension},
    {.name = "Vz", .column = 41, .width = 20, .kind = Kind::real, .dimension = velocity_dimension},
    {.name = "grnd_ID", .column = 61, .link = Link::node_group},
    {.name = "skew_ID", .column = 71},
};
inline constexpr CardSchema initial_velocity_card{"initial velocity", initial_velocity_fields};

inline constexpr Field rigid_body_fields[] = {
    {.name = "node_ID", .column = 1, .link = Link::node},
    {.name = "sens_ID", .column = 11},
    {.name = "grnd_ID", .column = 61, .link = Link::node_group},
};
inline constexpr CardSchema rigid_body_card{"rigid body", rigid_body_fields};

/// Without a dimension: the scales stand on the cards that use the function.
inline constexpr Field function_fields[] = {
    {.name = "X", .column = 1, .width = 20, .kind = Kind::real},
    {.name = "Y", .column = 21, .width = 20, .kind = Kind::real},
};
inline constexpr CardSchema function_card{"point of a function", function_fields};

} // namespace drawbead
