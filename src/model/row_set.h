#pragma once
// Sets of table rows as runs, so that a part of a million elements costs one entry.
#include <cstdint>
#include <span>
#include <vector>

namespace drawbead {

struct RowRun {
    uint32_t begin = 0, end = 0; ///< half-open
    friend bool operator==(const RowRun&, const RowRun&) = default;
};

/// Ascending, disjoint, not touching runs.
class RowSet {
public:
    RowSet() = default;
    /// From rows or runs in any order, overlapping or not.
    static RowSet of_rows(std::vector<uint32_t> rows);
    static RowSet of_runs(std::vector<RowRun> runs);

    std::span<const RowRun> runs() const { return runs_; }
    bool empty() const { return runs_.empty(); }
    uint64_t count() const;
    bool contains(uint32_t row) const;

    friend RowSet unite(const RowSet&, const RowSet&);
    friend RowSet subtract(const RowSet&, const RowSet&);
    friend RowSet intersect(const RowSet&, const RowSet&);

private:
    std::vector<RowRun> runs_;
};

} // namespace drawbead
