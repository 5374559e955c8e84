#pragma once
// What the rules about cards, references and parameters share.
#include "rules/card_lines.h"
#include "rules/rule.h"
#include "rules/syn/columns.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

/// What stands on the lines of an interface.
const CardLines& cards_of(const RuleContext&, const Drawbead&);
/// Whether the values that the solver reads of it are those that were meant.
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

/// A force per length of the model as the cards of the interface would have it.
double in_units_of_block(const RuleContext&, const Drawbead&, double force_per_length);

/// A sentence for findings about things that may stand in an include that could not be read; empty when all
/// could.
std::string lost_include_note(const Deck&, std::string_view what = "it");
/// The same, added to the notes of a finding.
void note_lost_include(const RuleContext&, std::string_view what, Draft&);

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
