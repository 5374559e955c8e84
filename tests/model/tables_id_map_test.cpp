#include "model/id_map.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>
#include <unordered_map>

using drawbead::IdMap;

namespace {

/// Compares a map with a plain hash table filled in row order, for 1 and for 3 threads.
void check(const std::vector<uint32_t>& ids) {
    std::unordered_map<uint32_t, uint32_t> expected;
    std::vector<uint32_t> duplicates;
    for (uint32_t row = 0; row < ids.size(); ++row)
        if (ids[row] != 0 && !expected.emplace(ids[row], row).second) duplicates.push_back(row);
    for (const unsigned threads : {1u, 3u}) {
        const IdMap map(ids, threads);
        std::size_t wrong = 0;
        for (const auto& [id, row] : expected)
            wrong += map.row(id) != row;
        // Ids beside the given ones, and the ends of the range of ids.
        for (const auto& [id, row] : expected)
            for (const uint32_t near : {id - 1, id + 1, id ^ 0x1000u, id + 4096u}) {
                const auto found = expected.find(near);
                wrong += map.row(near) != (found == expected.end() ? IdMap::none : found->second);
            }
        CHECK(wrong == 0);
        CHECK(map.row(0) == IdMap::none);
        CHECK((expected.count(0x7fffffff) != 0 || map.row(0x7fffffff) == IdMap::none));
        CHECK(std::vector<uint32_t>(map.duplicates().begin(), map.duplicates().end()) == duplicates);
    }
}

std::vector<uint32_t> consecutive(uint32_t first, uint32_t count) {
    std::vector<uint32_t> ids(count);
    std::iota(ids.begin(), ids.end(), first);
    return ids;
}

} // namespace

TEST_CASE("ids map to rows, whatever their order and range") {
    std::mt19937 random(3);
    SECTION("no ids, or only zeros") {
        check({});
        check({0, 0, 0});
    }
    SECTION("consecutive") {
        const auto ids = consecutive(17, 300000);
        check(ids);
        CHECK(IdMap(ids, 1).consecutive());
        CHECK(IdMap(ids, 1).bytes() == 0);
        check({2147483647});
    }
    SECTION("a zero among consecutive ids") {
        auto ids = consecutive(1, 1000);
        ids[500] = 0;
        check(ids);
    }
    SECTION("a leading zero") {
        check({0, 1, 2, 3});
    }
    SECTION("shuffled") {
        auto ids = consecutive(1, 400000);
        std::shuffle(ids.begin(), ids.end(), random);
        check(ids);
        CHECK(IdMap(ids, 1).bytes() <= 4 * 400000 + 4096);
    }
    SECTION("descending") {
        auto ids = consecutive(5, 5000);
        std::reverse(ids.begin(), ids.end());
        check(ids);
    }
    SECTION("numbered by part, far apart") {
        std::vector<uint32_t> ids;
        for (uint32_t part : {1u, 70u, 2000u})
            for (uint32_t i = 0; i < 40000; ++i)
                ids.push_back(part * 1000000u + i);
        check(ids);
        CHECK(IdMap(ids, 1).bytes() < 8 * ids.size() * sizeof(uint32_t));
    }
    SECTION("scattered") {
        std::vector<uint32_t> ids(200000);
        for (uint32_t& id : ids)
            id = static_cast<uint32_t>(random() % 2147483647u + 1);
        check(ids);
        CHECK(IdMap(ids, 1).bytes() <= 200000 * 32);
    }
    SECTION("duplicates keep the first row") {
        auto ids = consecutive(1, 300000);
        std::shuffle(ids.begin(), ids.end(), random);
        for (int i = 0; i < 1000; ++i)
            ids[random() % ids.size()] = ids[random() % ids.size()];
        check(ids);
        check({7, 7, 7});
        check({1, 2000000000, 1, 2000000000, 5});
    }
}
