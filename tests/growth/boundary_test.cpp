// Lines that stop growth and the region that it stays in.

#include <catch2/catch.hpp>

#include "geometry/polygon.h"
#include "geometry/random.h"
#include "growth/arrangement/boundary.h"

namespace rinceau {
namespace {

std::vector<Point> square(Point middle, double half) {
    return {middle + Point{-half, -half}, middle + Point{half, -half}, middle + Point{half, half},
            middle + Point{-half, half}};
}

std::vector<Point> star(Random& random, Point middle, double radius) {
    std::vector<Point> ring;
    for (int i = 0; i < 40; ++i) ring.push_back(middle + polar(radius * random.uniform(0.3, 1), two_pi * i / 40));
    return ring;
}

}  // namespace

TEST_CASE("nothing drawn allows everything") {
    const Boundary none;
    CHECK(none.is_empty());
    CHECK(none.allows({1e9, 0}));
    CHECK_FALSE(none.crosses({0, 0}, {1, 1}));
    CHECK_FALSE(none.cuts({square({0, 0}, 1)}, {}));
    CHECK_FALSE(none.nearest({0, 0}, 1e9));
}

TEST_CASE("a step over a line or onto it crosses, beside it not") {
    const Boundary wall({{{0, 0}, {0, 10}, {10, 10}}});
    CHECK(wall.crosses({-1, 5}, {1, 5}));
    CHECK(wall.crosses({-1, 5}, {0, 5}));
    CHECK(wall.crosses({0, 3}, {0, 3}));
    CHECK_FALSE(wall.crosses({-1, 11}, {11, 11}));
    CHECK_FALSE(wall.crosses({-1, -0.001}, {1, -0.001}));
    CHECK(wall.allows({-100, 0}));  // lines alone forbid no place
}

TEST_CASE("an outline is cut where a line crosses, touches or lies in it") {
    const Boundary wall({{{0, -10}, {0, 10}}, {{50, 0}, {50.2, 0}}});
    const Region outline{square({0, 0}, 1)};
    CHECK(wall.cuts(outline, translate({0.5, 0})));
    CHECK(wall.cuts(outline, translate({1, 0})));
    CHECK_FALSE(wall.cuts(outline, translate({1.001, 0})));
    CHECK(wall.cuts(outline, translate({1.2, 0}) * rotate(radians(45))));
    CHECK(wall.cuts(outline, translate({50, 0})));  // the short line is wholly inside
    const Region ring{square({0, 0}, 1), square({0, 0}, 0.5)};
    CHECK_FALSE(wall.cuts(ring, translate({50, 0})));  // it stands in the hole
    CHECK(wall.cuts({}, translate({50.1, 0})));
    CHECK_FALSE(wall.cuts({}, translate({50.1, 0.1})));
}

TEST_CASE("an outline stays in the region and out of its holes, also where it would swallow a hole") {
    const Boundary region({}, Region{square({0, 0}, 10), square({0, 0}, 1)});
    const Region outline{square({0, 0}, 0.5)};
    CHECK_FALSE(region.cuts(outline, translate({5, 5})));
    CHECK(region.cuts(outline, translate({9.8, 5})));
    CHECK(region.cuts(outline, translate({20, 5})));
    CHECK(region.cuts(outline, {}));
    CHECK(region.cuts({square({0, 0}, 3)}, {}));
    CHECK(region.allows({5, 5}));
    CHECK_FALSE(region.allows({0, 0}));
    CHECK_FALSE(region.allows({11, 0}));
    CHECK(region.crosses({0, 0}, {5, 0}));
}

TEST_CASE("queries agree with a plain look at every segment") {
    Random random(3);
    const Region region{star(random, {0, 0}, 10)};
    Polyline line;
    for (int i = 0; i < 50; ++i) line.push_back({random.uniform(-9, 9), random.uniform(-9, 9)});
    const Boundary boundary({line}, region);
    const auto every_segment = [&](auto visit) {
        for (std::size_t i = 1; i < line.size(); ++i) visit(line[i - 1], line[i]);
        for (std::size_t i = 0; i < region[0].size(); ++i) visit(region[0][i], region[0][(i + 1) % region[0].size()]);
    };
    for (int round = 0; round < 500; ++round) {
        const Point a{random.uniform(-12, 12), random.uniform(-12, 12)};
        const Point b = a + Point{random.uniform(-1, 1), random.uniform(-1, 1)};
        bool crossed = false;
        double least = 1e9;
        every_segment([&](Point p, Point q) {
            crossed |= segment_crossing(p, q, a, b).has_value();
            least = std::min(least, distance_to_segment(a, p, q));
        });
        REQUIRE(boundary.crosses(a, b) == crossed);
        REQUIRE(boundary.allows(a) == inside_evenodd(region[0], a));
        const auto nearest = boundary.nearest(a, 0.5);
        REQUIRE(nearest.has_value() == (least <= 0.5));
        if (nearest) REQUIRE(abs(*nearest - a) == Approx(least));
    }
}

}  // namespace rinceau
