#include "model/users.h"

#include "model/cards/references.h"
#include "model/option_reader.h"
#include "model/sets.h"

#include <algorithm>
#include <map>
#include <set>

namespace drawbead {

namespace {

/// Ids that one option names, by what they are.
struct Named {
    std::set<int64_t> groups, surfaces;
    bool both = false; ///< cards not known: `groups` holds every number, for surfaces too
};

Named names_of(const Deck& deck, BlockIndex index) {
    const Block& block = deck.blocks()[index];
    const Scope& scope = deck.scope(block.scope);
    IssueLog unreported;
    Named named;
    const auto global = [&](int64_t id) {
        const int64_t with_offset = Deck::global_id(id, scope.offsets.general);
        return with_offset < 0 ? -with_offset : with_offset;
    };
    bool known = false;
    for (const Reference& reference : references) {
        if (!is_option(block.keyword, reference.keyword)) continue;
        known = true;
        std::set<int64_t>& ids = reference.link == Link::surface ? named.surfaces : named.groups;
        if (reference.card == 0) {
            for (const WrittenId& id : read_ids(deck, block, unreported))
                ids.insert(global(id.id));
            continue;
        }
        OptionReader reader(deck, index, unreported);
        Span line;
        for (uint8_t card = 0; card < reference.card; ++card)
            if (!reader.line(line)) return named;
        ids.insert(global(read_cell(deck, block.scope, line, reference.column, 10, Kind::integer).integer));
    }
    if (known) return named;
    for (const std::string_view keyword : without_references)
        if (is_option(block.keyword, keyword)) return named;
    named.both = true;
    for (const WrittenId& id : read_ids(deck, block, unreported))
        named.groups.insert(global(id.id));
    return named;
}

} // namespace

void find_users(const Deck& deck, const OptionIndex& index, std::vector<NodeGroup>& groups,
                std::vector<Surface>& surfaces) {
    if (groups.empty() && surfaces.empty()) return;
    for (BlockIndex i = 0; i < deck.blocks().size(); ++i) {
        const Named named = names_of(deck, i);
        for (NodeGroup& group : groups)
            if (group.block != i && named.groups.count(group.id)) group.users.push_back(i);
        for (Surface& surface : surfaces)
            if (surface.block != i && (named.both ? named.groups : named.surfaces).count(surface.id))
                surface.users.push_back(i);
    }
    // Sets that take other sets in.
    IssueLog unreported;
    for (const Option& set : index.all(Family::set))
        for (const SetClause& clause : read_set(deck, index, set.block, unreported))
            for (const Member& member : clause.members) {
                if (member.kind != MemberKind::set) continue;
                const auto other = index.find(Family::set, member.first);
                for (NodeGroup& group : groups)
                    if (other == group.block) group.users.push_back(set.block);
                for (Surface& surface : surfaces)
                    if (other == surface.block) surface.users.push_back(set.block);
            }
}

} // namespace drawbead
