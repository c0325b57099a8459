// Delaunay triangulations against what defines them.

#include <catch2/catch.hpp>
#include <set>

#include "geometry/delaunay.h"
#include "geometry/random.h"

namespace rinceau {
namespace {

std::vector<Point> random_points(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back({random.uniform(-3, 8), random.uniform(100, 103)});
    return points;
}

double twice_area(const std::vector<Point>& points, const DelaunayTriangle& t) {
    const Point a = points[static_cast<std::size_t>(t.corners[0])];
    return cross(points[static_cast<std::size_t>(t.corners[1])] - a, points[static_cast<std::size_t>(t.corners[2])] - a);
}

/// How far inside the circle about the triangle the point lies: positive inside (the classical determinant).
double in_circle(const std::vector<Point>& points, const DelaunayTriangle& t, Point p) {
    const Point a = points[static_cast<std::size_t>(t.corners[0])] - p;
    const Point b = points[static_cast<std::size_t>(t.corners[1])] - p;
    const Point c = points[static_cast<std::size_t>(t.corners[2])] - p;
    return norm(a) * cross(b, c) - norm(b) * cross(a, c) + norm(c) * cross(a, b);
}

void check_neighbors(const std::vector<DelaunayTriangle>& triangles) {
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const int other = triangles[t].neighbors[k];
            if (other < 0) continue;
            const DelaunayTriangle& across = triangles[static_cast<std::size_t>(other)];
            bool mutual = false;
            for (std::size_t m = 0; m < 3; ++m)
                mutual = mutual || (across.neighbors[m] == static_cast<int>(t) &&
                                    across.corners[m] == triangles[t].corners[(k + 1) % 3] &&
                                    across.corners[(m + 1) % 3] == triangles[t].corners[k]);
            CHECK(mutual);
        }
}

}  // namespace

TEST_CASE("no point lies inside the circle about a Delaunay triangle, and the triangles fill the hull") {
    for (const std::size_t count : {3U, 4U, 10U, 150U}) {
        const std::vector<Point> points = random_points(count, count);
        const auto triangles = delaunay(points);
        check_neighbors(triangles);
        std::size_t hull = 0;
        std::set<int> seen;
        for (const DelaunayTriangle& t : triangles) {
            CHECK(twice_area(points, t) > 0);
            for (const int other : t.neighbors) hull += other < 0 ? 1U : 0U;
            seen.insert(t.corners.begin(), t.corners.end());
            double deepest = -1;
            for (const Point p : points) deepest = std::max(deepest, in_circle(points, t, p));
            CHECK(deepest < 1e-6);
        }
        CHECK(seen.size() == count);
        CHECK(triangles.size() == 2 * count - 2 - hull);  // Euler
    }
}

TEST_CASE("points on common circles are triangulated the same way at every start") {
    std::vector<Point> grid;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 12; ++j) grid.push_back({0.1 * j, 0.1 * i});
    const auto triangles = delaunay(grid);
    CHECK(triangles.size() == 2U * 11 * 11);
    check_neighbors(triangles);
    double whole = 0;
    for (const DelaunayTriangle& t : triangles) {
        CHECK(t.corners[0] < std::min(t.corners[1], t.corners[2]));
        whole += 0.5 * twice_area(grid, t);
    }
    CHECK(whole == Approx(1.21));
    std::vector<Point> ring;
    for (int i = 0; i < 17; ++i) ring.push_back(polar(5, 0.3 + i * 6.283185307179586 / 17));
    CHECK(delaunay(ring).size() == 15);
}

TEST_CASE("points in one place count once, and points on a line have no triangles") {
    const std::vector<Point> twice{{0, 0}, {1, 0}, {0, 1}, {1, 0}, {0, 0}};
    const auto triangles = delaunay(twice);
    REQUIRE(triangles.size() == 1);
    CHECK(triangles.front().corners == std::array<int, 3>{0, 1, 2});
    CHECK(triangles.front().neighbors == std::array<int, 3>{-1, -1, -1});
    CHECK(delaunay(std::vector<Point>{{0, 0}, {1, 1}, {2, 2}, {7, 7}}).empty());
    CHECK(delaunay(std::vector<Point>{{4, 4}, {4, 4}, {4, 4}}).empty());
    CHECK(delaunay(std::vector<Point>{{0, 0}, {1, 1}}).empty());
    CHECK(delaunay(std::vector<Point>{}).empty());
}

}  // namespace rinceau
