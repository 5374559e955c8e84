#include "base/parallel.h"
#include "model/resolver.h"

#include <algorithm>

namespace drawbead {

ElementRows unite(const ElementRows& a, const ElementRows& b) {
    return {unite(a.shells4, b.shells4), unite(a.shells3, b.shells3), unite(a.solids, b.solids)};
}

ElementRows subtract(const ElementRows& a, const ElementRows& b) {
    return {subtract(a.shells4, b.shells4), subtract(a.shells3, b.shells3), subtract(a.solids, b.solids)};
}

ElementRows intersect(const ElementRows& a, const ElementRows& b) {
    return {intersect(a.shells4, b.shells4), intersect(a.shells3, b.shells3), intersect(a.solids, b.solids)};
}

Resolver::Resolver(const Deck& deck, const OptionIndex& index, const PartPicker& picker, const Tables& tables,
                   IssueLog& issues, unsigned threads)
    : deck_(deck), index_(index), picker_(picker), tables_(tables), issues_(issues), threads_(threads) {
    const auto collect = [](const std::vector<ElementRange>& ranges,
                            std::map<PartId, std::vector<RowRun>>& of) {
        for (const ElementRange& range : ranges)
            of[range.part].push_back({range.row_begin, range.row_end});
    };
    collect(tables.shells4.ranges, shells4_of_);
    collect(tables.shells3.ranges, shells3_of_);
    collect(tables.solids.ranges, solids_of_);
}

void Resolver::report(ReadIssue::Kind kind, Span place, std::string subject, std::string detail) {
    // The same list may be expanded more than once.
    if (!reported_.emplace(uint64_t{index(place.file)} << 8 | static_cast<uint64_t>(kind), place.begin)
             .second)
        return;
    issues_.add(kind, place, std::move(subject), std::move(detail));
}

std::optional<NodeRow> Resolver::row(int64_t id) const {
    if (id <= 0 || id > 0xfffffffe) return std::nullopt;
    return tables_.nodes.row(NodeId{static_cast<uint32_t>(id)});
}

ElementRows Resolver::rows_of_parts(const std::vector<uint32_t>& parts) const {
    std::vector<RowRun> shells4, shells3, solids;
    const auto take = [](const std::map<PartId, std::vector<RowRun>>& of, PartId id,
                         std::vector<RowRun>& runs) {
        if (const auto found = of.find(id); found != of.end())
            runs.insert(runs.end(), found->second.begin(), found->second.end());
    };
    for (const uint32_t part : parts) {
        const PartId id = picker_.parts()[part].id;
        take(shells4_of_, id, shells4);
        take(shells3_of_, id, shells3);
        take(solids_of_, id, solids);
    }
    return {RowSet::of_runs(std::move(shells4)), RowSet::of_runs(std::move(shells3)),
            RowSet::of_runs(std::move(solids))};
}

namespace {

/// Rows of the ids first, first + step … last in a table.
RowSet rows_of_ids(const IdMap& map, std::span<const uint32_t> ids, const Member& member, bool& known) {
    std::vector<uint32_t> rows;
    const int64_t last = std::min<int64_t>(member.last, 0xfffffffe);
    if ((last - member.first) / member.step <= static_cast<int64_t>(4 * ids.size())) {
        for (int64_t id = std::max<int64_t>(member.first, 1); id <= last; id += member.step)
            if (const uint32_t row = map.row(static_cast<uint32_t>(id)); row != IdMap::none)
                rows.push_back(row);
    } else {
        for (uint32_t row = 0; row < ids.size(); ++row)
            if (ids[row] >= member.first && ids[row] <= last && (ids[row] - member.first) % member.step == 0)
                rows.push_back(row);
    }
    known = !rows.empty();
    return RowSet::of_rows(std::move(rows));
}

} // namespace

ElementRows Resolver::elements(const Member& member, bool& supported) {
    ElementRows rows;
    bool known = true;
    switch (member.kind) {
    case MemberKind::shell:
        rows.shells4 = rows_of_ids(tables_.shells4.map, tables_.shells4.id.span(), member, known);
        break;
    case MemberKind::sh3n:
        rows.shells3 = rows_of_ids(tables_.shells3.map, tables_.shells3.id.span(), member, known);
        break;
    case MemberKind::solid:
        rows.solids = rows_of_ids(tables_.solids.map, std::span(tables_.solids.id), member, known);
        break;
    case MemberKind::shell_group:
    case MemberKind::sh3n_group:
    case MemberKind::brick_group: {
        const Family family = member.kind == MemberKind::shell_group  ? Family::shell_group
                              : member.kind == MemberKind::sh3n_group ? Family::sh3n_group
                                                                      : Family::brick_group;
        const auto group = index_.find(family, member.first);
        known = group.has_value();
        if (!group) break;
        auto known_group = element_cache_.find(*group);
        if (known_group == element_cache_.end()) {
            bool can = true;
            ElementRows all = element_group(*group, can);
            known_group =
                element_cache_.emplace(*group, can ? std::optional(std::move(all)) : std::nullopt).first;
        }
        if (known_group->second)
            rows = *known_group->second;
        else
            supported = false;
        break;
    }
    case MemberKind::box:
    case MemberKind::box_touching:
        rows = rows_in_box(member, supported);
        break;
    case MemberKind::everything:
        // Elements of parts that are not defined count too.
        if (tables_.shells4.size()) rows.shells4 = RowSet::of_runs({{0, tables_.shells4.size()}});
        if (tables_.shells3.size()) rows.shells3 = RowSet::of_runs({{0, tables_.shells3.size()}});
        if (tables_.solids.size()) rows.solids = RowSet::of_runs({{0, tables_.solids.size()}});
        break;
    default:
        if (PartPicker::names_parts(member.kind))
            rows = rows_of_parts(picker_.pick(member, known));
        else
            supported = false;
    }
    if (!known && member.first == member.last)
        report(ReadIssue::Kind::member_missing, member.place, std::to_string(member.first));
    return rows;
}

Resolver::Signed Resolver::signed_elements(const Membership& membership, bool& supported) {
    struct Runs {
        std::vector<RowRun> shells4, shells3, solids;

        void add(const ElementRows& rows) {
            shells4.insert(shells4.end(), rows.shells4.runs().begin(), rows.shells4.runs().end());
            shells3.insert(shells3.end(), rows.shells3.runs().begin(), rows.shells3.runs().end());
            solids.insert(solids.end(), rows.solids.runs().begin(), rows.solids.runs().end());
        }
        ElementRows take() {
            return {RowSet::of_runs(std::move(shells4)), RowSet::of_runs(std::move(shells3)),
                    RowSet::of_runs(std::move(solids))};
        }
    };
    Runs plus, minus;
    supported = membership.supported;
    for (const Member& member : membership.members) {
        Runs& runs = member.minus ? minus : plus;
        const auto single = [&](const IdMap& map, std::vector<RowRun>& into) {
            const uint32_t row = map.row(static_cast<uint32_t>(member.first));
            if (row != IdMap::none && !into.empty() && into.back().end == row)
                ++into.back().end;
            else if (row != IdMap::none)
                into.push_back({row, row + 1});
            else
                report(ReadIssue::Kind::member_missing, member.place, std::to_string(member.first));
        };
        // Lists of elements can be long: no set of its own for each of them.
        if (member.first == member.last && member.kind == MemberKind::shell)
            single(tables_.shells4.map, runs.shells4);
        else if (member.first == member.last && member.kind == MemberKind::sh3n)
            single(tables_.shells3.map, runs.shells3);
        else if (member.first == member.last && member.kind == MemberKind::solid)
            single(tables_.solids.map, runs.solids);
        else
            runs.add(elements(member, supported));
    }
    Signed rows{plus.take(), minus.take()};
    return rows;
}

ElementRows Resolver::element_group(BlockIndex block, bool& supported) {
    const OpenOption open(open_, block);
    if (!open) return {};
    const Membership membership = read_membership(deck_, block, issues_);
    bool can = true;
    const Signed rows = signed_elements(membership, can);
    const Block& option = deck_.blocks()[block];
    if (!can) {
        supported = false;
        report(ReadIssue::Kind::not_supported, option.header, std::string(option.keyword));
        return {};
    }
    const ElementRows all = subtract(rows.plus, rows.minus);
    if (is_option(option.keyword, "GRSHEL")) return {all.shells4, {}, {}};
    if (is_option(option.keyword, "GRBRIC")) return {{}, {}, all.solids};
    return {{}, all.shells3, {}};
}

std::optional<NodeSet> Resolver::nodes_in_box(const Member& member) {
    const std::optional<Box> box = read_box(deck_, index_, member.first, tables_.nodes, issues_);
    if (!box) {
        if (index_.find(Family::box, member.first))
            report(ReadIssue::Kind::not_supported, member.place, "BOX", std::to_string(member.first));
        else
            report(ReadIssue::Kind::member_missing, member.place, std::to_string(member.first));
        return std::nullopt;
    }
    NodeSet inside(tables_.nodes.size());
    constexpr uint32_t piece = 1u << 16;
    const uint32_t count = tables_.nodes.size();
    parallel_for(threads_, (count + piece - 1) / piece, [&](std::size_t p) {
        const auto begin = static_cast<uint32_t>(p) * piece;
        for (uint32_t i = begin; i < std::min(count, begin + piece); ++i)
            if (box->contains(tables_.nodes.x[i])) inside.insert_shared(NodeRow{i});
    });
    return inside;
}

ElementRows Resolver::rows_in_box(const Member& member, bool& supported) {
    const std::optional<NodeSet> inside = nodes_in_box(member);
    if (!inside) {
        supported = supported && !index_.find(Family::box, member.first);
        return {};
    }
    const bool any = member.kind == MemberKind::box_touching;
    const auto pick = [&](const auto& elements, uint32_t count) {
        std::vector<uint32_t> rows;
        for (uint32_t i = 0; i < count; ++i) {
            std::size_t in = 0, all = 0;
            for (const NodeRow node : elements[i])
                if (node != no_node) {
                    ++all;
                    in += inside->contains(node);
                }
            if (any ? in > 0 : all > 0 && in == all) rows.push_back(i);
        }
        return RowSet::of_rows(std::move(rows));
    };
    return {pick(tables_.shells4.nodes, tables_.shells4.size()),
            pick(tables_.shells3.nodes, tables_.shells3.size()),
            pick(tables_.solids.nodes, tables_.solids.size())};
}

} // namespace drawbead
