#pragma once
// Walks the lines of one option: its title, then cards or a list of ids.
#include "model/entities.h"
#include "model/issue_log.h"
#include "model/option_index.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace drawbead {

class OptionReader {
public:
    /// Reads the title line. Blank lines count as cards of blank cells.
    OptionReader(const Deck&, BlockIndex, IssueLog&, bool titled = true);

    const Block& block() const { return block_; }
    const Scope& scope() const { return deck_.scope(block_.scope); }
    bool has_title_line() const { return has_title_line_; }
    const Span& title_line() const { return title_line_; }
    std::string title() const;

    bool line(Span& line) { return lines_.next(line); }
    /// The next line as a card, or a card that is not present; cells that cannot be read are reported.
    Card card(const CardSchema&);
    void skip_card() {
        Span unused;
        lines_.next(unused);
    }

    /// Factor to work units; 1 and one report when the option's unit id is unknown.
    double factor(Dimension);
    bool unit_known() const { return unit_known_; }
    /// A cell in work units, 0 when blank or unreadable.
    double real(const Card&, std::string_view field);
    /// A referenced id, global.
    int64_t reference(const Card& card, std::string_view field, int64_t offset) const {
        return Deck::global_id(card[field].integer, offset);
    }

private:
    const Deck& deck_;
    const Block& block_;
    IssueLog& issues_;
    DataLines lines_;
    Span title_line_;
    bool has_title_line_ = false;
    bool unit_known_ = true;
};

/// One id of a list as written, before offsets, and its cell.
struct WrittenId {
    int64_t id = 0;
    Span place;
};

/// Calls `take` for every cell of an id list that holds a number (zeros included), in order. `lines` is the
/// list's text without the title. Cells that cannot be read are reported and left out.
void for_each_id(const Deck&, ScopeId, const Span& lines, IssueLog&,
                 const std::function<void(const WrittenId*, std::size_t count)>& take);

/// Reads `count` plain integer cells (blanks, a minus sign, digits) of a line; blank cells are 0. False when
/// a cell is anything else and the line needs the exact path.
bool read_plain_cells(std::string_view text, std::size_t width, std::size_t count, int64_t* values);

/// The list's text in pieces that end at line ends, so that long lists are read by several threads. Directive
/// lines and what may continue them stay in one piece.
std::vector<Span> line_pieces(const Deck&, const Span& text);

/// The text of a block after its title line.
Span list_text(const Deck&, const Block&);

/// The whole list of a (short) option.
std::vector<WrittenId> read_ids(const Deck&, const Block&, IssueLog&);

} // namespace drawbead
