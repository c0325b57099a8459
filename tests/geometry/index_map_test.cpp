#include "geometry/index_map.h"

#include <catch2/catch.hpp>
#include <map>

#include "geometry/random.h"

using namespace rinceau;

TEST_CASE("An index map agrees with an ordered map, whatever the keys") {
    Random random(7);
    IndexMap numbers;
    std::map<std::uint64_t, int> expected;
    for (int k = 0; k < 20'000; ++k) {
        // Few different keys, in rows and far apart: repeats, neighbours and equal low bits all occur.
        const auto low = static_cast<std::uint64_t>(random.uniform(0, 400));
        const std::uint64_t key = k % 3 == 0 ? low : k % 3 == 1 ? low << 40U : ~(low << 20U);
        const int stored = numbers.find_or_insert(key, k);
        CHECK(stored == expected.try_emplace(key, k).first->second);
    }
    CHECK(numbers.size() == expected.size());
    for (const auto& [key, value] : expected) CHECK(numbers.find(key) == value);
    CHECK(numbers.find(123'456'789'123ULL) == IndexMap::none);

    numbers.set(0, 5);
    numbers.set(~0ULL, 6);
    CHECK(numbers.find(0) == 5);
    CHECK(numbers.find(~0ULL) == 6);
    numbers.clear();
    CHECK(numbers.size() == 0);
    CHECK(numbers.find(0) == IndexMap::none);
}
