#pragma once
// Lists of ids, ten to a line, and the lines of segments.
#include "deck/card.h"

namespace drawbead {

inline constexpr Field id_list_fields[] = {
    {.name = "1", .column = 1, .since = 45},  {.name = "2", .column = 11, .since = 45},
    {.name = "3", .column = 21, .since = 45}, {.name = "4", .column = 31, .since = 45},
    {.name = "5", .column = 41, .since = 45}, {.name = "6", .column = 51, .since = 45},
    {.name = "7", .column = 61, .since = 45}, {.name = "8", .column = 71, .since = 45},
    {.name = "9", .column = 81, .since = 45}, {.name = "10", .column = 91, .since = 45},
};
inline constexpr CardSchema id_list_card{"ids", id_list_fields};

/// Layouts 41 to 44: cells of 8 columns.
inline constexpr Field narrow_id_list_fields[] = {
    {.name = "1", .column = 1, .width = 8, .until = 44},
    {.name = "2", .column = 9, .width = 8, .until = 44},
    {.name = "3", .column = 17, .width = 8, .until = 44},
    {.name = "4", .column = 25, .width = 8, .until = 44},
    {.name = "5", .column = 33, .width = 8, .until = 44},
    {.name = "6", .column = 41, .width = 8, .until = 44},
    {.name = "7", .column = 49, .width = 8, .until = 44},
    {.name = "8", .column = 57, .width = 8, .until = 44},
    {.name = "9", .column = 65, .width = 8, .until = 44},
    {.name = "10", .column = 73, .width = 8, .until = 44},
};
inline constexpr CardSchema narrow_id_list_card{"ids", narrow_id_list_fields};

inline constexpr Field segment_fields[] = {
    {.name = "seg_ID", .column = 1, .width = 8, .until = 44},
    {.name = "node_ID1", .column = 9, .width = 8, .until = 44, .link = Link::node},
    {.name = "node_ID2", .column = 17, .width = 8, .until = 44, .link = Link::node},
    {.name = "node_ID3", .column = 25, .width = 8, .until = 44, .link = Link::node},
    {.name = "node_ID4", .column = 33, .width = 8, .until = 44, .link = Link::node},
    {.name = "seg_ID", .column = 1, .since = 45},
    {.name = "node_ID1", .column = 11, .since = 45, .link = Link::node},
    {.name = "node_ID2", .column = 21, .since = 45, .link = Link::node},
    {.name = "node_ID3", .column = 31, .since = 45, .link = Link::node},
    {.name = "node_ID4", .column = 41, .since = 45, .link = Link::node},
};
inline constexpr CardSchema segment_card{"segment", segment_fields};

/// The ids of a clause of /SET, behind its key.
inline constexpr Field set_ids_fields[] = {
    {.name = "1", .column = 11}, {.name = "2", .column = 21}, {.name = "3", .column = 31},
    {.name = "4", .column = 41}, {.name = "5", .column = 51}, {.name = "6", .column = 61},
    {.name = "7", .column = 71}, {.name = "8", .column = 81}, {.name = "9", .column = 91},
};
inline constexpr CardSchema set_ids_card{"ids of a set", set_ids_fields};

/// A SEG clause of /SET: behind the columns of the key.
inline constexpr Field set_segment_fields[] = {
    {.name = "seg_ID", .column = 11},
    {.name = "node_ID1", .column = 21, .link = Link::node},
    {.name = "node_ID2", .column = 31, .link = Link::node},
    {.name = "node_ID3", .column = 41, .link = Link::node},
    {.name = "node_ID4", .column = 51, .link = Link::node},
};
inline constexpr CardSchema set_segment_card{"segment of a set", set_segment_fields};

} // namespace drawbead
