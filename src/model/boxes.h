#pragma once
// /BOX: which points lie inside.
#include "geometry/vec3.h"
#include "model/entities.h"
#include "model/issue_log.h"
#include "model/option_index.h"
#include "model/tables.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace drawbead {

/// A box in work units. A box of boxes holds what any of its positive members holds and no negative one.
struct Box {
    enum class Shape : uint8_t { block, cylinder, sphere, boxes };
    Shape shape = Shape::block;
    Vec3 first, second; ///< corners; ends of the axis; centre
    double diameter = 0;
    std::vector<Box> plus, minus;

    bool contains(Vec3) const;
};

/// Empty when the box does not exist, is turned by a skew, or is of an unknown form.
std::optional<Box> read_box(const Deck&, const OptionIndex&, int64_t id, const NodeTable&, IssueLog&,
                            unsigned depth = 0);

} // namespace drawbead
