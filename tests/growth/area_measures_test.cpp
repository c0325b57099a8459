// Measures of aggregates on regions whose figures are known.

#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/random.h"
#include "growth/measure/cover.h"
#include "growth/measure/empty_circle.h"
#include "growth/measure/measure_aggregate.h"
#include "growth/measure/outline_overlaps.h"
#include "growth/measure/periodicity.h"

using namespace rinceau;

namespace {

constexpr double turn = 2 * 3.14159265358979323846;

Region square_at(Point low, double side) {
    return {{low, low + Point{side, 0}, low + Point{side, side}, low + Point{0, side}}};
}

ExclusiveRegion square_region(double side) {
    return {.rings = square_at({-0.5 * side, -0.5 * side}, side), .radius = side * std::sqrt(0.5), .area = side * side};
}

std::vector<Region> squares(int columns, int rows, double step, double side) {
    std::vector<Region> regions;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) regions.push_back(square_at({step * column, step * row}, side));
    return regions;
}

}  // namespace

TEST_CASE("The union of squares apart has the sum of their areas, of squares that overlap less") {
    const PackDomain domain{{{0, 0}, {100, 50}}, {}, false};
    Cover apart = cover(squares(40, 20, 2.5, 2), domain);
    CHECK(apart.domain == Approx(5000));
    CHECK(apart.sum == Approx(800 * 4.0));
    CHECK(std::abs(apart.sum - apart.united) < 1e-9 * 5000);
    CHECK(apart.within == Approx(apart.united));
    const Cover twice = cover({square_at({10, 10}, 4), square_at({12, 12}, 4), square_at({11, 11}, 1)}, domain);
    CHECK(twice.sum - twice.united == Approx(4 + 1));
    const Cover over = cover({square_at({-1, 10}, 4), square_at({98, 48}, 4)}, domain);
    CHECK(over.united == Approx(32));
    CHECK(over.within == Approx(12 + 4));
}

TEST_CASE("Holes of regions and of the domain are no area") {
    Region frame = square_at({0, 0}, 10);
    frame.push_back(square_at({2, 2}, 6)[0]);
    const PackDomain all{{{0, 0}, {20, 10}}, {}, false};
    CHECK(cover({frame, square_at({3, 3}, 4)}, all).united == Approx(100 - 36 + 16));
    const PackDomain framed{{{0, 0}, {10, 10}}, frame, false};
    const Cover in_hole = cover({square_at({1, 1}, 4)}, framed);
    CHECK(in_hole.domain == Approx(64));
    CHECK(in_hole.within == Approx(16 - 9));
}

TEST_CASE("What leaves a tile comes in on the other side") {
    const PackDomain tile{{{0, 0}, {10, 10}}, {}, true};
    const Cover corner = cover({square_at({8, 8}, 4)}, tile);
    CHECK(corner.sum == Approx(16));
    CHECK(corner.united == Approx(16));
    CHECK(corner.within == Approx(16));
    const Cover meeting = cover({square_at({8, 8}, 4), square_at({1, 1}, 2)}, tile);
    CHECK(meeting.sum - meeting.united == Approx(1));
}

TEST_CASE("Pairs that overlap are found by area, also one in another, never those that touch") {
    const Region unit = square_at({0, 0}, 1), small = square_at({0.4, 0.4}, 0.2);
    Region ring = square_at({-1, -1}, 3);
    ring.push_back(square_at({-0.5, -0.5}, 2)[0]);
    const auto pairs = [](const std::vector<PlacedOutline>& placed) { return overlapping_pairs(placed, 1e-7); };
    CHECK(pairs({{&unit, {}}, {&unit, translate({1, 0})}, {&unit, translate({0, 1})}}).empty());
    CHECK(pairs({{&unit, {}}, {&unit, translate({0.9, 0.9})}}) == std::vector<std::pair<int, int>>{{0, 1}});
    CHECK(pairs({{&small, {}}, {&unit, {}}}).size() == 1);
    CHECK(pairs({{&unit, {}}, {&unit, {}}}).size() == 1);
    CHECK(pairs({{&unit, {}}, {&ring, {}}}).empty());
    CHECK(pairs({{&unit, rotate(0.1)}, {&ring, translate({0.6, 0})}}).size() == 1);
}

