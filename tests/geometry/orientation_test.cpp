// Orientation and crossing without rounding.

#include <catch2/catch.hpp>

#include <limits>

#include "geometry/orientation.h"
#include "geometry/random.h"

namespace rinceau {

TEST_CASE("orientation tells points beside a line from points on it, one last digit away") {
    const Point a{0.5, 0.5}, b{12, 12}, c{24, 24};
    CHECK(orientation(a, b, c) == 0);
    const double up = std::nextafter(24.0, 25.0), down = std::nextafter(24.0, 23.0);
    CHECK(orientation(a, b, {24, up}) == 1);
    CHECK(orientation(a, b, {24, down}) == -1);
    // The rounded determinant is 0 or has the wrong sign near the line y = x (Kettner et al. 2008, classroom examples).
    const double step = std::numeric_limits<double>::epsilon() / 2;
    for (int i = 0; i < 64; ++i)
        for (int k = 0; k < 64; ++k) {
            const int expected = i < k ? 1 : (i > k ? -1 : 0);
            REQUIRE(orientation({0.5 + i * step, 0.5 + k * step}, {12, 12}, {24, 24}) == expected);
        }
}

TEST_CASE("orientation is the same whichever corner is named first") {
    Random random(4);
    for (int i = 0; i < 2000; ++i) {
        // Three points on a line but for their rounding, far from the origin.
        const Point from{1000 + random.uniform(), -3000 + random.uniform()}, along{random.uniform(), random.uniform()};
        const Point a = from + random.uniform() * along, b = from + random.uniform() * along,
                    c = from + random.uniform() * along;
        const int turn = orientation(a, b, c);
        REQUIRE(orientation(b, c, a) == turn);
        REQUIRE(orientation(c, a, b) == turn);
        REQUIRE(orientation(b, a, c) == -turn);
        REQUIRE(exact_orientation(a, b, c) == turn);
    }
}

TEST_CASE("segments meet where they cross, touch or share a piece, and nowhere else") {
    CHECK(segments_meet({0, 0}, {2, 2}, {0, 2}, {2, 0}));
    CHECK(segments_meet({0, 0}, {2, 0}, {1, 0}, {1, 5}));  // a foot on the edge
    CHECK(segments_meet({0, 0}, {2, 0}, {2, 0}, {3, 7}));  // a corner in common
    CHECK(segments_meet({0, 0}, {2, 0}, {1, 0}, {5, 0}));  // a piece in common
    CHECK(segments_meet({0, 0}, {3, 3}, {1, 1}, {1, 1}));  // a point on it
    CHECK_FALSE(segments_meet({0, 0}, {2, 0}, {3, 0}, {5, 0}));
    CHECK_FALSE(segments_meet({0, 0}, {3, 3}, {1, 2}, {1, 2}));
    CHECK_FALSE(segments_meet({0, 0}, {2, 0}, {1, 1e-300}, {1, 5}));
    CHECK_FALSE(segments_meet({0, 0}, {2, 2}, {1.5, 0.5}, {3, -1}));
}

}  // namespace rinceau
