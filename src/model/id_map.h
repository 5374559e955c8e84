#pragma once
#include "base/buffer.h"

#include <cstdint>
#include <span>
#include <vector>

namespace drawbead {

/// Ids to rows of one table: arithmetic when ids are consecutive, else a dense table, else pages of 4096 ids.
/// Never a search. Duplicate ids keep the first row and are listed.
class IdMap {
public:
    static constexpr uint32_t none = 0xffffffffu;

    IdMap() = default;
    /// ids[row] = id; ids of 0 are left out. Deterministic for any count of threads.
    IdMap(std::span<const uint32_t> ids, unsigned threads);

    /// Row of an id, or `none`.
    uint32_t row(uint32_t id) const {
        if (consecutive_) return id - first_ < count_ ? id - first_ : none;
        if (!dense_.empty()) return id < dense_.size() ? dense_[id] : none;
        return paged_row(id);
    }
    /// Rows whose id another, earlier row has too, ascending.
    std::span<const uint32_t> duplicates() const { return duplicates_; }

private:
    uint32_t paged_row(uint32_t id) const;

    bool consecutive_ = true;
    uint32_t first_ = 0, count_ = 0;
    Buffer<uint32_t> dense_;
    std::vector<std::vector<uint32_t>> pages_;
    std::vector<uint32_t> duplicates_;
};

} // namespace drawbead
