#include "base/parallel.h"
#include "model/resolver.h"

#include <algorithm>

namespace drawbead {

namespace {

constexpr uint32_t rows_per_piece = 1u << 16;
constexpr std::size_t longest_list = 50'000'000; ///< groups of groups can double at every level

} // namespace

void Resolver::add_nodes(const ElementRows& rows, NodeSet& set, const NodeSet* only) const {
    const auto add = [&](const auto& elements, const RowSet& picked) {
        std::vector<RowRun> pieces;
        for (const RowRun& run : picked.runs())
            for (uint32_t begin = run.begin; begin < run.end; begin += rows_per_piece)
                pieces.push_back({begin, std::min(run.end, begin + rows_per_piece)});
        parallel_for(threads_, pieces.size(), [&](std::size_t p) {
            for (uint32_t i = pieces[p].begin; i < pieces[p].end; ++i)
                for (const NodeRow node : elements[i])
                    if (node != no_node && (!only || only->contains(node))) set.insert_shared(node);
        });
    };
    add(tables_.shells4.nodes, rows.shells4);
    add(tables_.shells3.nodes, rows.shells3);
    add(tables_.solids.nodes, rows.solids);
    if (!tables_.solids.mid.empty()) add(tables_.solids.mid, rows.solids);
}

void Resolver::add_listed_nodes(const Block& block, NodeSet& set, const NodeSet* only) {
    const std::vector<Span> pieces = line_pieces(deck_, list_text(deck_, block));
    std::vector<IssueLog> logs(pieces.size());
    std::vector<std::vector<WrittenId>> missing(pieces.size());
    const int64_t offset = deck_.scope(block.scope).offsets.node;
    parallel_for(threads_, pieces.size(), [&](std::size_t p) {
        for_each_id(deck_, block.scope, pieces[p], logs[p], [&](const WrittenId* ids, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) {
                if (ids[i].id <= 0) continue;
                const auto node = row(Deck::global_id(ids[i].id, offset));
                if (!node) {
                    if (missing[p].size() < IssueLog::limit) missing[p].push_back(ids[i]);
                } else if (!only || only->contains(*node)) {
                    set.insert_shared(*node);
                }
            }
        });
    });
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        for (const ReadIssue& issue : logs[p].take())
            report(issue.kind, issue.place, issue.subject, issue.detail);
        for (const WrittenId& id : missing[p])
            report(ReadIssue::Kind::member_missing, id.place,
                   "node " + std::to_string(Deck::global_id(id.id, offset)));
    }
}

void Resolver::add_node_range(const Member& member, NodeSet& set, const NodeSet* only) const {
    const NodeTable& nodes = tables_.nodes;
    const int64_t last = std::min<int64_t>(member.last, 0xfffffffe);
    const auto take = [&](NodeRow node) {
        if (!only || only->contains(node)) set.insert(node);
    };
    if ((last - member.first) / member.step <= 4 * int64_t{nodes.size()}) {
        for (int64_t id = member.first; id <= last; id += member.step)
            if (const auto node = row(id)) take(*node);
        return;
    }
    for (uint32_t i = 0; i < nodes.size(); ++i)
        if (nodes.id[i] >= member.first && nodes.id[i] <= last &&
            (nodes.id[i] - member.first) % member.step == 0)
            take(NodeRow{i});
}

void Resolver::add_surface_nodes(const SurfaceContent& content, NodeSet& set, const NodeSet* only) const {
    const auto take = [&](NodeRow node) {
        if (node != no_node && (!only || only->contains(node))) set.insert(node);
    };
    for (const auto& chunk : content.listed)
        for (const ListedSegment& segment : chunk)
            for (const int32_t id : segment.node)
                if (const auto node = row(id)) take(*node);
    const auto rows = [](const std::vector<SegmentRun>& runs) {
        std::vector<RowRun> plain;
        for (const SegmentRun& run : runs)
            plain.push_back({run.begin, run.end});
        return RowSet::of_runs(std::move(plain));
    };
    add_nodes({rows(content.shells4), rows(content.shells3), {}}, set, only);
    for (const Segment& face : content.faces)
        for (const NodeRow node : face.n)
            take(node);
}

