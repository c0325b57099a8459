// Growth under a brush, and over a ground that lines part.

#include <catch2/catch.hpp>

#include "growth/arrangement/grow_ground.h"
#include "growth/arrangement/spray.h"
#include "point_patterns.h"

namespace rinceau {
namespace {

Exemplar grid_exemplar() {
    std::vector<ExemplarPoint> points;
    for (int row = 0; row < 7; ++row) {
        for (int column = 0; column < 7; ++column) points.push_back({.position = {column * 10.0, row * 10.0}});
    }
    return make_exemplar(points, {"A"}, {}, "grid");
}

}  // namespace

TEST_CASE("a brush stops every half radius and covers what lies within its radius of the path") {
    const std::vector<Polyline> path{{{0, 0}, {100, 0}, {100, 50}}};
    const auto stops = brush_stops(path, 20);
    REQUIRE(stops.size() == 16);
    CHECK(stops.front().center == Point{0, 0});
    CHECK(abs(stops.back().center - Point{100, 50}) < 1e-9);
    CHECK(stops[1].radius == 20);
    const Region covered = sprayed_region(path, 20);
    constexpr double corner = 400 - 100 * pi;  // inside of the bend both arms cover the same
    CHECK(area(covered) == Approx(40 * 150 + 400 * pi - corner - 0.0).epsilon(0.02));
}

TEST_CASE("what is sprayed stands below the brush and all along its path") {
    const Exemplar exemplar = grid_exemplar();
    const std::vector<Polyline> path{{{0, 0}, {300, 0}}};
    const auto arrangement = sprayed(empty_arrangement(exemplar, {}), exemplar, {}, brush_stops(path, 25), {});
    const auto elements = arranged_elements(arrangement);
    CHECK(elements.size() > 130);
    std::vector<bool> met(31, false);
    for (const ArrangedElement& element : elements) {
        CHECK(std::abs(element.position.y) < 27);
        if (element.position.x >= 0 && element.position.x <= 300)
            met[static_cast<std::size_t>(element.position.x / 10)] = true;
    }
    for (std::size_t i = 0; i < 30; ++i) CHECK(met[i]);
}

TEST_CASE("growth begins far from lines and comes to every part that they separate") {
    const Exemplar exemplar = grid_exemplar();
    const Box ground{{0, 0}, {200, 100}};
    const Region frame{{ground.low, {200, 0}, ground.high, {0, 100}}};
    ArrangeSurroundings around;
    around.boundary = std::make_shared<const Boundary>(std::vector<Polyline>{{{60, -1}, {60, 101}}}, frame);
    const Point start = ground_start(around, ground);
    CHECK(start.x > 100);
    CHECK(std::abs(start.y - 50) < 6);

    const auto arrangement = grown_over(empty_arrangement(exemplar, {}), exemplar, around, ground, {});
    int left = 0, right = 0;
    for (const ArrangedElement& element : arranged_elements(arrangement)) {
        CHECK(around.boundary->allows(element.position));
        (element.position.x < 60 ? left : right) += 1;
    }
    CHECK(left > 40);
    CHECK(right > 100);

    GrowOrder order;
    order.count = 30;
    CHECK(grown_over(empty_arrangement(exemplar, {}), exemplar, around, ground, order).elements == 30);
}

}  // namespace rinceau
