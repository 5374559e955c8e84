#pragma once
// The lines of a TYPE8 block: which card stands on which.
#include "deck/deck.h"
#include "model/entities.h"
#include "rules/syn/columns.h"

#include <array>
#include <cstddef>
#include <optional>
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

} // namespace drawbead
