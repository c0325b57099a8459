#pragma once
// Surfaces with closed forms, for tests.

#include <cmath>

#include "geometry/angle.h"
#include "geometry/random.h"
#include "growth/surface/surface_mesh.h"

namespace rinceau {

/// columns x rows squares of side `step`, each cut in two, from (0, 0); inner vertices moved by up to `jitter` of a side.
inline TriangleMesh plane_triangles(int columns, int rows, double step, double jitter = 0) {
    TriangleMesh mesh;
    Random random(7);
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const bool inner = i > 0 && j > 0 && i < columns && j < rows;
            const double dx = inner ? random.uniform(-jitter, jitter) : 0, dy = inner ? random.uniform(-jitter, jitter) : 0;
            mesh.positions.push_back({(i + dx) * step, (j + dy) * step, 0});
        }
    const auto id = [columns](int i, int j) { return j * (columns + 1) + i; };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
            mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
        }
    return mesh;
}

/// Around the z axis; closed both ways. around x along faces x 2.
inline TriangleMesh torus_triangles(int around, int along, double large, double small) {
    TriangleMesh mesh;
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < around; ++i) {
            const double u = two_pi * i / around, v = two_pi * j / along, r = large + small * std::cos(v);
            mesh.positions.push_back({r * std::cos(u), r * std::sin(u), small * std::sin(v)});
        }
    const auto id = [around, along](int i, int j) { return (j % along) * around + i % around; };
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < around; ++i) {
            mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
            mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
        }
    return mesh;
}

/// About the z axis from z = 0, open at both ends.
inline TriangleMesh cylinder_triangles(int around, int along, double radius, double height) {
    TriangleMesh mesh;
    for (int j = 0; j <= along; ++j)
        for (int i = 0; i < around; ++i) {
            const double u = two_pi * i / around;
            mesh.positions.push_back({radius * std::cos(u), radius * std::sin(u), height * j / along});
        }
    const auto id = [around](int i, int j) { return j * around + i % around; };
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < around; ++i) {
            mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
            mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
        }
    return mesh;
}

/// Radius 1, an icosahedron cut in four `levels` times: 20 * 4^levels faces.
inline TriangleMesh sphere_triangles(int levels) {
    const double g = (1 + std::sqrt(5.0)) / 2;
    TriangleMesh mesh;
    mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (SpacePoint& p : mesh.positions) p = unit(p);
    for (int level = 0; level < levels; ++level) {
        const int count = static_cast<int>(mesh.positions.size());
        std::vector<std::vector<std::pair<int, int>>> middles(static_cast<std::size_t>(count));
        const auto middle = [&](int a, int b) {
            auto& known = middles[static_cast<std::size_t>(std::min(a, b))];
            for (const auto& [other, index] : known)
                if (other == std::max(a, b)) return index;
            const int index = static_cast<int>(mesh.positions.size());
            mesh.positions.push_back(
                unit(mesh.positions[static_cast<std::size_t>(a)] + mesh.positions[static_cast<std::size_t>(b)]));
            known.push_back({std::max(a, b), index});
            return index;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto [a, b, c] : mesh.triangles) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(finer);
    }
    return mesh;
}

}  // namespace rinceau
