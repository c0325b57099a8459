#include "geometry/parallel.h"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <vector>

using namespace rinceau;

TEST_CASE("every index has its turn once, on any number of threads") {
    for (const int threads : {0, 1, 2, 5}) {
        for (const std::size_t count : {0U, 1U, 3U, 1000U}) {
            std::vector<int> turns(count, 0);
            for_each_index(count, threads, [&](std::size_t k) { ++turns[k]; });
            CHECK(turns == std::vector<int>(count, 1));
        }
    }
}

TEST_CASE("what one call throws comes out, on any number of threads") {
    for (const int threads : {1, 2, 5}) {
        const auto work = [](std::size_t k) {
            if (k == 700) throw std::runtime_error("seven hundred");
        };
        CHECK_THROWS_AS(for_each_index(1000, threads, work), std::runtime_error);
    }
}
