#include "model/members.h"

#include "model/cards/lists.h"
#include "model/option_reader.h"

#include <algorithm>
#include <optional>

namespace drawbead {

namespace {

struct TypeName {
    std::string_view name;
    MemberKind kind;
};

/// Types that every family of groups and surfaces has.
constexpr TypeName common_types[] = {
    {"PART", MemberKind::part},         {"SUBSET", MemberKind::subset},     {"MAT", MemberKind::material},
    {"PROP", MemberKind::property},     {"BOX", MemberKind::box},           {"BOXA", MemberKind::box},
    {"BOX2", MemberKind::box_touching}, {"SUBMODEL", MemberKind::submodel},
};
constexpr TypeName group_types[] = {
    {"GRSHEL", MemberKind::shell_group}, {"GRSH3N", MemberKind::sh3n_group},
    {"GRTRIA", MemberKind::sh3n_group},  {"GRBRIC", MemberKind::brick_group},
    {"SURF", MemberKind::surface},       {"DSURF", MemberKind::surface},
    {"LINE", MemberKind::line},          {"GRNODNS", MemberKind::node_group},
    {"GRNOD", MemberKind::node_group},
};

template <std::size_t N>
std::optional<MemberKind> find(const TypeName (&types)[N], std::string_view name) {
    for (const TypeName& type : types)
        if (type.name == name) return type.kind;
    return std::nullopt;
}

/// The kind of element that a group of elements lists by id.
std::optional<MemberKind> listed_kind(std::string_view family) {
    if (family == "GRNOD") return MemberKind::node;
    if (family == "GRSHEL") return MemberKind::shell;
    if (family == "GRSH3N" || family == "GRTRIA") return MemberKind::sh3n;
    if (family == "GRBRIC") return MemberKind::solid;
    return std::nullopt;
}

Member reference(MemberKind kind, const WrittenId& written, int64_t offset) {
    const int64_t id = Deck::global_id(written.id, offset);
    Member member;
    member.kind = kind;
    member.minus = id < 0;
    member.first = member.last = id < 0 ? -id : id;
    member.place = written.place;
    return member;
}

void read_references(const Deck& deck, const Block& block, MemberKind kind, IssueLog& issues,
                     std::vector<Member>& members) {
    const int64_t offset = offset_of(deck.scope(block.scope), kind);
    const Span text = list_text(deck, block);
    members.reserve(text.size() / 10 + 1); // what full lines of plain cells hold
    for_each_id(deck, block.scope, text, issues, [&](const WrittenId* ids, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            if (ids[i].id != 0) members.push_back(reference(kind, ids[i], offset));
    });
}

/// GENE: pairs first, last; GEN_INCR: one triple first, last, increment per line.
void read_ranges(const Deck& deck, const Block& block, MemberKind kind, bool increments, IssueLog& issues,
                 std::vector<Member>& members) {
    const int64_t offset = offset_of(deck.scope(block.scope), kind);
    const std::size_t stride = increments ? 3 : 2;
    std::vector<WrittenId> pending;
    for_each_id(
        deck, block.scope, list_text(deck, block), issues, [&](const WrittenId* ids, std::size_t count) {
            if (increments) pending.clear();
            pending.insert(pending.end(), ids, ids + count);
            while (pending.size() >= 2) {
                Member member = reference(kind, pending[0], offset);
                member.last = Deck::global_id(pending[1].id, offset);
                member.step = increments && pending.size() > 2 && pending[2].id > 0 ? pending[2].id : 1;
                members.push_back(member);
                pending.erase(pending.begin(), pending.begin() + static_cast<std::ptrdiff_t>(
                                                                     std::min(stride, pending.size())));
            }
        });
}

} // namespace

bool is_node_list(std::string_view keyword) {
    const std::string_view type = subtype(keyword);
    return is_option(keyword, "GRNOD") && (type.substr(0, 4) == "NODE" || type.substr(0, 5) == "CNODE");
}

bool is_ordered_list(std::string_view keyword) {
    return is_option(keyword, "GRNOD") && subtype(keyword).substr(0, 6) == "NODENS";
}

int64_t offset_of(const Scope& scope, MemberKind kind) {
    switch (kind) {
    case MemberKind::node:
        return scope.offsets.node;
    case MemberKind::shell:
    case MemberKind::sh3n:
    case MemberKind::solid:
        return scope.offsets.element;
    case MemberKind::part:
        return scope.offsets.part;
    case MemberKind::property:
        return scope.offsets.property;
    case MemberKind::material:
        return scope.offsets.material;
    case MemberKind::submodel:
        return scope.offsets.submodel;
    default:
        return scope.offsets.general;
    }
}

Membership read_membership(const Deck& deck, BlockIndex index, IssueLog& issues) {
    const Block& block = deck.blocks()[index];
    const std::string_view family = block.keyword.substr(0, block.keyword.find('/'));
    std::string_view type = subtype(block.keyword);
    Membership membership;
    const std::size_t slash = type.find('/');
    if (slash != std::string_view::npos) {
        const std::string_view faces = type.substr(slash + 1);
        type = type.substr(0, slash);
        if (faces == "EXT" || faces == "FREE")
            membership.faces = Faces::external;
        else if (faces == "ALL")
            membership.faces = Faces::all;
        else
            membership.supported = false; // among them the old forms /GRNOD/BOX/RECTA and the like
    }
    const std::optional<MemberKind> listed = listed_kind(family);
    if (type == "GENE" || type == "GEN_INCR") {
        membership.supported = membership.supported && listed;
        if (membership.supported)
            read_ranges(deck, block, *listed, type == "GEN_INCR", issues, membership.members);
        return membership;
    }
    std::optional<MemberKind> kind = find(common_types, type);
    if (!kind) kind = find(group_types, type);
    if (!kind && listed && (type == "SHEL" || type == "SH3N" || type == "TRIA" || type == "BRIC"))
        kind = listed;
    if (!kind || !membership.supported) {
        membership.supported = false;
        return membership;
    }
    read_references(deck, block, *kind, issues, membership.members);
    return membership;
}

} // namespace drawbead
