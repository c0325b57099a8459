#include <catch2/catch.hpp>

#include "geometry/angle.h"
#include "scene/svg_shapes.h"

using namespace rinceau;

TEST_CASE("a rectangle's radii follow each other and are clamped to half the sides") {
    CHECK(rectangle({10, 20, 30, 40}) ==
          std::vector<Path>{{{10, 20}, {line_to({40, 20}), line_to({40, 60}), line_to({10, 60})}, true}});
    const RectangleShape one_radius{0, 0, 20, 10, 5.0, std::nullopt};
    const RectangleShape both_radii{0, 0, 20, 10, 5.0, 5.0};
    CHECK(rectangle(one_radius) == rectangle(both_radii));
    CHECK(length(rectangle(both_radii)) == Approx(20 + 10 * pi).epsilon(3e-4));
    const std::vector<Path> oval = rectangle({0, 0, 20, 10, 50.0, 50.0});
    CHECK(length(oval) == Approx(length(ellipse({10, 5}, 10, 5))).epsilon(1e-9));
    CHECK(rectangle({0, 0, 20, 10, 5.0, 0.0})[0].segments.size() == 3);
    CHECK(rectangle({0, 0, 20, 10, -5.0, std::nullopt})[0].segments.size() == 3);
}

TEST_CASE("a circle has the length and the box of the closed form") {
    const std::vector<Path> circle = ellipse({3, 4}, 5, 5);
    CHECK(length(circle) == Approx(10 * pi).epsilon(3e-4));
    const Box box = bounds(circle);
    CHECK(abs(box.low - Point{-2, -1}) < 1e-12);
    CHECK(abs(box.high - Point{8, 9}) < 1e-12);
    for (const Point p : flattened(circle[0], 1e-3)) CHECK(abs(p - Point{3, 4}) == Approx(5).epsilon(3e-4));
}

TEST_CASE("shapes without extent are not drawn, lines of length 0 are") {
    CHECK(rectangle({0, 0, 0, 10}).empty());
    CHECK(rectangle({0, 0, -1, 10}).empty());
    CHECK(ellipse({0, 0}, 0, 5).empty());
    CHECK(polyline({}, true).empty());
    CHECK(line({1, 1}, {1, 1}) == std::vector<Path>{{{1, 1}, {line_to({1, 1})}, false}});
}

TEST_CASE("points before a fault are kept") {
    CHECK(parse_points("20,5 30,5,30+15 2e1,1.5e1").points.size() == 4);
    const ParsedPoints odd = parse_points("70,10 80,20 90");
    CHECK(odd.faulty);
    CHECK(odd.points == std::vector<Point>{{70, 10}, {80, 20}});
    CHECK(parse_points("1,2 x").faulty);
    CHECK_FALSE(parse_points(" \n ").faulty);
}
