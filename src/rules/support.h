#pragma once
// What the rules about cards, references and parameters share.
#include "rules/rule.h"
#include "rules/syn/columns.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

/// The lines of a /INTER/TYPE8 and what is missing of them. The solver counts lines: one that is missing
/// shifts all that follow.
struct CardLines {
    enum class Missing : uint8_t {
        nothing,
        all,         ///< no line at all
        title,       ///< the first card stands in its place
        card_1,      ///< the card of forces stands in its place
        card_2,      ///< only the first card is there
        card_2_or_3, ///< two cards, and the last one may be either
        card_3,      ///< the card of Fn_last and Ft_last
        blank_card,  ///< the blank third card of layouts below 2022
    };
    std::vector<Span> lines; ///< data lines: title, cards, extra ones; blank lines after the third card left
                             ///< out; none below layout 51, where titles stand on the header
    Missing missing = Missing::nothing;
    bool shifted = false; ///< there is a line too many before the first card

    /// Text that does not fit its columns, of cards 1, 2 and 3.
    std::array<std::optional<ColumnFault>, 3> fault;

    /// Whether each card stands on its line.
    bool complete() const {
        return !shifted &&
               (missing == Missing::nothing || missing == Missing::card_3 || missing == Missing::blank_card);
    }
    /// Whether the values that the solver reads are those that were meant; other rules keep quiet otherwise.
    bool usable() const { return complete() && !fault[0] && !fault[1] && !fault[2]; }
    bool has_card(std::size_t number) const { return lines.size() > number; }
};
CardLines card_lines(const Deck&, const Drawbead&);
bool cards_usable(const RuleContext&, const Drawbead&);

/// Card 1, 2 or 3 cut into all of its columns, whatever the deck's version reads of it: card 1 into "1-10" …
/// "91-100", cards 2 and 3 into "1-20" … "81-100".
Card all_columns(const Deck&, const Drawbead&, const Span& line, int card);

/// Layout and version that hold where the interface is written.
const Scope& scope_of(const Deck&, const Drawbead&);

/// "bead 11", the name of an interface in messages.
std::string bead_name(const Drawbead&);

/// A draft about an interface, placed at one of its cells, or at its header where the cell does not exist.
Draft draft_at(const RuleContext&, const Drawbead&, const Cell&);
Draft draft_at_header(const RuleContext&, const Drawbead&);

/// The cells of a drawbead by the names of the manual.
struct DrawbeadCells {
    const Cell &group, &surface, &iform, &fn, &ft, &depth, &t_start, &t_stop, &fn_last, &ft_last;
};
DrawbeadCells cells_of(const Drawbead&);

/// Whether a value could be read: not garbage, not an unknown parameter. Blank is a value (0).
bool readable(const Cell&);

/// Length of the polyline through the bead's nodes in work units; 0 when its nodes are not known.
double line_length(const Model&, const Drawbead&);

/// "1400 N over 10 mm": a force per length (work units) times the length of the bead; empty when that is not
/// known.
std::string force_over_line(const RuleContext&, const Drawbead&, double force_per_length);

/// Adds a force over the whole line as a measure in N-like units; nothing when the length is not known.
void measure_force(const RuleContext&, const Drawbead&, std::string name, double force_per_length, Draft&);

/// A sentence for findings about things that may stand in an include that could not be read; empty when all
/// could.
std::string lost_include_note(const Deck&);

/// Finds the block that holds a place, by a binary search; sorts the blocks at the first question.
class BlockFinder {
public:
    explicit BlockFinder(const Deck& deck) : deck_(deck) {}
    /// nullptr when the place is in no block.
    const Block* at(const Span&);

private:
    const Deck& deck_;
    std::vector<const Block*> blocks_; ///< by file and place
};

/// Whether the text of a block is read for drawbeads at all: interfaces, node groups, surfaces, sets.
bool concerns_drawbeads(const Block&);

/// "/GRNOD/NODENS/2"
std::string header_name(const Block&);

/// The interface of a draft; nullptr when there is none.
const Drawbead* drawbead_of(const RuleContext&, const Draft&);

/// The fix of rules whose remedy is the incremental form: Iform 2, unsafe.
inline constexpr const char* iform_2_title = "Iform 2";
std::optional<Fix> write_iform_2(const RuleContext&, const Draft&, FixPlanner&);

/// The fix of a negative limit, the field of which is the draft's discriminator: the same number without its
/// sign, unsafe.
inline constexpr const char* positive_title = "the same number without its sign";
std::optional<Fix> write_positive(const RuleContext&, const Draft&, FixPlanner&);

/// What faults of the cards hide of an interface: other rules keep quiet while its cards are not usable.
std::vector<std::string_view> hidden_by_cards();

/// Places that are told in one finding: the first is the primary one.
void set_places(Draft&, const std::vector<Span>& places);

} // namespace drawbead
