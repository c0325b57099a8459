#include "growth/surface/surface_lookup.h"

#include <catch2/catch.hpp>

#include "growth/surface/mesh_faults.h"
#include "scene/input_error.h"
#include "surface_shapes.h"

using namespace rinceau;

TEST_CASE("The nearest place by the tree is the one of all faces, and lies on the surface") {
    const SurfaceMesh surface = surface_mesh(torus_triangles(24, 14, 2, 0.7));
    const SurfaceLookup lookup(surface);
    Random random(8);
    for (int i = 0; i < 500; ++i) {
        const SpacePoint p{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-2, 2)};
        const NearestOnSurface all = nearest_on_surface(surface, p), tree = lookup.nearest(p);
        CHECK(all.at.face == tree.at.face);
        CHECK(all.distance == tree.distance);
        CHECK(abs(position_in_space(surface, tree.at) - p) == Approx(tree.distance).margin(1e-12));
        for (const double weight : barycentric(surface, tree.at)) CHECK(weight >= -1e-12);
        for (int k = 0; k < 20; ++k) {
            const SurfacePoint other = random_surface_point(surface, random);
            CHECK(abs(position_in_space(surface, other) - p) >= tree.distance - 1e-12);
        }
    }
    for (int v = 0; v < surface.vertices(); ++v)
        CHECK(lookup.nearest(surface.mesh.positions[static_cast<std::size_t>(v)]).distance < 1e-12);
}

TEST_CASE("The nearest vertex of a sphere is the one in the same direction") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(2));
    for (int v = 0; v < surface.vertices(); ++v)
        CHECK(nearest_vertex(surface, 3.0 * surface.mesh.positions[static_cast<std::size_t>(v)]) == v);
}

TEST_CASE("Samples by the table are those of the walk over all faces, and even over the area") {
    const SurfaceMesh surface = surface_mesh(torus_triangles(20, 12, 2, 0.7));
    const SurfaceSampler sampler(surface);
    Random a(3), b(3);
    for (int i = 0; i < 300; ++i) {
        const SurfacePoint p = sampler.sample(a), q = random_surface_point(surface, b);
        CHECK(p.face == q.face);
        CHECK(p.at == q.at);
    }
    int outside = 0;
    constexpr int count = 20000;
    for (int i = 0; i < count; ++i) {
        const SpacePoint p = position_in_space(surface, sampler.sample(a));
        outside += p.x * p.x + p.y * p.y > 4 ? 1 : 0;
    }
    // Pappus: the outer half of a torus has the share 1/2 + small / (pi large); of the mesh a little less.
    CHECK(outside / double(count) == Approx(0.5 + 0.7 / (pi * 2)).margin(0.015));
}

TEST_CASE("A plane's mesh fills its box with squares no larger than the step") {
    const Box box{{-1, 2}, {2.5, 4}};
    const TriangleMesh mesh = plane_mesh(box, 0.3);
    CHECK(mesh.positions.size() == 13 * 8);
    CHECK(mesh_faults(mesh).empty());
    const SurfaceMesh surface = surface_mesh(mesh);
    CHECK(surface.area == Approx(7));
    CHECK(surface.border_edges == 2 * (12 + 7));
    CHECK(surface.longest_edge <= 0.3 * std::sqrt(2.0));
    const auto [low, high] = bounds(mesh);
    CHECK(low == SpacePoint{-1, 2, 0});
    CHECK(high == SpacePoint{2.5, 4, 0});
    for (const auto& frame : surface.frame) CHECK(frame[2].z == Approx(1));
    CHECK(plane_mesh(box, 100).triangles.size() == 2);
    CHECK_THROWS_AS(plane_mesh(box, 1e-9), LimitError);
}
