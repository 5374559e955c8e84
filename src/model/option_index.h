#pragma once
// Which block defines which option: the deck's blocks by family and global id.
#include "model/entities.h"
#include "model/issue_log.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace drawbead {

/// Options whose ids live in one name space each.
enum class Family : uint8_t {
    interface,
    node_group,
    surface,
    line,
    part_group,
    shell_group,
    sh3n_group,
    brick_group,
    part,
    property,
    material,
    ply,
    subset,
    box,
    set,
    submodel,
    rigid_body,
    count_,
};

/// "surface", "node group" … for messages.
std::string_view family_name(Family);

struct Option {
    int64_t id = 0; ///< global
    BlockIndex block = 0;
};

class OptionIndex {
public:
    /// Reports ids that one family defines twice (/SET/COLLECT blocks of one id belong together).
    OptionIndex(const Deck&, IssueLog&);

    /// The first block that defines the id.
    std::optional<BlockIndex> find(Family, int64_t id) const;
    /// In deck order.
    std::span<const Option> all(Family family) const { return options_[static_cast<std::size_t>(family)]; }

private:
    static constexpr auto families = static_cast<std::size_t>(Family::count_);
    std::array<std::vector<Option>, families> options_;
    std::array<std::unordered_map<int64_t, BlockIndex>, families> by_id_;
};

/// The part of a keyword after its first slash: "NODENS" of "GRNOD/NODENS"; empty without one.
std::string_view subtype(std::string_view keyword);
/// Whether the keyword's first field is `name`.
bool is_option(std::string_view keyword, std::string_view name);

/// Offset that a submodel adds to the ids of a family.
int64_t offset_of(const Scope&, Family);

} // namespace drawbead
