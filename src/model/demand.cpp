#include "model/demand.h"

#include "model/sets.h"

namespace drawbead {

std::vector<PartId> Demand::parts() const {
    std::vector<PartId> ids;
    for (std::size_t i = 0; i < parts_.size(); ++i)
        if (parts_[i]) ids.push_back(picker_.parts()[i].id);
    return ids;
}

void Demand::add_group(BlockIndex block) {
    if (!seen_.emplace(block, true).second) return;
    const std::string_view keyword = deck_.blocks()[block].keyword;
    if (is_option(keyword, "SET")) {
        add_set(block);
        return;
    }
    if (is_node_list(keyword) || keyword == "LINE/SEG") return;
    const Membership membership = read_membership(deck_, block, unreported_);
    if (!membership.supported) return;
    for (const Member& member : membership.members)
        if (member.kind != MemberKind::box) add_referenced(member, true); // a box of nodes needs no elements
}

void Demand::add_surface(BlockIndex block, bool stiffness) {
    if (!seen_.emplace(block, stiffness).second) return;
    const std::string_view keyword = deck_.blocks()[block].keyword;
    if (is_option(keyword, "SET")) {
        add_set(block);
        return;
    }
    if (keyword == "SURF/SEG") {
        if (stiffness) all_ = solids_ = true;
        return;
    }
    const Membership membership = read_membership(deck_, block, unreported_);
    if (!membership.supported) return;
    for (const Member& member : membership.members)
        if (member.kind == MemberKind::surface) {
            if (const auto other = index_.find(Family::surface, member.first)) add_surface(*other, stiffness);
        } else {
            add_referenced(member, membership.faces != Faces::none);
        }
}

void Demand::add_members(const Membership& membership, bool solids) {
    if (!membership.supported) return;
    for (const Member& member : membership.members)
        add_referenced(member, solids);
}

void Demand::add_referenced(const Member& member, bool solids) {
    bool known = false;
    switch (member.kind) {
    case MemberKind::part:
    case MemberKind::subset:
    case MemberKind::property:
    case MemberKind::material:
    case MemberKind::submodel:
        for (const uint32_t part : picker_.pick(member, known)) {
            parts_[part] = true;
            any_ = true;
            solids_ |= solids;
        }
        return;
    case MemberKind::everything:
    case MemberKind::box:
    case MemberKind::box_touching:
        all_ = true;
        solids_ |= solids;
        return;
    case MemberKind::shell:
    case MemberKind::sh3n:
        all_ = ids_ = true;
        return;
    case MemberKind::solid:
        all_ = ids_ = solids_ = true;
        return;
    case MemberKind::shell_group:
    case MemberKind::sh3n_group:
    case MemberKind::brick_group: {
        const Family family = member.kind == MemberKind::shell_group  ? Family::shell_group
                              : member.kind == MemberKind::sh3n_group ? Family::sh3n_group
                                                                      : Family::brick_group;
        const auto group = index_.find(family, member.first);
        if (!group || !seen_.emplace(*group, true).second) return;
        // A list of elements can be long, and what it holds makes no difference here.
        const std::string_view type = subtype(deck_.blocks()[*group].keyword);
        if (type == "SHEL" || type == "SH3N" || type == "TRIA" || type == "BRIC") {
            all_ = ids_ = true;
            solids_ |= family == Family::brick_group;
            return;
        }
        add_members(read_membership(deck_, *group, unreported_), family == Family::brick_group);
        return;
    }
    case MemberKind::node_group:
        if (const auto group = index_.find(Family::node_group, member.first)) add_group(*group);
        return;
    case MemberKind::surface:
        if (const auto surface = index_.find(Family::surface, member.first)) add_surface(*surface, false);
        return;
    case MemberKind::line:
        if (const auto line = index_.find(Family::line, member.first)) add_group(*line);
        return;
    case MemberKind::set:
        if (const auto set = index_.find(Family::set, member.first); set && seen_.emplace(*set, true).second)
            add_set(*set);
        return;
    case MemberKind::node:
        return;
    }
}

void Demand::add_set(BlockIndex block) {
    for (const SetClause& clause : read_set(deck_, index_, block, unreported_)) {
        if (clause.key == "SEG" && !clause.segments.empty()) all_ = solids_ = true;
        for (const Member& member : clause.members)
            add_referenced(member, true);
    }
}

} // namespace drawbead
