#pragma once
#include "deck/file_reader.h"
#include "deck/place.h"
#include "deck/scan.h"

#include <string>
#include <string_view>

namespace drawbead {

/// One file of a deck: its path as users know it, its bytes, and where its lines are. Places are computed,
/// not stored.
class SourceFile {
public:
    struct Position {
        uint64_t line = 1;   ///< from 1
        uint32_t column = 1; ///< bytes from 1
    };

    SourceFile(std::string path, FileBytes bytes, unsigned threads);

    const std::string& path() const { return path_; }
    std::string_view bytes() const { return bytes_.view(); }
    std::string_view text(uint64_t begin, uint64_t end) const { return bytes().substr(begin, end - begin); }
    const std::vector<uint64_t>& marks() const { return scan_.marks; }
    /// Comment lines that may speak to a tool: "# word: …".
    const std::vector<uint64_t>& remarks() const { return scan_.remarks; }

    Position at(uint64_t offset) const;
    /// Newlines in [0, offset).
    uint64_t newlines_before(uint64_t offset) const;
    uint64_t lines() const;
    /// The offset of the first byte of the line that holds `offset`, and its text without the line end.
    uint64_t line_begin(uint64_t offset) const;
    std::string_view line_at(uint64_t offset) const;
    /// The offset just after the line end of the line that holds `offset`.
    uint64_t next_line(uint64_t offset) const;

private:
    std::string path_;
    FileBytes bytes_;
    LineScan scan_;
};

} // namespace drawbead
