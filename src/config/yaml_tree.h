#pragma once
// The part of YAML that configuration files need, as a plain tree: maps, lists and scalars. Anchors, tags and
// several documents in one file are refused, and so is nesting that no configuration has.
#include "base/result.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

struct YamlEntry;

struct YamlNode {
    enum class Kind : uint8_t { empty, scalar, list, map };
    Kind kind = Kind::empty;
    std::string text; ///< of a scalar
    bool quoted = false;
    std::vector<YamlNode> items;    ///< of a list
    std::vector<YamlEntry> entries; ///< of a map, in the order of the file
    uint64_t line = 0;              ///< from 1
    uint32_t column = 0;
};

/// A key and its value.
struct YamlEntry {
    YamlNode first, second;
};

/// An error has the place in the text, with `path` as the file. An empty text is an empty node. Keys of one
/// map are different scalars.
Result<YamlNode> read_yaml(std::string_view text, const std::string& path);

} // namespace drawbead
