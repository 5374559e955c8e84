#pragma once
// The cards of /INTER/TYPE8 in all layouts. Iform moved between 100 and 110; Fn and DEPTH exist from 130, the
// values at the last node from 2022. What stands outside a layout's fields is ignored by the solver without a
// word.
#include "deck/card.h"

namespace drawbead {

inline constexpr Field type8_reference_fields[] = {
    {.name = "grnd_IDs", .column = 1, .width = 8, .until = 44, .link = Link::node_group},
    {.name = "surf_IDm", .column = 9, .width = 8, .until = 44, .link = Link::surface},
    {.name = "grnd_IDs", .column = 1, .since = 45, .link = Link::node_group},
    {.name = "surf_IDm", .column = 11, .since = 45, .link = Link::surface},
    {.name = "Iform", .column = 21, .since = 100, .until = 109},
    {.name = "Iform", .column = 31, .since = 110},
};
inline constexpr CardSchema type8_references{"references", type8_reference_fields};

inline constexpr Field type8_force_fields[] = {
    {.name = "Ft",
     .column = 17,
     .width = 16,
     .kind = Kind::real,
     .dimension = force_per_length_dimension,
     .until = 44},
    {.name = "Tstart",
     .column = 49,
     .width = 16,
     .kind = Kind::real,
     .dimension = time_dimension,
     .until = 44},
    {.name = "Tstop",
     .column = 65,
     .width = 16,
     .kind = Kind::real,
     .dimension = time_dimension,
     .until = 44},
    {.name = "Fn",
     .column = 1,
     .width = 20,
     .kind = Kind::real,
     .dimension = force_per_length_dimension,
     .since = 130},
    {.name = "Ft",
     .column = 21,
     .width = 20,
     .kind = Kind::real,
     .dimension = force_per_length_dimension,
     .since = 45},
    {.name = "Depth",
     .column = 41,
     .width = 20,
     .kind = Kind::real,
     .dimension = length_dimension,
     .since = 130},
    {.name = "Tstart",
     .column = 61,
     .width = 20,
     .kind = Kind::real,
     .dimension = time_dimension,
     .since = 45},
    {.name = "Tstop",
     .column = 81,
     .width = 20,
     .kind = Kind::real,
     .dimension = time_dimension,
     .since = 45},
};
inline constexpr CardSchema type8_forces{"forces", type8_force_fields};

inline constexpr Field type8_last_fields[] = {
    {.name = "Fn_last",
     .column = 1,
     .width = 20,
     .kind = Kind::real,
     .dimension = force_per_length_dimension,
     .since = 2022},
    {.name = "Ft_last",
     .column = 21,
     .width = 20,
     .kind = Kind::real,
     .dimension = force_per_length_dimension,
     .since = 2022},
};
inline constexpr CardSchema type8_last{"values at the last node", type8_last_fields};

} // namespace drawbead
