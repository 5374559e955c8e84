#pragma once
// Order of many unsigned keys, by counting their digits.
#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace drawbead {

/// Places of the keys, by ascending key; equal keys keep their order. Time grows with the number of keys
/// times that of the digits in which keys differ; there is no branch that the keys decide. Fewer than 2^32
/// keys.
template <std::unsigned_integral Key>
std::vector<uint32_t> radix_order(std::span<const Key> key) {
    constexpr int digit_bits = 8;
    constexpr std::size_t digits = std::size_t{1} << digit_bits;
    std::vector<uint32_t> order(key.size());
    std::iota(order.begin(), order.end(), 0u);
    Key differ = 0;
    for (const Key k : key)
        differ |= k ^ key[0];
    std::vector<uint32_t> next(key.size());
    for (int shift = 0; shift < std::numeric_limits<Key>::digits; shift += digit_bits) {
        const auto digit = [shift](Key k) { return static_cast<std::size_t>(k >> shift) & (digits - 1); };
        if (digit(differ) == 0) continue;
        std::array<uint32_t, digits> begin{};
        for (const Key k : key)
            ++begin[digit(k)];
        uint32_t sum = 0;
        for (uint32_t& b : begin)
            sum += std::exchange(b, sum);
        for (const uint32_t i : order)
            next[begin[digit(key[i])]++] = i;
        order.swap(next);
    }
    return order;
}

/// Items by ascending key; items[i] has key[i].
template <std::unsigned_integral Key>
void put_in_order(std::vector<uint32_t>& items, std::span<const Key> key) {
    if (std::is_sorted(key.begin(), key.end())) return;
    std::vector<uint32_t> order = radix_order(key);
    for (uint32_t& place : order)
        place = items[place];
    items.swap(order);
}

} // namespace drawbead