TEST_CASE("Overlaps found by boxes and edges are those found by areas of all pairs") {
    Random random(11);
    std::vector<Region> shapes;
    std::vector<PlacedOutline> placed;
    for (int i = 0; i < 60; ++i) {
        std::vector<Point>& ring = shapes.emplace_back().emplace_back();
        for (int k = 0; k < 9; ++k) ring.push_back(polar(random.uniform(0.4, 1.2), turn * k / 9));
    }
    for (const Region& shape : shapes) {
        const double x = random.uniform(0, 12);
        placed.push_back({&shape, translate({x, random.uniform(0, 12)}) * rotate(random.uniform(0, turn))});
    }
    std::vector<std::pair<int, int>> expected;
    for (int i = 0; i < 60; ++i)
        for (int j = i + 1; j < 60; ++j) {
            const auto region = [&](int k) {
                const PlacedOutline& one = placed[static_cast<std::size_t>(k)];
                return placed_region(*one.outline, one.pose);
            };
            if (area(intersection_of(region(i), region(j))) > 1e-6) expected.emplace_back(i, j);
        }
    CHECK(expected.size() > 20);
    CHECK(overlapping_pairs(placed, 1e-7) == expected);
}

TEST_CASE("The largest gap lies between regions and the border, on a tile across its edge") {
    const PackDomain domain{{{0, 0}, {10, 10}}, {}, false};
    CHECK(largest_gap({}, domain).radius == Approx(5).epsilon(2e-3));
    const EmptyCircle beside = largest_gap({square_at({0, 0}, 4)}, domain);
    // From the corner (4, 4) to the walls x = 10 and y = 10: r = 6 - r / sqrt 2 .. along the diagonal.
    CHECK(beside.radius == Approx(6 * std::sqrt(2.0) / (1 + std::sqrt(2.0))).epsilon(2e-3));
    const PackDomain tile{{{0, 0}, {10, 10}}, {}, true};
    const EmptyCircle between = largest_gap({square_at({3, 3}, 4)}, tile);
    CHECK(between.radius == Approx(3 * std::sqrt(2.0)).epsilon(2e-3));
}

TEST_CASE("A periodic pattern has autocorrelation 1 at its period, one strewn by chance none") {
    const PackDomain tile{{{0, 0}, {64, 64}}, {}, true};
    const RepeatingStep period = strongest_repeat(squares(8, 8, 8, 4), tile, 6);
    CHECK(period.value == Approx(1).margin(1e-6));
    CHECK(std::remainder(period.step.x, 8) == Approx(0).margin(1e-6));
    CHECK(std::remainder(period.step.y, 8) == Approx(0).margin(1e-6));
    const PackDomain cut{{{0, 0}, {64, 64}}, {}, false};
    CHECK(strongest_repeat(squares(8, 8, 8, 4), cut, 6).value == Approx(7.0 / 8).margin(0.01));

    Random random(4);
    std::vector<Region> strewn;
    while (strewn.size() < 300) {
        const double x = random.uniform(0, 64);
        const Region one =
            placed_region(square_at({-1, -1}, 2), translate({x, random.uniform(0, 64)}) * rotate(random.uniform(0, turn)));
        strewn.push_back(one);
    }
    CHECK(strongest_repeat(strewn, tile, 4).value < 0.1);
}

TEST_CASE("An aggregate's measures agree with what was laid out") {
    const std::vector<ExclusiveRegion> shapes{square_region(2), square_region(1)};
    std::vector<PlacedRegion> placed;
    for (int i = 0; i < 16; ++i)
        placed.push_back({i % 2, translate({5.0 * (i % 4) + 2.5, 5.0 * static_cast<double>(i / 4) + 2.5})});
    const PackDomain domain{{{0, 0}, {20, 20}}, {}, false};
    AggregateMeasures measures = measure_aggregate(shapes, placed, domain);
    CHECK(measures.placed == 16);
    CHECK(measures.counts == std::vector<std::size_t>{8, 8});
    CHECK(measures.overlaps == 0);
    CHECK(std::abs(measures.overlap_area) < 1e-7);
    CHECK(measures.outside_area == Approx(0).margin(1e-7));
    CHECK(measures.coverage == Approx((8 * 4 + 8 * 1) / 400.0));
    CHECK(measures.autocorrelation > 0.5);

    placed.push_back({0, translate({19.5, 10})});
    measures = measure_aggregate(shapes, placed, domain, {.gap = false, .autocorrelation = false});
    CHECK(measures.overlaps == 0);
    CHECK(measures.outside_area == Approx(1));
    PackDomain tile = domain;
    tile.tiled = true;
    placed.push_back({1, translate({0.4, 10})});
    measures = measure_aggregate(shapes, placed, tile, {.gap = false, .autocorrelation = false});
    CHECK(measures.overlaps == 1);
    CHECK(measures.outside_area == Approx(0).margin(1e-7));
}
