#include "model/transform.h"

#include "base/parallel.h"
#include "model/cards/options.h"
#include "model/drawbead_reader.h"
#include "model/option_reader.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drawbead {

namespace {

void read_matrix(OptionReader& reader, Transform& transform) {
    double shift[3] = {};
    for (std::size_t i = 0; i < 3; ++i) {
        const Card card = reader.card(transform_row_card);
        transform.rows[i] = {reader.real(card, "M1"), reader.real(card, "M2"), reader.real(card, "M3")};
        shift[i] = reader.real(card, "shift");
        if (i > 0) continue;
        transform.group = reader.reference(card, "grnd_ID", reader.scope().offsets.general);
        transform.submodel = reader.reference(card, "sub_ID", reader.scope().offsets.submodel);
    }
    transform.shift = {shift[0], shift[1], shift[2]};
}

Vec3 point(OptionReader& reader, const Card& card, bool lengths) {
    const auto value = [&](std::string_view name) {
        return lengths ? reader.real(card, name) : card[name].real;
    };
    return {value("X"), value("Y"), value("Z")};
}

} // namespace

std::vector<Transform> read_transforms(const Deck& deck, IssueLog& issues) {
    using Type = Transform::Type;
    std::vector<Transform> transforms;
    const auto blocks = deck.blocks();
    for (BlockIndex i = 0; i < blocks.size(); ++i) {
        if (!is_option(blocks[i].keyword, "TRANSFORM")) continue;
        const std::string_view type = subtype(blocks[i].keyword);
        Transform transform;
        transform.block = i;
        OptionReader reader(deck, i, issues);
        if (type == "MATRIX") {
            read_matrix(reader, transform);
        } else if (type == "TRA" || type == "ROT" || type == "SYM" || type == "SCA") {
            // From 2026 on a translation begins with a card that names a skew.
            if (type == "TRA" && reader.scope().layout >= 2026) {
                const Card skew = reader.card(transform_first_card);
                if (skew["grnd_ID"].integer != 0) {
                    issues.add(ReadIssue::Kind::not_supported, blocks[i].header, "TRANSFORM/TRA",
                               "with a skew");
                    continue;
                }
            }
            const Card first = reader.card(transform_first_card);
            transform.type = type == "TRA"   ? Type::translation
                             : type == "ROT" ? Type::rotation
                             : type == "SYM" ? Type::symmetry
                                             : Type::scaling;
            transform.first = point(reader, first, type != "SCA");
            transform.group = reader.reference(first, "grnd_ID", reader.scope().offsets.general);
            transform.submodel = reader.reference(first, "sub_ID", reader.scope().offsets.submodel);
            transform.node1 = reader.reference(first, "node_ID1", reader.scope().offsets.node);
            transform.node2 = reader.reference(first, "node_ID2", reader.scope().offsets.node);
            if (type == "ROT" || type == "SYM") {
                const Card second = reader.card(transform_second_card);
                transform.second = point(reader, second, true);
                transform.angle = second["angle"].real;
            }
        } else {
            issues.add(ReadIssue::Kind::not_supported, blocks[i].header, std::string(blocks[i].keyword));
            continue;
        }
        if (transform.group == 0 && transform.submodel == 0) {
            issues.add(ReadIssue::Kind::not_supported, blocks[i].header, std::string(blocks[i].keyword),
                       "without a node group or submodel");
            continue;
        }
        transforms.push_back(transform);
    }
    return transforms;
}

void complete(Transform& transform, const NodeTable& nodes) {
    using Type = Transform::Type;
    const auto position = [&](int64_t id, Vec3 written) {
        if (id <= 0 || id >= 0xffffffff) return written;
        const auto row = nodes.row(NodeId{static_cast<uint32_t>(id)});
        return row ? nodes[*row] : written;
    };
    const bool by_nodes = transform.node1 != 0 && transform.node2 != 0;
    const Vec3 first = by_nodes ? position(transform.node1, transform.first) : transform.first;
    const Vec3 second = by_nodes ? position(transform.node2, transform.second) : transform.second;
    // Keeps `fixed` in place.
    const auto about = [&](Vec3 fixed) {
        transform.shift = {};
        transform.shift = fixed - transform.apply(fixed);
    };
    switch (transform.type) {
    case Type::translation:
        transform.shift = by_nodes ? second - first : transform.first;
        break;
    case Type::rotation: {
        const Vec3 axis = second - first;
        const double length = norm(axis);
        if (!(length > 0)) return;
        const Vec3 n = axis / length;
        const double angle = transform.angle * std::numbers::pi / 180;
        const double c = std::cos(angle), s = std::sin(angle);
        transform.rows[0] = Vec3{c, -s * n.z, s * n.y} + (1 - c) * n.x * n;
        transform.rows[1] = Vec3{s * n.z, c, -s * n.x} + (1 - c) * n.y * n;
        transform.rows[2] = Vec3{-s * n.y, s * n.x, c} + (1 - c) * n.z * n;
        about(first);
        break;
    }
    case Type::symmetry: {
        const Vec3 normal = second - first;
        const double length = norm(normal);
        if (!(length > 0)) return;
        const Vec3 n = normal / length;
        transform.rows[0] = Vec3{1, 0, 0} - 2 * n.x * n;
        transform.rows[1] = Vec3{0, 1, 0} - 2 * n.y * n;
        transform.rows[2] = Vec3{0, 0, 1} - 2 * n.z * n;
        about(first);
        break;
    }
    case Type::scaling:
        transform.rows[0] = {transform.first.x, 0, 0};
        transform.rows[1] = {0, transform.first.y, 0};
        transform.rows[2] = {0, 0, transform.first.z};
        about(position(transform.node1, {}));
        break;
    case Type::matrix:
        break;
    }
}

void apply_transforms(std::vector<Transform> transforms, const Deck& deck, const OptionIndex& index,
                      const PartPicker& picker, Resolver& resolver, unsigned threads, NodeTable& nodes) {
    std::vector<NodeSet> moved(transforms.size());
    for (std::size_t i = 0; i < transforms.size(); ++i) {
        if (transforms[i].group == 0) continue;
        moved[i] = NodeSet(nodes.size());
        const Block& block = deck.blocks()[transforms[i].block];
        const auto group = find_node_group(index, transforms[i].group);
        if (group)
            resolver.nodes(*group, moved[i]);
        else
            resolver.report(ReadIssue::Kind::member_missing, block.header,
                            std::to_string(transforms[i].group));
    }
    constexpr uint32_t piece = 1u << 16;
    for (std::size_t i = 0; i < transforms.size(); ++i) {
        Transform& transform = transforms[i];
        complete(transform, nodes);
        if (transform.group != 0) {
            for (const NodeRow node : moved[i].rows())
                nodes.x[drawbead::index(node)] = transform.apply(nodes.x[drawbead::index(node)]);
            continue;
        }
        for (const RowPiece& rows : nodes.pieces) {
            if (!picker.in_submodel(deck.blocks()[rows.block].scope, transform.submodel)) continue;
            parallel_for(threads, (rows.row_end - rows.row_begin + piece - 1) / piece, [&](std::size_t p) {
                const uint32_t begin = rows.row_begin + static_cast<uint32_t>(p) * piece;
                for (uint32_t row = begin; row < std::min(rows.row_end, begin + piece); ++row)
                    nodes.x[row] = transform.apply(nodes.x[row]);
            });
        }
    }
}

} // namespace drawbead
