#pragma once
// A set of nodes as one bit per row.
#include "model/ids.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace drawbead {

class NodeSet {
public:
    NodeSet() = default;
    explicit NodeSet(std::size_t nodes) : words_((nodes + 63) / 64) {}

    std::size_t capacity() const { return 64 * words_.size(); } ///< number of nodes, rounded up

    bool contains(NodeRow row) const { return words_[index(row) / 64] >> (index(row) % 64) & 1; }
    bool contains(const NodeSet& other) const {
        for (std::size_t i = 0; i < words_.size(); ++i)
            if (other.words_[i] & ~words_[i]) return false;
        return true;
    }
    void insert(NodeRow row) { words_[index(row) / 64] |= bit(row); }
    /// As insert; several threads may call it at a time.
    void insert_shared(NodeRow row) {
        std::atomic_ref<uint64_t> word(words_[index(row) / 64]);
        if (!(word.load(std::memory_order_relaxed) & bit(row)))
            word.fetch_or(bit(row), std::memory_order_relaxed);
    }
    void unite(const NodeSet& other) {
        for (std::size_t i = 0; i < words_.size(); ++i)
            words_[i] |= other.words_[i];
    }
    void subtract(const NodeSet& other) {
        for (std::size_t i = 0; i < words_.size(); ++i)
            words_[i] &= ~other.words_[i];
    }
    void intersect(const NodeSet& other) {
        for (std::size_t i = 0; i < words_.size(); ++i)
            words_[i] &= other.words_[i];
    }
    /// Ascending rows.
    std::vector<NodeRow> rows() const {
        std::vector<NodeRow> rows;
        for (std::size_t i = 0; i < words_.size(); ++i)
            for (uint64_t word = words_[i]; word; word &= word - 1)
                rows.push_back(
                    NodeRow{static_cast<uint32_t>(64 * i) + static_cast<uint32_t>(__builtin_ctzll(word))});
        return rows;
    }

private:
    static uint64_t bit(NodeRow row) { return uint64_t{1} << (index(row) % 64); }
    std::vector<uint64_t> words_;
};

} // namespace drawbead
