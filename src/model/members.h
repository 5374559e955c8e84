#pragma once
// What a group, a surface or a set is made of, as written: signed references, not yet expanded.
#include "model/entities.h"
#include "model/issue_log.h"
#include "model/option_index.h"

#include <string_view>
#include <vector>

namespace drawbead {

enum class MemberKind : uint8_t {
    node,
    part,
    subset,
    property,
    material,
    submodel,
    shell, ///< 4-node shell by id
    sh3n,
    solid,
    shell_group,
    sh3n_group,
    brick_group,
    node_group,
    surface,
    line,
    box,          ///< what lies inside
    box_touching, ///< what has a node inside
    set,
    everything,
};

/// One reference, or a range of ids.
struct Member {
    MemberKind kind = MemberKind::node;
    bool minus = false;
    int64_t first = 0, last = 0, step = 1; ///< global ids without sign; a plain reference has last == first
    Span place;
};

/// Which faces of solids belong to a surface.
enum class Faces : uint8_t { none, external, all };

struct Membership {
    std::vector<Member> members;
    bool supported = true; ///< false: a type that the tool cannot expand
    Faces faces = Faces::none;
};

/// Members of a /GRNOD, /GRSHEL, /GRSH3N, /GRTRIA, /GRBRIC, /SURF or /LINE whose data are lists of references
/// or of element ids. Not for lists of nodes or segments, whose order matters.
Membership read_membership(const Deck&, BlockIndex, IssueLog&);

/// Lists of nodes: NODE, CNODE, NODENS.
bool is_node_list(std::string_view keyword);
bool is_ordered_list(std::string_view keyword); ///< NODENS
/// The offset that a submodel adds to ids of a kind.
int64_t offset_of(const Scope&, MemberKind);

} // namespace drawbead
