#include "model/option_index.h"

#include <string>

namespace drawbead {

namespace {

std::optional<Family> family_of(std::string_view keyword) {
    struct Name {
        std::string_view keyword;
        Family family;
    };
    static constexpr Name names[] = {
        {"INTER", Family::interface},   {"GRNOD", Family::node_group},   {"SURF", Family::surface},
        {"LINE", Family::line},         {"GRPART", Family::part_group},  {"GRSHEL", Family::shell_group},
        {"GRSH3N", Family::sh3n_group}, {"GRTRIA", Family::sh3n_group},  {"GRBRIC", Family::brick_group},
        {"PART", Family::part},         {"PROP", Family::property},      {"MAT", Family::material},
        {"PLY", Family::ply},           {"SUBSET", Family::subset},      {"BOX", Family::box},
        {"SET", Family::set},           {"/SUBMODEL", Family::submodel}, {"RBODY", Family::rigid_body},
    };
    for (const Name& n : names)
        if (is_option(keyword, n.keyword)) {
            if (n.family == Family::interface && is_option(subtype(keyword), "SUB")) return std::nullopt;
            return n.family;
        }
    return std::nullopt;
}

} // namespace

std::string_view subtype(std::string_view keyword) {
    const std::size_t slash = keyword.find('/', 1);
    return slash == std::string_view::npos ? std::string_view{} : keyword.substr(slash + 1);
}

bool is_option(std::string_view keyword, std::string_view name) {
    return keyword.substr(0, name.size()) == name &&
           (keyword.size() == name.size() || keyword[name.size()] == '/');
}

std::string_view family_name(Family family) {
    static constexpr std::string_view names[] = {
        "interface",  "node group",  "surface", "line",     "part group", "shell group",
        "sh3n group", "brick group", "part",    "property", "material",   "ply",
        "subset",     "box",         "set",     "submodel", "rigid body"};
    static_assert(std::size(names) == static_cast<std::size_t>(Family::count_));
    return names[static_cast<std::size_t>(family)];
}

int64_t offset_of(const Scope& scope, Family family) {
    switch (family) {
    case Family::part:
        return scope.offsets.part;
    case Family::property:
    case Family::ply:
        return scope.offsets.property;
    case Family::material:
        return scope.offsets.material;
    case Family::submodel:
        return scope.offsets.submodel;
    default:
        return scope.offsets.general;
    }
}

OptionIndex::OptionIndex(const Deck& deck, IssueLog& issues) {
    const auto blocks = deck.blocks();
    for (BlockIndex i = 0; i < blocks.size(); ++i) {
        const Block& block = blocks[i];
        const std::optional<Family> family = family_of(block.keyword);
        if (!family) continue;
        // Parts of one collection may stand in several submodels: its id is the same in all of them.
        const bool collected = is_option(block.keyword, "SET/COLLECT");
        const int64_t offset = collected ? 0 : offset_of(deck.scope(block.scope), *family);
        const int64_t id = Deck::global_id(block.id, offset);
        const auto f = static_cast<std::size_t>(*family);
        options_[f].push_back({id, i});
        const auto [known, added] = by_id_[f].emplace(id, i);
        if (!added && !collected)
            issues.add(ReadIssue::Kind::duplicate_id, block.header,
                       std::string(family_name(*family)) + ' ' + std::to_string(id), {},
                       blocks[known->second].header);
        // Plies may also be written as properties.
        if (*family == Family::property &&
            (subtype(block.keyword) == "PLY" || subtype(block.keyword) == "TYPE19")) {
            const auto ply = static_cast<std::size_t>(Family::ply);
            options_[ply].push_back({id, i});
            by_id_[ply].emplace(id, i);
        }
    }
}

std::optional<BlockIndex> OptionIndex::find(Family family, int64_t id) const {
    const auto& map = by_id_[static_cast<std::size_t>(family)];
    const auto found = map.find(id);
    if (found == map.end()) return std::nullopt;
    return found->second;
}

} // namespace drawbead