bool Resolver::add_member_nodes(const Member& member, NodeSet& set, const NodeSet* only) {
    const auto missing = [&] {
        report(ReadIssue::Kind::member_missing, member.place, std::to_string(member.first));
        return true;
    };
    switch (member.kind) {
    case MemberKind::node:
        add_node_range(member, set, only);
        return true;
    case MemberKind::node_group: {
        const auto group = index_.find(Family::node_group, member.first);
        if (!group) return missing();
        auto& cache = group_cache_[only ? 1 : 0];
        auto known = cache.find(*group);
        if (known == cache.end()) {
            NodeSet all(tables_.nodes.size());
            if (!nodes(*group, all, only)) return false;
            known = cache.emplace(*group, std::move(all)).first;
        }
        set.unite(known->second);
        return true;
    }
    case MemberKind::surface: {
        const auto other = index_.find(Family::surface, member.first);
        if (!other) return missing();
        const SurfaceContent content = surface(*other);
        add_surface_nodes(content, set, only);
        return content.evaluated;
    }
    case MemberKind::line: {
        const auto line = index_.find(Family::line, member.first);
        if (!line) return missing();
        const Block& block = deck_.blocks()[*line];
        if (block.keyword != "LINE/SEG") {
            report(ReadIssue::Kind::not_supported, block.header, std::string(block.keyword));
            return false;
        }
        // Two nodes per line behind the segment's own id.
        DataLines lines(deck_, list_text(deck_, block));
        Span text;
        while (lines.next_filled(text))
            for (const uint32_t column : {11u, 21u}) {
                const Cell cell = read_cell(deck_, block.scope, text, column, 10, Kind::integer);
                const auto node = row(Deck::global_id(cell.integer, deck_.scope(block.scope).offsets.node));
                if (issues_.check(cell, "node_ID") && node && (!only || only->contains(*node)))
                    set.insert(*node);
            }
        return true;
    }
    case MemberKind::box: {
        const std::optional<NodeSet> inside = nodes_in_box(member);
        if (!inside) return !index_.find(Family::box, member.first);
        NodeSet wanted = *inside;
        if (only) wanted.intersect(*only);
        set.unite(wanted);
        return true;
    }
    case MemberKind::submodel:
        for (const RowPiece& piece : tables_.nodes.pieces)
            if (picker_.in_submodel(deck_.blocks()[piece.block].scope, member.first))
                for (uint32_t i = piece.row_begin; i < piece.row_end; ++i)
                    if (!only || only->contains(NodeRow{i})) set.insert(NodeRow{i});
        return true;
    default: {
        bool supported = true;
        add_nodes(elements(member, supported), set, only);
        return supported;
    }
    }
}

bool Resolver::nodes(BlockIndex index, NodeSet& set, const NodeSet* only) {
    const Block& block = deck_.blocks()[index];
    if (is_node_list(block.keyword)) {
        add_listed_nodes(block, set, only);
        return true;
    }
    if (subtype(block.keyword) == "GRNODNS") {
        std::vector<NodeRow> rows;
        const bool evaluated = ordered_nodes(index, nullptr, rows);
        for (const NodeRow node : rows)
            if (!only || only->contains(node)) set.insert(node);
        return evaluated;
    }
    const OpenOption open(open_, index);
    if (!open) return true; // recursion: the solver stops with an error of its own
    if (is_option(block.keyword, "SET")) {
        const SetContent content = set_content(index, true);
        NodeSet all = content.nodes;
        if (only) all.intersect(*only);
        set.unite(all);
        return content.evaluated;
    }
    const Membership membership = read_membership(deck_, index, issues_);
    bool evaluated = membership.supported;
    if (!evaluated) {
        report(ReadIssue::Kind::not_supported, block.header, std::string(block.keyword));
        return false;
    }
    NodeSet minus(tables_.nodes.size());
    bool any_minus = false;
    for (const Member& member : membership.members) {
        any_minus |= member.minus;
        evaluated &= add_member_nodes(member, member.minus ? minus : set, only);
    }
    if (any_minus) set.subtract(minus);
    return evaluated;
}

std::vector<NodeRow> Resolver::by_user_id(const NodeSet& set) const {
    std::vector<NodeRow> rows = set.rows();
    const auto before = [&](NodeRow a, NodeRow b) {
        return tables_.nodes.id[drawbead::index(a)] < tables_.nodes.id[drawbead::index(b)];
    };
    if (!std::is_sorted(rows.begin(), rows.end(), before)) std::sort(rows.begin(), rows.end(), before);
    return rows;
}

