#include "model/part_picker.h"

#include "model/option_reader.h"

#include <set>

namespace drawbead {

PartPicker::PartPicker(const Deck& deck, const OptionIndex& index, std::span<const Part> parts,
                       IssueLog& issues)
    : deck_(deck), index_(index), parts_(parts) {
    for (uint32_t i = 0; i < parts.size(); ++i)
        by_id_.emplace(parts[i].id, i);
    for (const Option& subset : index.all(Family::subset)) {
        const Block& block = deck.blocks()[subset.block];
        const int64_t offset = deck.scope(block.scope).offsets.general;
        auto& children = children_[subset.id];
        for (const WrittenId& child : read_ids(deck, block, issues))
            if (child.id > 0) children.push_back(Deck::global_id(child.id, offset));
    }
}

std::optional<uint32_t> PartPicker::find(PartId id) const {
    const auto found = by_id_.find(id);
    if (found == by_id_.end()) return std::nullopt;
    return found->second;
}

bool PartPicker::names_parts(MemberKind kind) {
    switch (kind) {
    case MemberKind::part:
    case MemberKind::subset:
    case MemberKind::property:
    case MemberKind::material:
    case MemberKind::submodel:
    case MemberKind::everything:
        return true;
    default:
        return false;
    }
}

bool PartPicker::in_submodel(ScopeId scope, int64_t submodel) const {
    for (;;) {
        const Scope& here = deck_.scope(scope);
        if (here.submodel == submodel) return true;
        if (here.parent == scope) return false;
        scope = here.parent;
    }
}

std::vector<uint32_t> PartPicker::pick(const Member& member, bool& known) const {
    std::vector<uint32_t> picked;
    known = true;
    const auto all_that = [&](auto&& wanted) {
        for (uint32_t i = 0; i < parts_.size(); ++i)
            if (wanted(parts_[i])) picked.push_back(i);
    };
    const auto in_range = [&](int64_t id) {
        return id >= member.first && id <= member.last && (id - member.first) % member.step == 0;
    };
    switch (member.kind) {
    case MemberKind::part:
        if (member.first == member.last) {
            if (const auto part = find(member.first)) picked.push_back(*part);
        } else {
            all_that([&](const Part& part) { return in_range(part.id); });
        }
        known = !picked.empty();
        break;
    case MemberKind::subset: {
        std::set<int64_t> subsets;
        std::vector<int64_t> open{member.first};
        while (!open.empty()) {
            const int64_t id = open.back();
            open.pop_back();
            if (!subsets.insert(id).second) continue;
            if (const auto children = children_.find(id); children != children_.end())
                open.insert(open.end(), children->second.begin(), children->second.end());
        }
        all_that([&](const Part& part) { return subsets.count(part.subset) != 0; });
        known = !picked.empty() || children_.count(member.first) != 0;
        break;
    }
    case MemberKind::property:
        all_that([&](const Part& part) { return in_range(part.property); });
        known = !picked.empty() || index_.find(Family::property, member.first);
        break;
    case MemberKind::material:
        all_that([&](const Part& part) { return in_range(part.material); });
        known = !picked.empty() || index_.find(Family::material, member.first);
        break;
    case MemberKind::submodel:
        all_that(
            [&](const Part& part) { return in_submodel(deck_.blocks()[part.block].scope, member.first); });
        for (std::size_t i = 0; known && picked.empty() && i <= deck_.scope_count(); ++i) {
            known = i < deck_.scope_count();
            if (known && deck_.scope(ScopeId{static_cast<uint32_t>(i)}).submodel == member.first) break;
        }
        break;
    case MemberKind::everything:
        all_that([](const Part&) { return true; });
        break;
    default:
        break;
    }
    return picked;
}

} // namespace drawbead
