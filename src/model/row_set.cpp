#include "model/row_set.h"

#include <algorithm>

namespace drawbead {

RowSet RowSet::of_runs(std::vector<RowRun> runs) {
    const auto before = [](const RowRun& a, const RowRun& b) { return a.begin < b.begin; };
    if (!std::is_sorted(runs.begin(), runs.end(), before)) std::sort(runs.begin(), runs.end(), before);
    RowSet set;
    for (const RowRun& run : runs) {
        if (run.begin >= run.end) continue;
        if (!set.runs_.empty() && run.begin <= set.runs_.back().end)
            set.runs_.back().end = std::max(set.runs_.back().end, run.end);
        else
            set.runs_.push_back(run);
    }
    return set;
}

RowSet RowSet::of_rows(std::vector<uint32_t> rows) {
    std::sort(rows.begin(), rows.end());
    std::vector<RowRun> runs;
    for (const uint32_t row : rows) {
        if (!runs.empty() && row <= runs.back().end)
            runs.back().end = std::max(runs.back().end, row + 1);
        else
            runs.push_back({row, row + 1});
    }
    RowSet set;
    set.runs_ = std::move(runs);
    return set;
}

uint64_t RowSet::count() const {
    uint64_t sum = 0;
    for (const RowRun& run : runs_)
        sum += run.end - run.begin;
    return sum;
}

bool RowSet::contains(uint32_t row) const {
    const auto after = std::upper_bound(runs_.begin(), runs_.end(), row,
                                        [](uint32_t r, const RowRun& run) { return r < run.begin; });
    return after != runs_.begin() && row < std::prev(after)->end;
}

RowSet unite(const RowSet& a, const RowSet& b) {
    std::vector<RowRun> runs(a.runs_);
    runs.insert(runs.end(), b.runs_.begin(), b.runs_.end());
    return RowSet::of_runs(std::move(runs));
}

RowSet subtract(const RowSet& a, const RowSet& b) {
    RowSet set;
    std::size_t j = 0;
    for (RowRun run : a.runs_) {
        while (j < b.runs_.size() && b.runs_[j].end <= run.begin)
            ++j;
        for (std::size_t k = j; k < b.runs_.size() && b.runs_[k].begin < run.end; ++k) {
            if (b.runs_[k].begin > run.begin) set.runs_.push_back({run.begin, b.runs_[k].begin});
            run.begin = std::min(run.end, b.runs_[k].end);
        }
        if (run.begin < run.end) set.runs_.push_back(run);
    }
    return set;
}

RowSet intersect(const RowSet& a, const RowSet& b) {
    RowSet set;
    std::size_t i = 0, j = 0;
    while (i < a.runs_.size() && j < b.runs_.size()) {
        const RowRun run{std::max(a.runs_[i].begin, b.runs_[j].begin),
                         std::min(a.runs_[i].end, b.runs_[j].end)};
        if (run.begin < run.end) set.runs_.push_back(run);
        if (a.runs_[i].end < b.runs_[j].end)
            ++i;
        else
            ++j;
    }
    return set;
}

} // namespace drawbead
