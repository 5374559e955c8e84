#pragma once
#include "deck/card.h"

namespace drawbead {

inline constexpr Field part_fields[] = {
    {.name = "prop_ID", .column = 1, .width = 8, .until = 44, .link = Link::property},
    {.name = "mat_ID", .column = 9, .width = 8, .until = 44, .link = Link::material},
    {.name = "subset_ID", .column = 17, .width = 8, .until = 44, .link = Link::subset},
    {.name = "prop_ID", .column = 1, .since = 45, .link = Link::property},
    {.name = "mat_ID", .column = 11, .since = 45, .link = Link::material},
    {.name = "subset_ID", .column = 21, .since = 45, .link = Link::subset},
};
inline constexpr CardSchema part_card{"part", part_fields};

} // namespace drawbead
