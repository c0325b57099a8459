// Lines and areas from drawings.

#include <catch2/catch.hpp>

#include "growth/strokes.h"
#include "scene/input_error.h"
#include "scene/svg_read.h"

namespace rinceau {
namespace {

Scene drawing(const std::string& shapes) {
    return read_svg("<svg xmlns='http://www.w3.org/2000/svg' width='200' height='200'>" + shapes + "</svg>").scene;
}

std::string region_error(const std::string& shapes) {
    try {
        region_of(drawing(shapes), 0.1, "region.svg");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("every sub-path is a line of its own, without corners that repeat, and what has no length is none") {
    const auto lines =
        polylines_of(drawing("<path fill='none' stroke='black' d='M10 10 H50 H50 V90 M5 5 L5 5 M0 0 H10 V10 Z'/>"), 0.1);
    REQUIRE(lines.size() == 2);
    CHECK(lines[0] == Polyline{{10, -10}, {50, -10}, {50, -90}});
    CHECK(lines[1] == Polyline{{0, 0}, {10, 0}, {10, -10}, {0, 0}});
}

TEST_CASE("a curve is followed within the deviation") {
    const auto lines = polylines_of(drawing("<circle cx='100' cy='100' r='50'/>"), 0.01);
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].front() == lines[0].back());
    for (const Point p : lines[0]) CHECK(abs(p - Point{100, -100}) == Approx(50).margin(0.02));
}

TEST_CASE("an outline inside another one is a hole, whatever their fills") {
    const Region region = region_of(
        drawing("<rect width='100' height='100' fill='red'/><rect x='20' y='20' width='60' height='60' fill='blue'/>"
                "<rect x='40' y='40' width='20' height='20' fill='none' stroke='red'/>"),
        0.1, "region.svg");
    CHECK(area(region) == Approx(10000 - 3600 + 400));
}

TEST_CASE("outlines that share a side or a corner are a region") {
    const Region region = region_of(drawing("<path d='M0 0H50V50H0Z M50 0H100V50H50Z M100 50h20v20h-20z M0 0h10v10h-10z'/>"),
                                    0.1, "region.svg");
    CHECK(area(region) == Approx(2500 - 100 + 2500 + 400).epsilon(1e-6));
}

TEST_CASE("a region that cannot be told says where and why") {
    CHECK_THAT(region_error("<path d='M0 0 L100 100 L100 0 L0 100 Z'/>"),
               Catch::Contains("region.svg: an outline of the region crosses itself near (50, 50)"));
    CHECK_THAT(region_error("<rect width='60' height='60'/><rect x='20' y='20' width='60' height='60'/>"),
               Catch::Contains("two outlines of the region cross near (60, 20)") ||
                   Catch::Contains("two outlines of the region cross near (20, 60)"));
    // Sides that lie on one another: the outlines cross nowhere but where they touch.
    CHECK_THAT(region_error("<rect width='60' height='60'/><rect x='20' width='60' height='60'/>"),
               Catch::Contains("two outlines of the region cross near (40, 30)"));
    CHECK_THAT(region_error("<path fill='none' stroke='black' d='M0 0 L100 100 L100 0'/>"),
               Catch::Contains("closed outlines"));
    CHECK_THAT(region_error("<path d='M0 0 L100 100 L50 50 Z'/>"), Catch::Contains("enclose no area"));
    CHECK_THAT(region_error("<rect width='60' height='60'/><rect width='60' height='60'/>"),
               Catch::Contains("enclose no area"));
}

}  // namespace rinceau
