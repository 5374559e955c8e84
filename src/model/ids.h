#pragma once
// User ids and rows are different things: an id is what the deck says, a row is where the table holds it.
#include <cstdint>

namespace drawbead {

enum class NodeId : uint32_t {};
enum class NodeRow : uint32_t {};
enum class ElementId : uint32_t {};
inline constexpr NodeRow no_node{0xffffffffu};

constexpr uint32_t index(NodeRow row) {
    return static_cast<uint32_t>(row);
}
constexpr uint32_t value(NodeId id) {
    return static_cast<uint32_t>(id);
}
constexpr uint32_t value(ElementId id) {
    return static_cast<uint32_t>(id);
}

using InterfaceId = int64_t; ///< global user ids of options: definition plus the scope's offset
using GroupId = int64_t;
using SurfaceId = int64_t;
using PartId = int64_t;
using PropertyId = int64_t;
using MaterialId = int64_t;

} // namespace drawbead
