#pragma once
#include <string_view>

namespace drawbead {

/// Whether a path (with '/', relative to the folder of the pattern) is one that the pattern means. `*`, `?`
/// and `[…]` stay within one name, `**` stands for any number of folders. A pattern without a '/' is held
/// against the name alone, wherever the file is; one that ends with '/' means all below that folder.
bool path_matches(std::string_view pattern, std::string_view path);

} // namespace drawbead
