#pragma once
// Which elements the groups and surfaces in use can contain, before any table is read.
#include "model/part_picker.h"

#include <set>
#include <vector>

namespace drawbead {

class Demand {
public:
    Demand(const Deck& deck, const OptionIndex& index, const PartPicker& parts)
        : deck_(deck), index_(index), picker_(parts), parts_(parts.parts().size()) {}

    /// A node group or set whose nodes are wanted.
    void add_group(BlockIndex);
    /// A surface or set whose segments are wanted; `stiffness` means the elements behind SEG lines too.
    void add_surface(BlockIndex, bool stiffness);

    /// One reference whose nodes are wanted.
    void add_member(const Member& member) { add_referenced(member, true); }

    bool all() const { return all_; }
    bool solids() const { return solids_; }
    bool ids() const { return ids_; }
    bool any() const { return all_ || any_; }
    /// Global ids.
    std::vector<PartId> parts() const;

private:
    void add_members(const Membership&, bool solids);
    void add_referenced(const Member&, bool solids);
    void add_set(BlockIndex);

    const Deck& deck_;
    const OptionIndex& index_;
    const PartPicker& picker_;
    std::vector<bool> parts_;
    std::set<std::pair<BlockIndex, bool>> seen_;
    bool all_ = false, solids_ = false, ids_ = false, any_ = false;
    IssueLog unreported_; ///< the same lists are read again, with reports, when they are expanded
};

} // namespace drawbead
