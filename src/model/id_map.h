#pragma once
#include "base/buffer.h"

#include <cstdint>
#include <span>
#include <vector>

namespace drawbead {

/// Ids to rows of one table: arithmetic when ids are consecutive, else a dense table over their range, else
/// pages of 4096 ids, else (ids scattered far and wide) a hash table. Never a search. Duplicate ids keep the
/// first row and are listed.
class IdMap {
public:
    static constexpr uint32_t none = 0xffffffffu;

    IdMap() = default;
    /// ids[row] = id; ids of 0 are left out. The same for any count of threads.
    IdMap(std::span<const uint32_t> ids, unsigned threads);

    /// Row of an id, or `none`.
    uint32_t row(uint32_t id) const {
        const uint32_t place = id - first_;
        if (form_ == Form::consecutive) return place < count_ ? place : none;
        if (form_ == Form::dense) return place < count_ ? table_[place] : none;
        return form_ == Form::paged ? paged_row(place) : hashed_row(id);
    }
    /// Calls loop(row) with a `row` as above that keeps what it needs in registers, for loops over many ids.
    template <class Loop>
    auto with_rows(Loop&& loop) const {
        const uint32_t first = first_, count = count_;
        const uint32_t* const table = table_.data();
        if (form_ == Form::consecutive)
            return loop([=](uint32_t id) { return id - first < count ? id - first : none; });
        if (form_ == Form::dense)
            return loop([=](uint32_t id) { return id - first < count ? table[id - first] : none; });
        return loop([this](uint32_t id) { return row(id); });
    }
    /// Asks for the memory that row(id) will read, so that many look-ups wait together. Always inline: a call
    /// of a function that only prefetches has no effect to GCC, which drops it.
    [[gnu::always_inline]] void prefetch(uint32_t id) const {
        const uint32_t place = id - first_;
        if (form_ == Form::dense && place < count_)
            __builtin_prefetch(&table_[place]);
        else if (form_ == Form::paged && place < count_ && pages_[place >> page_bits] != none)
            __builtin_prefetch(
                &table_[std::size_t{pages_[place >> page_bits]} * page_size + place % page_size]);
    }
    /// Whether row(id) == id - first for every id in the table.
    bool consecutive() const { return form_ == Form::consecutive; }
    /// Rows whose id another, earlier row has too, ascending.
    std::span<const uint32_t> duplicates() const { return duplicates_; }
    std::size_t bytes() const {
        return (table_.capacity() + pages_.capacity()) * sizeof(uint32_t) +
               hashed_.capacity() * sizeof(Entry);
    }

private:
    enum class Form : uint8_t { consecutive, dense, paged, hashed };
    struct Entry {
        uint32_t id, row;
    };
    static constexpr uint32_t page_bits = 12, page_size = 1u << page_bits;

    uint32_t paged_row(uint32_t place) const {
        if (place >= count_) return none;
        const uint32_t page = pages_[place >> page_bits];
        return page == none ? none : table_[std::size_t{page} * page_size + place % page_size];
    }
    uint32_t hashed_row(uint32_t id) const;
    bool make_pages(std::span<const uint32_t> ids, std::size_t given);
    void make_hash(std::span<const uint32_t> ids, std::size_t given);
    template <class Slot>
    void fill(std::span<const uint32_t> ids, std::size_t given, unsigned threads, const Slot& slot);

    Form form_ = Form::consecutive;
    uint32_t first_ = 1;     ///< the smallest id
    uint32_t count_ = 0;     ///< ids from the smallest to the largest
    uint32_t shift_ = 0;     ///< of the hash
    Buffer<uint32_t> table_; ///< dense or paged: rows
    Buffer<uint32_t> pages_; ///< paged: number of the page in `table_`, or none
    Buffer<Entry> hashed_;   ///< a power of two, at most half full; id 0: empty
    std::vector<uint32_t> duplicates_;
};

} // namespace drawbead
