// The area that an element keeps for itself.

#include <catch2/catch.hpp>

#include "geometry/orientation.h"
#include "geometry/polygon.h"
#include "growth/aggregate/exclusive_region.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

std::vector<Point> rectangle(double x, double y, double w, double h) {
    return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
}

/// A star with many corners more than it needs.
std::vector<Point> star(int arms, double outer, double inner) {
    std::vector<Point> ring;
    const int count = arms * 40;
    for (int i = 0; i < count; ++i) {
        const double turn = two_pi * i / count;
        ring.push_back(Point{7, -3} + polar(inner + (outer - inner) * (0.5 + 0.5 * std::cos(arms * turn)), turn));
    }
    return ring;
}

Region in_figure_frame(const ExclusiveRegion& region) {
    Region result = region.rings;
    for (auto& ring : result)
        for (Point& p : ring) p += region.center;
    return result;
}

}  // namespace

TEST_CASE("an exclusive region holds the outline, with few corners, about the middle of its box") {
    const Region outline{star(7, 50, 15)};
    const ExclusiveRegion region = exclusive_region(outline, {}, "star.svg");
    CHECK(region.rings.size() == 1);
    CHECK(region.rings.front().size() < outline.front().size() / 2);
    CHECK(signed_area(region.rings.front()) == Approx(region.area));
    CHECK(area(difference_of(outline, in_figure_frame(region))) <= 1e-6 * region.area);
    CHECK(abs(center(bounds(region.rings))) < 1e-9);
    CHECK(region.radius == Approx(abs(*std::ranges::max_element(region.rings.front(), {}, [](Point p) { return abs(p); }))));
    // A margin is kept all around.
    const ExclusiveRegion wide = exclusive_region(outline, {.margin = 4}, "star.svg");
    CHECK(area(difference_of(offset_region(outline, 3.9), in_figure_frame(wide))) <= 1e-3 * region.area);
    const ExclusiveRegion narrow = exclusive_region(outline, {.margin = -4}, "star.svg");
    CHECK(narrow.area < region.area);
}

TEST_CASE("inner discs lie inside the region, the largest first") {
    const ExclusiveRegion region = exclusive_region({star(5, 40, 10)}, {}, "star.svg");
    REQUIRE(!region.discs.empty());
    CHECK(region.discs.size() <= 28);
    CHECK(std::ranges::is_sorted(region.discs, std::ranges::greater{}, [](const InnerDisc& disc) { return disc.radius; }));
    for (const InnerDisc& disc : region.discs) {
        REQUIRE(inside_evenodd(region.rings.front(), disc.center));
        for (std::size_t i = 0; i < region.rings.front().size(); ++i) {
            const auto& ring = region.rings.front();
            REQUIRE(distance_to_segment(disc.center, ring[i], ring[(i + 1) % ring.size()]) >= disc.radius * (1 - 1e-12));
        }
    }
}

TEST_CASE("holes are filled unless others may stand in them") {
    const Region frame{rectangle(0, 0, 100, 60), rectangle(20, 15, 60, 30)};
    CHECK(exclusive_region(frame, {}, "frame.svg").rings.size() == 1);
    const ExclusiveRegion kept = exclusive_region(frame, {.keep_holes = true}, "frame.svg");
    REQUIRE(kept.rings.size() == 2);
    CHECK(kept.area == Approx(100 * 60 - 60 * 30).epsilon(0.07));
    // The discs stand in the frame, not in its hole.
    for (const InnerDisc& disc : kept.discs) CHECK_FALSE(inside_evenodd(kept.rings[1], disc.center));
}

TEST_CASE("parts that stand apart are held together") {
    const Region parts{rectangle(0, 0, 10, 10), rectangle(60, 0, 10, 10)};
    const ExclusiveRegion region = exclusive_region(parts, {}, "parts.svg");
    REQUIRE(region.rings.size() == 1);
    CHECK(area(difference_of(parts, in_figure_frame(region))) <= 1e-6 * region.area);
    // A slit that nothing could enter is closed: the corners of its bottom are gone.
    const Region slit{{{0, 0}, {50, 0}, {50, 20}, {26, 20}, {26, 2}, {24, 2}, {24, 20}, {0, 20}}};
    CHECK(exclusive_region(slit, {}, "slit.svg").area > 50 * 20);
    CHECK(drawn_exclusive_region(slit, {}, "slit.svg").area < 50 * 20 + 0.5 * (50 * 20 - area(slit)));
}

TEST_CASE("a shape without area and a margin that leaves nothing are refused by name") {
    CHECK_THROWS_WITH(exclusive_region({{{0, 0}, {10, 0}, {20, 0}}}, {}, "line.svg"),
                      Catch::Contains("line.svg") && Catch::Contains("no area"));
    CHECK_THROWS_AS(exclusive_region({}, {}, "empty.svg"), InputError);
    CHECK_THROWS_WITH(exclusive_region({rectangle(0, 0, 10, 10)}, {.margin = -6}, "small.svg"), Catch::Contains("margin"));
}

}  // namespace rinceau
