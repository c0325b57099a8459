#include "growth/mesh/region_triangles.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/polygon.h"
#include "geometry/random.h"

namespace rinceau {
namespace {

double area_of(const RegionTriangles& t) {
    double sum = 0;
    for (const auto& [a, b, c] : t.triangles) {
        const auto p = [&](int i) { return t.points[static_cast<std::size_t>(i)]; };
        const double twice = cross(p(b) - p(a), p(c) - p(a));
        CHECK(twice > 0);
        sum += 0.5 * twice;
    }
    return sum;
}

double border_length(const RegionTriangles& t) {
    double sum = 0;
    for (const auto& [a, b] : t.borders)
        sum += abs(t.points[static_cast<std::size_t>(b)] - t.points[static_cast<std::size_t>(a)]);
    return sum;
}

double length_of(const Region& region) {
    double sum = 0;
    for (const auto& ring : region)
        for (std::size_t i = 0; i < ring.size(); ++i) sum += abs(ring[(i + 1) % ring.size()] - ring[i]);
    return sum;
}

std::vector<Point> star(Random& random, int corners, Point centre, double low, double high) {
    std::vector<Point> ring;
    for (int i = 0; i < corners; ++i)
        ring.push_back(centre + polar(random.uniform(low, high), two_pi * (i + random.uniform(0, 0.7)) / corners));
    return ring;
}

/// Each ring lies in the one before it.
void check_triangles(const Region& region) {
    const RegionTriangles t = region_triangles(region);
    double expected = 0, sign = 1;
    for (const auto& ring : region) {
        expected += sign * std::abs(signed_area(ring));
        sign = -sign;
    }
    CHECK(area_of(t) == Approx(expected).epsilon(1e-12));
    CHECK(border_length(t) == Approx(length_of(region)).epsilon(1e-12));
}

}  // namespace

TEST_CASE("the triangles of a region have its area and its border") {
    check_triangles({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
    check_triangles({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
    Random random(4);
    for (int i = 0; i < 40; ++i) {
        Region region{star(random, 9 + i, {10, 3}, 1, 2)};
        region.push_back(star(random, 8 + i / 2, {10, 3}, 0.2, 0.6));  // a hole
        region.push_back(star(random, 4, {10, 3}, 0.05, 0.12));        // an island in it
        check_triangles(region);
    }
}

TEST_CASE("corners on edges, repeated corners and rings that touch are taken as they are") {
    // A square whose right side is touched by a triangle's corner, and two squares that share a corner.
    const Region touching{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{1, 0.5}, {2, 0}, {2, 1}}, {{0, 1}, {0, 2}, {-1, 2}, {-1, 1}}};
    CHECK(area_of(region_triangles(touching)) == Approx(2.5).epsilon(1e-12));
    // One ring that passes through a corner twice.
    const Region bow{{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}};
    CHECK(area_of(region_triangles(bow)) == Approx(2).epsilon(1e-12));
    // Corners on a straight side, and a corner given twice.
    const Region straight{{{0, 0}, {1, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {0, 1}}};
    const RegionTriangles t = region_triangles(straight);
    CHECK(area_of(t) == Approx(3).epsilon(1e-12));
    CHECK(t.points.size() == 6);
}

TEST_CASE("a region without area has no triangles") {
    CHECK(region_triangles({}).triangles.empty());
    CHECK(region_triangles({{{0, 0}, {1, 1}, {2, 2}}}).triangles.empty());
    CHECK(region_triangles({{{1, 1}, {1, 1}, {1, 1}}}).triangles.empty());
}

TEST_CASE("long saws with thousands of corners keep area and border") {
    Random random(6);
    std::vector<Point> ring;
    for (int i = 0; i < 1500; ++i) ring.push_back({i * 0.01, i % 2 == 0 ? 0 : random.uniform(1, 3)});
    ring.push_back({15, 9});
    ring.push_back({-1, 9});
    check_triangles({ring});
    check_triangles({star(random, 3000, {0, 0}, 1, 3)});
}

TEST_CASE("triangles are as little pointed as the border allows") {
    std::vector<Point> ring;
    for (int i = 0; i < 10; ++i) ring.push_back({double(i), 0});
    for (int i = 9; i >= 0; --i) ring.push_back({double(i), 1});
    const RegionTriangles t = region_triangles({ring});
    CHECK(t.triangles.size() == 18);
    for (const auto& triangle : t.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            CHECK(abs(t.points[static_cast<std::size_t>(triangle[k])] -
                      t.points[static_cast<std::size_t>(triangle[(k + 1) % 3])]) < 1.5);
}

}  // namespace rinceau
