#include "fix/free_ids.h"

#include <algorithm>

namespace drawbead {

namespace {

constexpr int64_t largest_id = 1'099'999'999, largest_narrow_id = 99'999'999;

} // namespace

FreeIds::FreeIds(const Deck& deck, const OptionIndex& options, const Model& model) : deck_(&deck) {
    for (std::size_t f = 0; f < families; ++f)
        for (const Option& option : options.all(static_cast<Family>(f)))
            used_[f].insert(option.id);
    for (const Family family : {Family::node_group, Family::surface, Family::line, Family::shell_group,
                                Family::sh3n_group, Family::brick_group})
        for (const Option& set : options.all(Family::set))
            used_[static_cast<std::size_t>(family)].insert(set.id);
    for (const Block& block : deck.blocks())
        if (is_option(block.keyword, "INTER/SUB"))
            used_[static_cast<std::size_t>(Family::interface)].insert(
                Deck::global_id(block.id, deck.scope(block.scope).offsets.general));
    for (const uint32_t id : model.nodes().id)
        largest_node_ = std::max(largest_node_, int64_t{id});
}

int64_t FreeIds::take(std::set<int64_t>& used, int64_t largest, BlockIndex served, bool node) {
    std::vector<int64_t> offsets;
    bool narrow = false;
    for (const BlockIndex i : instances_of(*deck_, served)) {
        const Scope& scope = deck_->scope(deck_->blocks()[i].scope);
        offsets.push_back(node ? scope.offsets.node : scope.offsets.general);
        narrow = narrow || scope.layout < 45;
    }
    const auto [least, most] = std::minmax_element(offsets.begin(), offsets.end());
    const int64_t limit = narrow ? largest_narrow_id : largest_id;
    const auto free = [&](int64_t written) {
        return std::none_of(offsets.begin(), offsets.end(),
                            [&](int64_t o) { return used.count(written + o) != 0; });
    };
    int64_t written = std::max<int64_t>(1, largest + 1 - *least);
    if (written > limit || written + *most > largest_id) {
        if (node) return 0;
        for (written = 1; written <= limit && !free(written);)
            ++written;
        if (written > limit || written + *most > largest_id) return 0;
    }
    for (const int64_t offset : offsets)
        used.insert(written + offset);
    return written;
}

int64_t FreeIds::take(Family family, BlockIndex served) {
    std::set<int64_t>& used = used_[static_cast<std::size_t>(family)];
    return take(used, used.empty() ? 0 : *used.rbegin(), served, false);
}

int64_t FreeIds::take_node(BlockIndex served) {
    std::set<int64_t> used;
    const int64_t id = take(used, largest_node_, served, true);
    if (!used.empty()) largest_node_ = *used.rbegin();
    return id;
}

std::vector<BlockIndex> instances_of(const Deck& deck, BlockIndex index) {
    std::vector<BlockIndex> out{index};
    const Block& block = deck.blocks()[index];
    for (BlockIndex i = 0; i < deck.blocks().size(); ++i)
        if (i != index && deck.blocks()[i].header == block.header) out.push_back(i);
    return out;
}

} // namespace drawbead
