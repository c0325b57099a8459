#include "exports/cut_holes.h"

#include <catch2/catch.hpp>

#include "geometry/polygon.h"

using namespace rinceau;

namespace {

Path square(double from, double to, bool counter_clockwise) {
    Path path{{from, from}, {line_to({to, from}), line_to({to, to}), line_to({from, to})}, true};
    if (!counter_clockwise) path = {{from, from}, {line_to({from, to}), line_to({to, to}), line_to({to, from})}, true};
    return path;
}

double area_of(const std::vector<std::vector<Point>>& polygons) {
    double area = 0;
    for (const std::vector<Point>& polygon : polygons) area += std::abs(signed_area(polygon));
    return area;
}

}  // namespace

TEST_CASE("A hole is cut in, an island in it is a polygon of its own") {
    const std::vector<Path> paths{square(0, 10, true), square(2, 8, false), square(4, 6, true)};
    for (const FillRule rule : {FillRule::nonzero, FillRule::evenodd}) {
        const auto polygons = polygons_with_cut_holes(paths, rule, 0.1);
        REQUIRE(polygons.size() == 2);
        CHECK(polygons[0].size() == 10);
        CHECK(area_of(polygons) == Approx(100 - 36 + 4));
    }
}

TEST_CASE("An outline inside one of the same sense is no hole by the nonzero rule") {
    const std::vector<Path> paths{square(0, 10, true), square(2, 8, true)};
    CHECK(area_of(polygons_with_cut_holes(paths, FillRule::nonzero, 0.1)) == Approx(100));
    CHECK(area_of(polygons_with_cut_holes(paths, FillRule::evenodd, 0.1)) == Approx(64));
}

TEST_CASE("Several holes are all cut in, by slits that cross nothing") {
    std::vector<Path> paths{square(0, 20, true)};
    for (const double at : {1.0, 5.0, 9.0, 13.0, 17.0}) paths.push_back(square(at, at + 2, false));
    const auto polygons = polygons_with_cut_holes(paths, FillRule::nonzero, 0.1);
    REQUIRE(polygons.size() == 1);
    CHECK(polygons[0].size() == 4 + 5 * 6);
    CHECK(area_of(polygons) == Approx(400 - 5 * 4));
    CHECK_FALSE(inside_evenodd(polygons[0], {10, 10}));
    CHECK(inside_evenodd(polygons[0], {10, 12}));
}
