#include "growth/mesh/solids.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "growth/mesh/region_triangles.h"

namespace rinceau {
namespace {

int size_of(const TriangleMesh& mesh) { return static_cast<int>(mesh.positions.size()); }

/// The number of the first corner of a turn of a point of the profile.
int add_turn(TriangleMesh& mesh, Point at, int around) {
    const int first = size_of(mesh);
    for (int i = 0; i < around; ++i) {
        const Point p = at.x * polar(1, two_pi * i / around);
        mesh.positions.push_back({p.x, p.y, at.y});
    }
    return first;
}

/// Between two closed rows of `count` corners, counter-clockwise seen from above; the upper one lies on the left of the way.
void add_band(TriangleMesh& mesh, int lower, int upper, int count) {
    for (int i = 0; i < count; ++i) {
        const int j = (i + 1) % count;
        mesh.triangles.push_back({lower + i, lower + j, upper + j});
        mesh.triangles.push_back({lower + i, upper + j, upper + i});
    }
}

void add_row(TriangleMesh& mesh, const std::vector<Point>& polygon, double z) {
    for (const Point p : polygon) mesh.positions.push_back({p.x, p.y, z});
}

/// Corners of the polygon moved inwards by `distance` from both edges.
std::vector<Point> inset(const std::vector<Point>& polygon, double distance) {
    std::vector<Point> inner;
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point before = polygon[i] - polygon[(i + n - 1) % n], after = polygon[(i + 1) % n] - polygon[i];
        const Point in_before = Point{-before.y, before.x} / abs(before), in_after = Point{-after.y, after.x} / abs(after);
        const Point sum = in_before + in_after;
        inner.push_back(polygon[i] + (2 * distance / norm(sum)) * sum);
    }
    return inner;
}

}  // namespace

TriangleMesh turned_solid(const std::vector<Point>& profile, int around) {
    TriangleMesh mesh;
    mesh.positions.push_back({0, 0, profile.front().y});
    int below = -1;
    for (std::size_t i = 1; i + 1 < profile.size(); ++i) {
        const int turn = add_turn(mesh, profile[i], around);
        if (below >= 0) add_band(mesh, below, turn, around);
        for (int k = 0; below < 0 && k < around; ++k) mesh.triangles.push_back({0, turn + (k + 1) % around, turn + k});
        below = turn;
    }
    mesh.positions.push_back({0, 0, profile.back().y});
    for (int k = 0; k < around; ++k) mesh.triangles.push_back({below + k, below + (k + 1) % around, size_of(mesh) - 1});
    return mesh;
}

TriangleMesh turned_ring(const std::vector<Point>& profile, int around) {
    TriangleMesh mesh;
    for (const Point p : profile) add_turn(mesh, p, around);
    const int rows = static_cast<int>(profile.size());
    for (int i = 0; i < rows; ++i) add_band(mesh, i * around, (i + 1) % rows * around, around);
    return mesh;
}

TriangleMesh extruded(const Region& region, double low, double high) {
    const RegionTriangles caps = region_triangles(region);
    const int count = static_cast<int>(caps.points.size());
    if (caps.triangles.empty()) return {};
    TriangleMesh mesh;
    add_row(mesh, caps.points, low);
    add_row(mesh, caps.points, high);
    for (const auto& [a, b, c] : caps.triangles) {
        mesh.triangles.push_back({a, c, b});
        mesh.triangles.push_back({a + count, b + count, c + count});
    }
    for (const auto& [a, b] : caps.borders) {
        mesh.triangles.push_back({a, b, b + count});
        mesh.triangles.push_back({a, b + count, a + count});
    }
    return mesh;
}

TriangleMesh bevelled_prism(const std::vector<Point>& polygon, double height, double bevel) {
    const int count = static_cast<int>(polygon.size());
    const RegionTriangles bottom = region_triangles({polygon});
    const std::vector<Point> top = inset(polygon, bevel);
    TriangleMesh mesh;
    add_row(mesh, polygon, 0);
    add_row(mesh, polygon, height - bevel);
    add_row(mesh, top, height);
    add_band(mesh, 0, count, count);
    add_band(mesh, count, 2 * count, count);
    for (const auto& [a, b, c] : bottom.triangles) {
        mesh.triangles.push_back({a, c, b});
        mesh.triangles.push_back({2 * count + a, 2 * count + b, 2 * count + c});
    }
    return mesh;
}

}  // namespace rinceau
