#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace drawbead {

/// Rows as lines with columns two blanks apart; columns in `right` (counted from 0) are right-aligned, the
/// last one is not padded. Widths count UTF-8 characters, not bytes. Every row has as many cells as the
/// first.
std::string text_table(const std::vector<std::vector<std::string>>& rows,
                       const std::vector<std::size_t>& right = {}, std::size_t indent = 0);

} // namespace drawbead
