#pragma once
// Ids that nothing in the deck has.
#include "model/model.h"
#include "model/option_index.h"

#include <array>
#include <set>

namespace drawbead {

/// The same deck gives the same ids. Ids of sets count for node groups, surfaces and element groups, too.
class FreeIds {
public:
    FreeIds(const Deck&, const OptionIndex&, const Model&);

    /// An id to be written in the scope of `served`, one above all that are there; free in every instance of
    /// the file that holds the block. It is taken from now on. 0 when none can be written.
    int64_t take(Family, BlockIndex served);
    /// A user id for a new node beside the option `served`; needs coordinates. 0 as above.
    int64_t take_node(BlockIndex served);

private:
    static constexpr auto families = static_cast<std::size_t>(Family::count_);
    const Deck* deck_;
    std::array<std::set<int64_t>, families> used_; ///< global
    int64_t largest_node_ = 0;

    int64_t take(std::set<int64_t>&, int64_t largest, BlockIndex served, bool node);
};

/// The blocks that are instances of the same text: a file that is included twice has two of each. The given
/// one first.
std::vector<BlockIndex> instances_of(const Deck&, BlockIndex);

} // namespace drawbead
