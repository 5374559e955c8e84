#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

/// The candidate that was probably meant: fewest insertions, deletions, changes and swaps of neighbours,
/// letter case aside; the first of equals. Empty when even the best one differs in more than a third of its
/// letters.
std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates);

/// "did you mean 'x'?", or "" when nothing is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

std::string upper_case(std::string_view); ///< ASCII letters only

} // namespace drawbead
