#include "base/radix_order.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace {

using namespace drawbead;

/// The definition: a stable sort of places by key.
template <class Key>
std::vector<uint32_t> by_stable_sort(const std::vector<Key>& key) {
    std::vector<uint32_t> order(key.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return key[a] < key[b]; });
    return order;
}

template <class Key>
void compare(const std::vector<Key>& key) {
    CHECK(radix_order(std::span<const Key>(key)) == by_stable_sort(key));
}

} // namespace

TEST_CASE("Keys of any digits come in the order of a stable sort") {
    std::mt19937_64 random(20261126);
    for (const uint64_t mask : {~uint64_t{0}, uint64_t{0xff}, uint64_t{0xff00}, uint64_t{0xc0000000000001ff},
                                uint64_t{0x8000000000000000}, uint64_t{0x7}})
        for (const std::size_t count : {1, 2, 3, 100, 1000}) {
            std::vector<uint64_t> wide(count);
            std::vector<uint32_t> narrow(count);
            for (std::size_t i = 0; i < count; ++i) {
                wide[i] = random() & mask;
                narrow[i] = static_cast<uint32_t>(wide[i]);
            }
            compare(wide);
            compare(narrow);
            std::sort(narrow.begin(), narrow.end());
            compare(narrow);
        }
    compare(std::vector<uint32_t>{});
    compare(std::vector<uint32_t>{7, 7, 7});
    compare(std::vector<uint64_t>{0, ~uint64_t{0}, 0, ~uint64_t{0}});
}

TEST_CASE("Items are put in the order of their keys, equal ones as they stood") {
    std::vector<uint32_t> items{10, 11, 12, 13, 14};
    const std::vector<uint32_t> key{3, 1, 3, 0x100, 1};
    put_in_order(items, std::span<const uint32_t>(key));
    CHECK(items == std::vector<uint32_t>{11, 14, 10, 12, 13});
}
