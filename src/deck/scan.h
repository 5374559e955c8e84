#pragma once
// One pass over the bytes of a file: where its keyword lines and directives start, and how many lines there
// are.
#include <cstdint>
#include <string_view>
#include <vector>

namespace drawbead {

struct LineScan {
    static constexpr uint64_t stride = uint64_t{1} << 17;

    std::vector<uint64_t>
        marks; ///< offsets of line starts with '/', or with a '#' directive (include, enddata, …)
    std::vector<uint64_t> remarks;  ///< offsets of comment lines that begin with a word and a colon
    std::vector<uint64_t> newlines; ///< newlines in [0, k·stride), for k = 0 … ceil(size/stride)
};

/// Scans in pieces of `stride` bytes on `threads` threads; the result does not depend on their count.
LineScan scan_lines(std::string_view bytes, unsigned threads);

/// Number of '\n' in `bytes`.
uint64_t count_newlines(std::string_view bytes);

} // namespace drawbead
