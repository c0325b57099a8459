#include <catch2/catch.hpp>

#include <vector>

#include "geometry/angle.h"
#include "geometry/polygon.h"
#include "geometry/random.h"

using namespace rinceau;

static const std::vector<Point> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};

TEST_CASE("the area is positive counter-clockwise and keeps its digits far from the origin") {
    CHECK(signed_area(square) == 4);
    const std::vector<Point> clockwise(square.rbegin(), square.rend());
    CHECK(signed_area(clockwise) == -4);
    std::vector<Point> far = square;
    for (Point& p : far) p += Point{1e9, 1e9};
    CHECK(signed_area(far) == 4);
    CHECK(signed_area({}) == 0);
}

TEST_CASE("a pentagram winds twice about its middle, which even-odd takes for outside") {
    std::vector<Point> star;
    for (int i = 0; i < 5; ++i) star.push_back(polar(1, two_pi * 2 * i / 5));
    CHECK(winding_number(star, {0, 0}) == 2);
    CHECK_FALSE(inside_evenodd(star, {0, 0}));
    const Point in_a_tip = 0.8 * star[0];
    CHECK(winding_number(star, in_a_tip) == 1);
    CHECK(inside_evenodd(star, in_a_tip));
    CHECK(winding_number(star, {2, 0}) == 0);
    std::vector<Point> reversed(star.rbegin(), star.rend());
    CHECK(winding_number(reversed, {0, 0}) == -2);
}

TEST_CASE("a ray through a corner counts it once") {
    const std::vector<Point> diamond{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    CHECK(winding_number(diamond, {0, 0}) == 1);
    CHECK(winding_number(diamond, {-2, 0}) == 0);
    CHECK(winding_number(diamond, {-2, 1}) == 0);
}

TEST_CASE("the distance to a segment is to its inside or to its ends") {
    CHECK(distance_to_segment({1, 3}, {0, 0}, {2, 0}) == 3);
    CHECK(distance_to_segment({-3, 4}, {0, 0}, {2, 0}) == 5);
    CHECK(distance_to_segment({3, 4}, {0, 0}, {0, 0}) == 5);
}

TEST_CASE("the crossing of two segments lies on both") {
    Random random(5);
    int crossings = 0;
    for (int i = 0; i < 200; ++i) {
        const auto point = [&] { return Point{random.uniform(-1, 1), random.uniform(-1, 1)}; };
        const Point a1 = point(), a2 = point(), b1 = point(), b2 = point();
        const bool apart =
            cross(a2 - a1, b1 - a1) * cross(a2 - a1, b2 - a1) > 0 || cross(b2 - b1, a1 - b1) * cross(b2 - b1, a2 - b1) > 0;
        const std::optional<SegmentCrossing> crossing = segment_crossing(a1, a2, b1, b2);
        CHECK(crossing.has_value() == !apart);
        if (!crossing) continue;
        ++crossings;
        CHECK(distance_to_segment(crossing->at, a1, a2) < 1e-12);
        CHECK(abs(crossing->at - (b1 + crossing->along_b * (b2 - b1))) < 1e-9);
    }
    CHECK(crossings > 20);
    CHECK_FALSE(segment_crossing({0, 0}, {1, 0}, {0, 0}, {2, 0}));
}
