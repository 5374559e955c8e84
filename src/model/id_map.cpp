#include "model/id_map.h"

#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>

namespace drawbead {

namespace {

constexpr std::size_t piece_size = std::size_t{1} << 17;

std::size_t pieces_of(std::size_t count) {
    return (count + piece_size - 1) / piece_size;
}

/// What one look at all ids tells.
struct Range {
    uint32_t first = 0xffffffffu, last = 0; ///< without zeros
    std::size_t given = 0;                  ///< ids that are not 0
    bool consecutive = true;
};

Range range_of(std::span<const uint32_t> ids, unsigned threads) {
    std::vector<Range> found(pieces_of(ids.size()));
    parallel_for(threads, found.size(), [&](std::size_t piece) {
        const std::size_t begin = piece * piece_size, end = std::min(begin + piece_size, ids.size());
        // `id - 1` makes 0 the largest value, so that the minimum passes over it.
        uint32_t first = 0xffffffffu, last = 0, zeros = 0, jumps = 0;
        for (std::size_t row = begin; row < end; ++row) {
            const uint32_t id = ids[row];
            first = std::min(first, id - 1);
            last = std::max(last, id);
            zeros += id == 0;
            jumps |= (id - ids[0]) ^ static_cast<uint32_t>(row);
        }
        found[piece] = {first + 1, last, end - begin - zeros, jumps == 0};
    });
    Range all;
    for (const Range& r : found) {
        if (r.given) all.first = std::min(all.first, r.first);
        all.last = std::max(all.last, r.last);
        all.given += r.given;
        all.consecutive = all.consecutive && r.consecutive;
    }
    all.consecutive = all.consecutive && all.given == ids.size() && all.last >= all.first;
    return all;
}

void clear(Buffer<uint32_t>& table, unsigned threads) {
    parallel_for(threads, pieces_of(table.size()), [&](std::size_t piece) {
        const std::size_t begin = piece * piece_size;
        std::memset(table.data() + begin, 0xff,
                    std::min(piece_size, table.size() - begin) * sizeof(uint32_t));
    });
}

} // namespace

IdMap::IdMap(std::span<const uint32_t> ids, unsigned threads) {
    const Range range = range_of(ids, threads);
    if (range.given == 0) return;
    first_ = range.first;
    count_ = range.last - range.first + 1;
    if (range.consecutive) return;
    const std::size_t width = std::size_t{range.last} - range.first + 1;
    if (width <= 4 * range.given + page_size) {
        form_ = Form::dense;
        table_ = Buffer<uint32_t>(width);
        fill(ids, range.given, threads, [first = first_](uint32_t id) { return std::size_t{id - first}; });
    } else if (make_pages(ids, range.given)) {
        form_ = Form::paged;
        fill(ids, range.given, threads, [this](uint32_t id) {
            const uint32_t place = id - first_;
            return std::size_t{pages_[place >> page_bits]} * page_size + place % page_size;
        });
    } else {
        form_ = Form::hashed;
        make_hash(ids, range.given);
    }
}

template <class Slot>
void IdMap::fill(std::span<const uint32_t> ids, std::size_t given, unsigned threads, const Slot& slot) {
    if (threads > 1 && pieces_of(ids.size()) > 1) {
        clear(table_, threads);
        parallel_for(threads, pieces_of(ids.size()), [&](std::size_t piece) {
            const std::size_t begin = piece * piece_size, end = std::min(begin + piece_size, ids.size());
            for (std::size_t row = begin; row < end; ++row)
                if (ids[row] != 0)
                    std::atomic_ref(table_[slot(ids[row])])
                        .store(static_cast<uint32_t>(row), std::memory_order_relaxed);
        });
        // Every id has a slot of its own exactly when as many slots are taken as there are ids. If not, the
        // threads may have met in a slot: then the order of rows decides below.
        std::vector<std::size_t> taken(pieces_of(table_.size()));
        parallel_for(threads, taken.size(), [&](std::size_t piece) {
            const std::size_t begin = piece * piece_size, end = std::min(begin + piece_size, table_.size());
            uint32_t count = 0;
            for (std::size_t i = begin; i < end; ++i)
                count += table_[i] != none;
            taken[piece] = count;
        });
        std::size_t total = 0;
        for (std::size_t count : taken)
            total += count;
        if (total == given) return;
    }
    clear(table_, threads);
    for (std::size_t row = 0; row < ids.size(); ++row) {
        if (ids[row] == 0) continue;
        uint32_t& place = table_[slot(ids[row])];
        if (place == none)
            place = static_cast<uint32_t>(row);
        else
            duplicates_.push_back(static_cast<uint32_t>(row));
    }
}

bool IdMap::make_pages(std::span<const uint32_t> ids, std::size_t given) {
    Buffer<uint32_t> pages((std::size_t{count_ - 1} >> page_bits) + 1);
    std::memset(pages.data(), 0xff, pages.size() * sizeof(uint32_t));
    const std::size_t most = 16 + 4 * given / page_size;
    uint32_t used = 0;
    for (uint32_t id : ids) {
        if (id == 0) continue;
        uint32_t& page = pages[(id - first_) >> page_bits];
        if (page != none) continue;
        if (used == most) return false;
        page = used++;
    }
    pages_ = std::move(pages);
    table_ = Buffer<uint32_t>(std::size_t{used} * page_size);
    return true;
}

namespace {
constexpr uint32_t spread = 0x9e3779b1u; // 2^32 divided by the golden ratio
}

void IdMap::make_hash(std::span<const uint32_t> ids, std::size_t given) {
    const std::size_t size = std::bit_ceil(2 * given);
    shift_ = 32 - static_cast<uint32_t>(std::countr_zero(size));
    hashed_ = Buffer<Entry>(size);
    std::memset(static_cast<void*>(hashed_.data()), 0, size * sizeof(Entry));
    for (std::size_t row = 0; row < ids.size(); ++row) {
        const uint32_t id = ids[row];
        if (id == 0) continue;
        std::size_t at = (id * spread) >> shift_;
        while (hashed_[at].id != 0 && hashed_[at].id != id)
            at = (at + 1) & (size - 1);
        if (hashed_[at].id == id)
            duplicates_.push_back(static_cast<uint32_t>(row));
        else
            hashed_[at] = {id, static_cast<uint32_t>(row)};
    }
}

uint32_t IdMap::hashed_row(uint32_t id) const {
    if (id == 0) return none;
    std::size_t at = (id * spread) >> shift_;
    while (hashed_[at].id != 0) {
        if (hashed_[at].id == id) return hashed_[at].row;
        at = (at + 1) & (hashed_.size() - 1);
    }
    return none;
}

} // namespace drawbead
