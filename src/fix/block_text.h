#pragma once
// New blocks, in the layout, width and line ends of the block that they stand beside.
#include "deck/card.h"
#include "deck/deck.h"
#include "fix/cell_editor.h"
#include "model/entities.h"

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace drawbead {

/// Where a new block goes: after the last data line of `served`.
struct BlockEnd {
    Span at; ///< empty
    std::string line_end;
    bool unended =
        false; ///< the last line there has no line end: one is put before the new block, none after
};
BlockEnd block_end(const Deck&, BlockIndex served);

/// Writes a block. Ids are as written, without the offsets of the scope of `served`.
class BlockWriter {
public:
    BlockWriter(const Deck&, BlockIndex served);

    /// The keyword without its first slash: "GRSHEL/SHEL". Layouts without title lines have the title here.
    void header(std::string_view keyword, int64_t id, std::string_view title, int64_t unit = 0);
    /// Ten to a line.
    void ids(std::span<const int64_t>);
    /// Fields by name; those that the layout does not have are left out, others are blank.
    void card(const CardSchema&, std::initializer_list<std::pair<std::string_view, std::string_view>>);
    void line(std::string_view);

    uint32_t id_width() const { return layout_ < 45 ? 8 : 10; }
    const std::string& text() const { return text_; }

private:
    int layout_;
    bool title_lines_;
    std::string line_end_, text_;
};

/// A copy of a block with some cells changed. Include lines are not copied; changes are made with spans and
/// cards of the original.
class BlockCopy {
public:
    BlockCopy(const Deck&, BlockIndex);

    CellEditor& cells() { return editor_; }
    /// Header, comments and data lines; empty when a change failed.
    std::string text();

private:
    const Deck& deck_;
    BlockIndex block_;
    CellEditor editor_;
};

} // namespace drawbead
