#pragma once
// Changes of cells and lines, in the columns of the card at hand.
#include "deck/card.h"
#include "deck/deck.h"
#include "deck/edit.h"
#include "model/entities.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace drawbead {

/// Collects changes of one or more files. What cannot be written in the columns there are makes the whole
/// editor fail, with a reason; it then has no edits.
class CellEditor {
public:
    explicit CellEditor(const Deck& deck) : deck_(deck) {}

    /// Writes a field of a card as read (`card.present`), right-aligned in its columns, or in its place on a
    /// line with commas. An empty text blanks it. A cell that holds `&name` loses it: the parameter stays as
    /// it is for others.
    void set_cell(const Card&, std::string_view field, std::string_view text);
    /// Writes columns of a line (without its line end); columns count from 1. The line grows when it must.
    void set_columns(const Span& line, uint32_t column, uint32_t width, std::string_view text);
    /// Replaces one id of a list; `place` is its text as read, `written` the id before the scope's offset.
    void set_listed_id(ScopeId, const Span& place, int64_t written);
    /// Replaces the id of a block's header.
    void set_header_id(BlockIndex, int64_t written);
    /// Replaces bytes. Not for lines of which cells are set.
    void replace(const Span&, std::string text);
    /// Takes away the whole lines that `lines` touches.
    void delete_lines(const Span& lines);

    void fail(std::string why) {
        if (failure_.empty()) failure_ = std::move(why);
    }
    bool failed() const { return !failure_.empty(); }
    const std::string& failure() const { return failure_; }
    /// In order, and no more than what changes. Fails when two changes meet.
    EditList edits();

private:
    struct Line {
        uint64_t end = 0;
        std::string text;
    };
    const Deck& deck_;
    std::map<std::pair<FileId, uint64_t>, Line> lines_; ///< by file and begin
    EditList other_;
    std::string failure_;

    std::string& line(const Span&);
};

} // namespace drawbead
