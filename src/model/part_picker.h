#pragma once
// Parts by id, subset, property, material and submodel.
#include "model/members.h"

#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace drawbead {

class PartPicker {
public:
    /// `parts` must outlive the picker.
    PartPicker(const Deck&, const OptionIndex&, std::span<const Part> parts, IssueLog&);

    std::span<const Part> parts() const { return parts_; }
    /// Index into parts() of an id; the first one of duplicates.
    std::optional<uint32_t> find(PartId) const;
    /// Whether a member names parts in some way.
    static bool names_parts(MemberKind);
    /// Indices into parts(); `known` is false when what the member names does not exist.
    std::vector<uint32_t> pick(const Member&, bool& known) const;
    /// Whether the scope lies in the submodel, itself or through its parents.
    bool in_submodel(ScopeId, int64_t submodel) const;

private:
    const Deck& deck_;
    const OptionIndex& index_;
    std::span<const Part> parts_;
    std::unordered_map<PartId, uint32_t> by_id_;
    std::map<int64_t, std::vector<int64_t>> children_; ///< of subsets
};

} // namespace drawbead
