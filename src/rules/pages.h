#pragma once
// The Markdown pages of the rules, embedded at build time from the .md files beside the rules.
#include <span>
#include <string_view>

namespace drawbead {

struct Page {
    std::string_view code; ///< "SRF001"
    std::string_view text;
};

/// Sorted by code.
std::span<const Page> pages();

} // namespace drawbead
