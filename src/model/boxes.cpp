#include "model/boxes.h"

#include "model/cards/options.h"
#include "model/option_reader.h"

#include <algorithm>

namespace drawbead {

bool Box::contains(Vec3 p) const {
    switch (shape) {
    case Shape::block:
        return p.x >= std::min(first.x, second.x) && p.x <= std::max(first.x, second.x) &&
               p.y >= std::min(first.y, second.y) && p.y <= std::max(first.y, second.y) &&
               p.z >= std::min(first.z, second.z) && p.z <= std::max(first.z, second.z);
    case Shape::cylinder: {
        const Vec3 axis = second - first, arm = p - first;
        const double length2 = squared_norm(axis);
        if (!(length2 > 0)) return false;
        const double along = dot(arm, axis) / length2;
        return along >= 0 && along <= 1 && squared_norm(arm - along * axis) <= 0.25 * diameter * diameter;
    }
    case Shape::sphere:
        return squared_norm(p - first) <= 0.25 * diameter * diameter;
    case Shape::boxes: {
        const auto holds = [&](const Box& box) { return box.contains(p); };
        return std::any_of(plus.begin(), plus.end(), holds) &&
               std::none_of(minus.begin(), minus.end(), holds);
    }
    }
    return false;
}

std::optional<Box> read_box(const Deck& deck, const OptionIndex& index, int64_t id, const NodeTable& nodes,
                            IssueLog& issues, unsigned depth) {
    const auto block_index = index.find(Family::box, id);
    if (!block_index || depth > 20) return std::nullopt;
    const Block& block = deck.blocks()[*block_index];
    const std::string_view type = subtype(block.keyword);
    Box box;
    if (type == "BOX" || type == "BOXA") {
        box.shape = Box::Shape::boxes;
        const int64_t offset = deck.scope(block.scope).offsets.general;
        for (const WrittenId& written : read_ids(deck, block, issues)) {
            const int64_t member = Deck::global_id(written.id, offset);
            std::optional<Box> inner =
                read_box(deck, index, member < 0 ? -member : member, nodes, issues, depth + 1);
            if (!inner) return std::nullopt;
            (member < 0 ? box.minus : box.plus).push_back(std::move(*inner));
        }
        return box;
    }
    OptionReader reader(deck, *block_index, issues);
    const Card card = reader.card(box_first_card);
    const auto point = [&](std::string_view node_field) -> Vec3 {
        const Card coordinates = reader.card(point_card);
        const int64_t node = reader.reference(card, node_field, reader.scope().offsets.node);
        if (node > 0 && node <= 0xffffffff)
            if (const auto row = nodes.row(NodeId{static_cast<uint32_t>(node)})) return nodes[*row];
        return {reader.real(coordinates, "X"), reader.real(coordinates, "Y"), reader.real(coordinates, "Z")};
    };
    if (type == "RECTA") {
        if (card["skew_ID"].integer != 0) return std::nullopt;
        box.shape = Box::Shape::block;
        box.first = point("node_ID1");
        box.second = point("node_ID2");
    } else if (type == "CYLIN") {
        box.shape = Box::Shape::cylinder;
        box.diameter = reader.real(card, "diameter");
        box.first = point("node_ID1");
        box.second = point("node_ID2");
    } else if (type == "SPHER") {
        box.shape = Box::Shape::sphere;
        box.diameter = reader.real(card, "diameter");
        box.first = point("node_ID1");
    } else {
        return std::nullopt;
    }
    return box;
}

} // namespace drawbead
