#include "model/attachments.h"

#include "model/cards/options.h"
#include "model/drawbead_reader.h"
#include "model/option_reader.h"

#include <algorithm>

namespace drawbead {

namespace {

Attachment::Kind kind_of(std::string_view keyword) {
    if (keyword == "RBODY") return Attachment::Kind::rigid_body;
    if (keyword == "BCS") return Attachment::Kind::boundary_condition;
    if (keyword == "IMPVEL") return Attachment::Kind::imposed_velocity;
    if (keyword == "IMPDISP") return Attachment::Kind::imposed_displacement;
    return Attachment::Kind::other;
}

} // namespace

std::vector<Holder> read_holders(const Deck& deck, const OptionIndex& index, IssueLog& issues) {
    std::vector<Holder> holders;
    const auto blocks = deck.blocks();
    for (BlockIndex i = 0; i < blocks.size(); ++i) {
        const std::string_view keyword = blocks[i].keyword;
        const auto* known =
            std::find_if(std::begin(node_holders), std::end(node_holders), [&](const NodeHolder& h) {
                // Other forms (/BCS/CYCLIC, /IMPVEL/FGEO …) have other cards.
                return keyword == h.keyword ||
                       (is_option(keyword, h.keyword) && subtype(keyword) == "LAGMUL");
            });
        if (known == std::end(node_holders)) continue;
        OptionReader reader(deck, i, issues);
        Span line;
        if (!reader.line(line)) continue;
        const Scope& scope = reader.scope();
        const uint32_t width = scope.layout < 45 ? 8 : 10;
        const auto id_at = [&](uint32_t column, int64_t offset) {
            const uint32_t cell = (column - 1) / 10;
            return Deck::global_id(
                read_cell(deck, blocks[i].scope, line, cell * width + 1, width, Kind::integer).integer,
                offset);
        };
        Holder holder;
        holder.attachment = {kind_of(known->keyword), Deck::global_id(blocks[i].id, scope.offsets.general),
                             i};
        for (uint32_t n = 0; n < known->own_nodes; ++n)
            if (const int64_t node = id_at(10 * n + 1, scope.offsets.node); node > 0)
                holder.nodes.push_back(node);
        if (known->group_column)
            if (const int64_t group = id_at(known->group_column, scope.offsets.general); group != 0)
                holder.group = find_node_group(index, group);
        if (holder.group || !holder.nodes.empty()) holders.push_back(std::move(holder));
    }
    return holders;
}

std::map<uint32_t, std::vector<Attachment>> find_attachments(const std::vector<Holder>& holders,
                                                             Resolver& resolver, const NodeSet& nodes) {
    std::map<uint32_t, std::vector<Attachment>> attachments;
    std::map<BlockIndex, std::vector<NodeRow>> held_by_group; // one group may serve many conditions
    for (const Holder& holder : holders) {
        std::vector<NodeRow> held;
        if (holder.group) {
            auto known = held_by_group.find(*holder.group);
            if (known == held_by_group.end()) {
                NodeSet set(nodes.capacity());
                resolver.nodes(*holder.group, set, &nodes);
                set.intersect(nodes);
                known = held_by_group.emplace(*holder.group, set.rows()).first;
            }
            held = known->second;
        }
        for (const int64_t id : holder.nodes) {
            const auto row = resolver.row(id);
            if (row && nodes.contains(*row) && std::find(held.begin(), held.end(), *row) == held.end())
                held.push_back(*row);
        }
        for (const NodeRow row : held)
            attachments[index(row)].push_back(holder.attachment);
    }
    return attachments;
}

} // namespace drawbead
