// Exact overlap of regions, found quickly.

#include <catch2/catch.hpp>

#include "tests/growth/aggregate_shapes.h"
#include "geometry/orientation.h"
#include "geometry/random.h"
#include "growth/aggregate/region_grid.h"

namespace rinceau {
namespace {

ExclusiveRegion as_is(const std::vector<std::vector<Point>>& rings) {
    ExclusiveRegion region{.rings = rings, .area = area(rings)};
    for (const auto& ring : rings)
        for (const Point p : ring) region.radius = std::max(region.radius, abs(p));
    region.discs = {{{}, region.radius / 10}};
    return region;
}

bool inside(const Region& region, Point p) {
    bool result = false;
    for (const auto& ring : region)
        for (std::size_t i = 0; i < ring.size(); ++i) result ^= crosses_ray(ring[i], ring[(i + 1) % ring.size()], p);
    return result;
}

/// Every edge with every edge, every corner with the other region.
bool overlap_by_brute_force(const Region& a, const Region& b) {
    for (const auto& ring : a)
        for (std::size_t i = 0; i < ring.size(); ++i)
            for (const auto& other : b)
                for (std::size_t k = 0; k < other.size(); ++k)
                    if (segments_meet(ring[i], ring[(i + 1) % ring.size()], other[k], other[(k + 1) % other.size()]))
                        return true;
    const auto any_inside = [](const Region& inner, const Region& outer) {
        for (const auto& ring : inner)
            for (const Point p : ring)
                if (inside(outer, p)) return true;
        return false;
    };
    return any_inside(a, b) || any_inside(b, a);
}

const PackDomain wide_domain{.box = {{-1000, -1000}, {1000, 1000}}};

}  // namespace

TEST_CASE("the grid agrees with brute force on random pairs, shapes in holes and inside one another among them") {
    std::vector<ExclusiveRegion> regions = star_bar_and_bow();
    regions.push_back(as_is({box_ring(-40, -30, 80, 60), {{-30, -20}, {-30, 20}, {30, 20}, {30, -20}}}));  // a frame
    Random random(7);
    int overlapping = 0, in_hole = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        RegionGrid grid(regions, wide_domain, 0.2, 2);
        const auto draw = [&] {
            const Similarity pose{polar(random.uniform(0.2, 2), random.uniform(0, two_pi)),
                                  {random.uniform(-50, 50), random.uniform(-50, 50)}};
            return PlacedRegion{static_cast<int>(random.below(4)), pose};
        };
        const PlacedRegion first = draw(), second = draw();
        REQUIRE(grid.is_free(first.shape, first.pose));
        grid.place(first);
        const Region a = outline_of(regions, first), b = outline_of(regions, second);
        const bool overlaps = overlap_by_brute_force(a, b);
        REQUIRE(grid.is_free(second.shape, second.pose) == !overlaps);
        overlapping += overlaps;
        in_hole += !overlaps && contains(bounds(a), bounds(b)) && first.shape == 3;
        // What is taken out is in nobody's way, and back in its place it is again.
        grid.take_out(0);
        REQUIRE(grid.is_free(second.shape, second.pose));
        grid.put_back(0, first.pose);
        REQUIRE(grid.is_free(second.shape, second.pose) == !overlaps);
    }
    CHECK(overlapping > 1000);
    CHECK(overlapping < 3800);
    CHECK(in_hole > 10);
}

TEST_CASE("touching is overlap, down to the last digit") {
    const std::vector<ExclusiveRegion> regions{as_is({box_ring(-1, -1, 2, 2)}), as_is({{{0, 0}, {3, 1}, {0, 2}}})};
    RegionGrid grid(regions, wide_domain, 1, 1);
    grid.place({0, {}});
    const double beside = std::nextafter(2.0, 3.0);
    CHECK_FALSE(grid.is_free(0, translate({2, 0})));    // a whole edge in common
    CHECK_FALSE(grid.is_free(0, translate({2, 1.5})));  // a piece of it
    CHECK_FALSE(grid.is_free(0, translate({2, 2})));    // a corner
    CHECK_FALSE(grid.is_free(0, {}));                   // the same place
    CHECK_FALSE(grid.is_free(0, scale_by(0.5)));        // inside
    CHECK_FALSE(grid.is_free(0, scale_by(2)));          // around
    CHECK(grid.is_free(0, translate({beside, 0})));
    CHECK(grid.is_free(0, translate({beside, beside})));
    CHECK_FALSE(grid.is_free(1, translate({-4, 0})));  // its tip on the edge
    CHECK(grid.is_free(1, translate({std::nextafter(-4.0, -5.0), 0})));
}

TEST_CASE("a domain's outline is not crossed, its holes stay empty, and a box may be touched") {
    const std::vector<ExclusiveRegion> regions{as_is({box_ring(-5, -5, 10, 10)})};
    RegionGrid in_box(regions, {.box = {{0, 0}, {100, 50}}}, 1, 1);
    CHECK(in_box.is_free(0, translate({5, 5})));
    CHECK_FALSE(in_box.is_free(0, translate({4.999, 25})));
    const Region ring{box_ring(0, 0, 100, 50), box_ring(40, 20, 20, 10), box_ring(70, 24, 2, 2)};
    RegionGrid in_region(regions, {.box = {{-100, -100}, {200, 200}}, .region = ring}, 0.1, 4);
    CHECK(in_region.is_free(0, translate({20, 25})));
    CHECK_FALSE(in_region.is_free(0, translate({36, 25})));                  // over the edge of a hole
    CHECK_FALSE(in_region.is_free(0, translate({50, 25}) * scale_by(0.3)));  // in the hole
    CHECK_FALSE(in_region.is_free(0, translate({71, 25})));                  // around a hole
    CHECK_FALSE(in_region.is_free(0, translate({150, 25})));
    CHECK_FALSE(in_region.is_free(0, translate({50, 25}) * scale_by(15)));
}

TEST_CASE("on a tile what leaves on one side is met on the other") {
    const std::vector<ExclusiveRegion> regions{as_is({box_ring(-5, -5, 10, 10)})};
    RegionGrid grid(regions, {.box = {{0, 0}, {60, 40}}, .tiled = true}, 1, 1);
    grid.place({0, translate({1, 1})});
    for (const Point at : {Point{59, 1}, Point{1, 39}, Point{59, 39}, Point{52, 1}})
        CHECK_FALSE(grid.is_free(0, translate(at)));
    CHECK(grid.is_free(0, translate({50, 1})));
    grid.place({0, translate({50, 1})});
    CHECK_FALSE(grid.is_free(0, translate({50, 32})));
    CHECK(grid.is_free(0, translate({50, 30})));
}

}  // namespace rinceau
