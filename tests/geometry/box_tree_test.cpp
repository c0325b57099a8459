#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>

#include "geometry/box_tree.h"
#include "geometry/random.h"

using namespace rinceau;

static Box random_box(Random& random, double largest) {
    const Point low{random.uniform(-10, 10), random.uniform(-10, 10)};
    return {low, low + Point{random.uniform(0, largest), random.uniform(0, largest)}};
}

TEST_CASE("a box tree finds what trying every box finds") {
    Random random(3);
    for (const std::size_t count : {0U, 1U, 8U, 9U, 65U, 700U}) {
        std::vector<Box> boxes;
        for (std::size_t i = 0; i < count; ++i) boxes.push_back(i % 10 == 9 ? Box{} : random_box(random, i % 7 == 0 ? 9 : 1));
        const BoxTree tree(boxes);
        for (int k = 0; k < 50; ++k) {
            const Box query = random_box(random, 3);
            std::vector<std::size_t> found;
            CHECK(tree.visit(query, [&](std::size_t i) { return found.push_back(i), true; }));
            std::sort(found.begin(), found.end());
            std::vector<std::size_t> expected;
            for (std::size_t i = 0; i < count; ++i) {
                if (overlap(boxes[i], query)) expected.push_back(i);
            }
            CHECK(found == expected);
        }
    }
}

TEST_CASE("a visit to a box tree ends when it is told to, and a query may be unbounded") {
    constexpr double inf = std::numeric_limits<double>::infinity();
    const std::vector<Box> boxes(100, Box{{0, 0}, {1, 1}});
    const BoxTree tree(boxes);
    int visits = 0;
    CHECK_FALSE(tree.visit({{-inf, 0.5}, {inf, 0.5}}, [&](std::size_t) { return ++visits < 3; }));
    CHECK(visits == 3);
}
