#pragma once
// What a rule writes its repair with. To give a rule a fix:
//
//   1. Write, in the rule's own .cpp,
//        std::optional<Fix> fix(const RuleContext&, const Draft&, FixPlanner&)
//      and name it in the Rule (`.fix = fix`, and in `.fix_needs` what it looks at beyond the check's needs).
//      The draft is what the rule's check said: interface_id, surface_id and places lead to the subject.
//   2. Say in RuleInfo::fix what can be expected, and let the check offer (Draft::fixes) what the fix will
//   do,
//      and nothing where it would decline: tests run the fix for every offer.
//   3. In the fix, change cells and lines with planner.cells(), add blocks with planner.add_after(), take ids
//      with planner.free_id(). Leave the planner as it is and return planner.decline("why") where the repair
//      would be a guess.
//   4. Return the Fix: its title, whether it is safe, and what changed per interface. Unsafe fixes are called
//      without --unsafe too, for the report; they are then not made.
//
// All spans refer to the deck as it was read in this round. One fix sees the deck before the others of its
// round; fixes that change the same block are made in later rounds, and rules of a later family wait until
// those before have nothing left to do (rules/fix.h has the order). After each round the result is read and
// checked again; a fix whose finding is still there, or that brings a new error, is taken back.
#include "findings/fix_report.h"
#include "fix/block_text.h"
#include "fix/cell_editor.h"
#include "fix/free_ids.h"
#include "fix/number_text.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

/// How normals are turned.
enum class NormalsMode : uint8_t {
    surfaces, ///< in the surfaces alone
    elements, ///< in the connectivity of the shells, too
};

/// What the user allows.
struct FixChoices {
    bool unsafe = false;
    NormalsMode normals = NormalsMode::surfaces;
};

struct Fix {
    std::string title;                                     ///< as in "fix: title", without a full stop
    FixAvailability applicability = FixAvailability::safe; ///< safe or unsafe
    std::vector<InterfaceChange> changes;
    /// Codes and families of errors that the damage hid, since rules keep quiet where they cannot judge: they
    /// may be there afterwards, for the interfaces of the finding and of `changes`.
    std::vector<std::string_view> uncovers = {};
};

class FixPlanner {
public:
    FixPlanner(const Deck& deck, const OptionIndex& options, FreeIds& ids, const FixChoices& choices)
        : deck_(deck), options_(options), ids_(ids), choices_(choices), cells_(deck) {}

    const Deck& deck() const { return deck_; }
    const OptionIndex& options() const { return options_; }
    const FixChoices& choices() const { return choices_; }

    /// Changes of what is there.
    CellEditor& cells() { return cells_; }
    /// Puts the text of a BlockWriter or BlockCopy after the last data line of `served`; several in the order
    /// of the calls.
    void add_after(BlockIndex served, const std::string& text);
    /// A free id as it is written in the scope of `served`; 0, and the fix fails, when there is none.
    int64_t free_id(Family, BlockIndex served);
    int64_t free_node_id(BlockIndex served);

    /// No other fix of this round may change this block. Blocks that are changed are claimed already.
    void claim(BlockIndex block) { claims_.insert(block); }

    /// `return planner.decline("why there is no safe repair")`.
    std::nullopt_t decline(std::string why) {
        cells_.fail(std::move(why));
        return std::nullopt;
    }

    bool failed() const { return cells_.failed(); }
    const std::string& failure() const { return cells_.failure(); }
    /// For the engine: the edits in order, and the blocks claimed by call.
    EditList edits();
    const std::set<BlockIndex>& claims() const { return claims_; }

private:
    const Deck& deck_;
    const OptionIndex& options_;
    FreeIds& ids_;
    FixChoices choices_;
    CellEditor cells_;
    std::map<BlockIndex, std::string> added_;
    std::set<BlockIndex> claims_;
};

} // namespace drawbead
