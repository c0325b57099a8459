// Sides and contacts of segments, decided exactly.

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/orientation.h"
#include "geometry/random.h"

namespace rinceau {

TEST_CASE("the side of a point one unit in the last place off a line is told, where plain arithmetic rounds it away") {
    // The grid of Kettner et al. 2008: points about (0.5, 0.5) against the diagonal from (12, 12) to (24, 24).
    constexpr double step = std::numeric_limits<double>::epsilon() / 2;
    int plain_wrong = 0;
    for (int i = 0; i < 64; ++i) {
        for (int k = 0; k < 64; ++k) {
            const Point p{0.5 + i * step, 0.5 + k * step};
            const int expected = (k > i) - (k < i);
            REQUIRE(orientation({12, 12}, {24, 24}, p) == expected);
            const double rounded = cross(Point{24, 24} - Point{12, 12}, p - Point{12, 12});
            plain_wrong += (rounded > 0) - (rounded < 0) != expected ? 1 : 0;
        }
    }
    CHECK(plain_wrong > 100);
}

TEST_CASE("orientation agrees with whole numbers") {
    Random random(7);
    const auto draw = [&random] { return static_cast<int>(random.below(2001)) - 1000; };
    for (int round = 0; round < 2000; ++round) {
        const int ax = draw(), ay = draw(), bx = draw(), by = draw(), cx = draw(), cy = draw();
        const std::int64_t exact = std::int64_t{bx - ax} * (cy - ay) - std::int64_t{by - ay} * (cx - ax);
        // Far from the origin, where differences cancel.
        constexpr double far_away = 4503599627370496.0 / 4096;
        const auto at = [](int x, int y) { return Point{far_away + x, far_away + y}; };
        REQUIRE(orientation(at(ax, ay), at(bx, by), at(cx, cy)) == (exact > 0) - (exact < 0));
    }
}

TEST_CASE("segments cross, touch or are apart") {
    CHECK(segment_contact({0, 0}, {2, 2}, {0, 2}, {2, 0}) == SegmentContact::crossed);
    CHECK(segment_contact({0, 0}, {2, 0}, {1, 0}, {1, 5}) == SegmentContact::touching);
    CHECK(segment_contact({0, 0}, {2, 0}, {2, 0}, {3, 1}) == SegmentContact::touching);
    CHECK(segment_contact({0, 0}, {2, 0}, {1, 0}, {3, 0}) == SegmentContact::touching);
    CHECK(segment_contact({0, 0}, {2, 0}, {3, 0}, {4, 0}) == SegmentContact::apart);
    CHECK(segment_contact({0, 0}, {2, 0}, {1, 1e-300}, {1, 5}) == SegmentContact::apart);
    CHECK(segment_contact({1, 1}, {1, 1}, {0, 0}, {2, 2}) == SegmentContact::touching);
    CHECK(segment_contact({1, 1}, {1, 1}, {0, 0}, {0, 3}) == SegmentContact::apart);
}

}  // namespace rinceau
