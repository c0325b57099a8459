#include "geometry/convex_hull.h"

#include <catch2/catch.hpp>

#include "geometry/orientation.h"
#include "geometry/random.h"

namespace rinceau {

TEST_CASE("the hull turns left at every corner and has all points on its left") {
    Random random(2);
    for (int round = 0; round < 50; ++round) {
        std::vector<Point> points;
        // Few values a coordinate: points on lines, and equal ones.
        for (int i = 0; i < 30; ++i) points.push_back({double(random.below(6)), double(random.below(6))});
        const std::vector<Point> hull = convex_hull(points);
        REQUIRE(hull.size() >= 3);
        for (std::size_t i = 0; i < hull.size(); ++i) {
            const Point a = hull[i], b = hull[(i + 1) % hull.size()], c = hull[(i + 2) % hull.size()];
            CHECK(orientation(a, b, c) > 0);
            for (const Point p : points) CHECK(orientation(a, b, p) >= 0);
        }
    }
}

TEST_CASE("points on a line have two ends, one point is itself") {
    const std::vector<Point> line{{2, 2}, {0, 0}, {1, 1}, {3, 3}, {0, 0}};
    CHECK(convex_hull(line) == std::vector<Point>{{0, 0}, {3, 3}});
    const std::vector<Point> one{{1, 2}, {1, 2}};
    CHECK(convex_hull(one) == std::vector<Point>{{1, 2}});
    CHECK(convex_hull({}).empty());
}

}  // namespace rinceau
