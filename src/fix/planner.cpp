#include "fix/planner.h"

#include <algorithm>

namespace drawbead {

namespace {

/// Whether ids may exist that were not read.
bool lost_an_include(const Deck& deck) {
    return std::any_of(deck.notices().begin(), deck.notices().end(), [](const Notice& n) {
        using Kind = Notice::Kind;
        return n.kind == Kind::include_missing || n.kind == Kind::include_unreadable ||
               n.kind == Kind::include_too_deep || n.kind == Kind::include_outside_root;
    });
}

constexpr const char* ids_unknown = "an include could not be read: no id is known to be free";

} // namespace

void FixPlanner::add_after(BlockIndex served, const std::string& text) {
    if (text.empty()) return cells_.fail("a block could not be written");
    added_[served] += text;
    claims_.insert(served);
}

int64_t FixPlanner::free_id(Family family, BlockIndex served) {
    if (lost_an_include(deck_)) cells_.fail(ids_unknown);
    const int64_t id = ids_.take(family, served);
    if (id == 0) cells_.fail("no id is free for a new " + std::string(family_name(family)));
    return id;
}

int64_t FixPlanner::free_node_id(BlockIndex served) {
    if (lost_an_include(deck_)) cells_.fail(ids_unknown);
    const int64_t id = ids_.take_node(served);
    if (id == 0) cells_.fail("no id is free for a new node");
    return id;
}

EditList FixPlanner::edits() {
    for (auto& [served, text] : added_) {
        const BlockEnd end = block_end(deck_, served);
        if (end.unended) {
            text.insert(0, end.line_end);
            text.erase(text.size() - end.line_end.size());
        }
        cells_.replace(end.at, std::move(text));
    }
    added_.clear();
    return cells_.edits();
}

} // namespace drawbead