bool Resolver::ordered_nodes(BlockIndex index, NodeGroup* group, std::vector<NodeRow>& rows) {
    const Block& block = deck_.blocks()[index];
    const Scope& scope = deck_.scope(block.scope);
    if (is_ordered_list(block.keyword)) {
        for (const WrittenId& id : read_ids(deck_, block, issues_)) {
            ListedNode listed{id.id, no_node, id.place};
            if (const auto node = row(Deck::global_id(id.id, scope.offsets.node))) {
                listed.row = *node;
                rows.push_back(*node);
            }
            if (group) group->listed.push_back(listed);
        }
        return true;
    }
    if (subtype(block.keyword) == "GRNODNS") {
        const OpenOption open(open_, index);
        if (!open) return true;
        bool evaluated = true;
        for (const WrittenId& id : read_ids(deck_, block, issues_)) {
            if (id.id == 0) continue;
            const int64_t other = Deck::global_id(id.id, scope.offsets.general);
            const auto member = index_.find(Family::node_group, other < 0 ? -other : other);
            if (!member) {
                report(ReadIssue::Kind::member_missing, id.place, std::to_string(other < 0 ? -other : other));
                continue;
            }
            evaluated = evaluated && ordered_nodes(*member, nullptr, rows);
            if (rows.size() > longest_list) {
                report(ReadIssue::Kind::not_supported, block.header, "GRNODNS", "over 50 million entries");
                return false;
            }
        }
        return evaluated;
    }
    NodeSet set(tables_.nodes.size());
    const bool evaluated = nodes(index, set);
    const std::vector<NodeRow> sorted = by_user_id(set);
    rows.insert(rows.end(), sorted.begin(), sorted.end());
    return evaluated;
}

void Resolver::take_set_nodes(BlockIndex block, NodeGroup& group) {
    const std::vector<SetClause> clauses = read_set(deck_, index_, block, issues_);
    std::set<uint32_t> removed;
    bool lost = false;
    for (const SetClause& clause : clauses) {
        if (clause.key != "NODENS") continue;
        lost = lost || clause.remove || clause.intersect || !group.nodens_clauses.empty();
        group.nodens_clauses.push_back(clause.place);
        if (!clause.supported) {
            report(ReadIssue::Kind::not_supported, clause.place,
                   "SET clause " + std::string(deck_.text(clause.place)));
            group.evaluated = false;
        }
        for (const WrittenId& id : clause.nodes) {
            ListedNode listed{id.id, no_node, id.place};
            if (const auto node = row(Deck::global_id(id.id, deck_.scope(clause.scope).offsets.node))) {
                listed.row = *node;
                if (clause.remove)
                    removed.insert(index(*node));
                else
                    group.nodes.push_back(*node);
            }
            group.listed.push_back(listed);
        }
    }
    if (!group.nodens_clauses.empty()) {
        group.order = lost ? NodeGroup::Order::lost_in_set : NodeGroup::Order::unsorted;
        std::erase_if(group.nodes, [&](NodeRow node) { return removed.count(index(node)) != 0; });
        if (!group.evaluated) group.nodes.clear();
        return;
    }
    const SetContent content = set_content(block, true);
    group.evaluated = content.evaluated;
    if (content.evaluated) group.nodes = by_user_id(content.nodes);
}

NodeGroup Resolver::group(int64_t id, BlockIndex index) {
    const Block& block = deck_.blocks()[index];
    NodeGroup group;
    group.id = id;
    group.block = index;
    group.title = OptionReader(deck_, index, issues_).title();
    if (is_option(block.keyword, "SET")) {
        group.type = "SET";
        take_set_nodes(index, group);
        return group;
    }
    group.type = subtype(block.keyword);
    if (is_ordered_list(block.keyword) || group.type == "GRNODNS") {
        if (is_ordered_list(block.keyword)) group.type = "NODENS";
        group.order = NodeGroup::Order::unsorted;
        group.evaluated = ordered_nodes(index, &group, group.nodes);
        if (!group.evaluated) group.nodes.clear();
        return group;
    }
    NodeSet set(tables_.nodes.size());
    if (is_node_list(block.keyword)) {
        const int64_t offset = deck_.scope(block.scope).offsets.node;
        for (const WrittenId& written : read_ids(deck_, block, issues_)) {
            ListedNode listed{written.id, no_node, written.place};
            if (const auto node = row(Deck::global_id(written.id, offset))) {
                listed.row = *node;
                set.insert(*node);
            }
            group.listed.push_back(listed);
        }
    } else {
        group.evaluated = nodes(index, set);
    }
    if (group.evaluated) group.nodes = by_user_id(set);
    return group;
}

} // namespace drawbead
