#pragma once
#include <span>
#include <string_view>

namespace drawbead {

/// A JSON Schema of the schemas folder, embedded at build time.
struct Schema {
    std::string_view name; ///< "report"
    std::string_view text;
};
std::span<const Schema> schemas();

} // namespace drawbead
