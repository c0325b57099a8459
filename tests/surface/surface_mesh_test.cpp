#include "growth/surface/surface_mesh.h"

#include <catch2/catch.hpp>

#include "growth/surface/surface_point.h"
#include "surface_shapes.h"

using namespace rinceau;

TEST_CASE("Euler's characteristic tells plane, sphere and torus apart") {
    CHECK(euler_characteristic(surface_mesh(plane_triangles(5, 4, 1))) == 1);
    CHECK(euler_characteristic(surface_mesh(sphere_triangles(2))) == 2);
    CHECK(euler_characteristic(surface_mesh(torus_triangles(12, 8, 2, 0.7))) == 0);
    CHECK(euler_characteristic(surface_mesh(cylinder_triangles(12, 5, 1, 2))) == 0);
}

TEST_CASE("frames of neighbouring faces agree on the edge between them") {
    const SurfaceMesh surface = surface_mesh(torus_triangles(24, 12, 2, 0.7));
    for (int h = 0; h < 3 * surface.faces(); ++h) {
        const int twin = surface.twin[static_cast<std::size_t>(h)];
        REQUIRE(twin >= 0);
        const Complex over = edge_vector(surface, h) * surface.across[static_cast<std::size_t>(h)];
        CHECK(abs(over + edge_vector(surface, twin)) < 1e-12);
        const Complex there_and_back = transport_along(surface, h) * transport_along(surface, twin);
        CHECK(abs(there_and_back - Complex{1, 0}) < 1e-12);
    }
}

TEST_CASE("a point's weights give it back, and its place in space") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(2));
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        const SurfacePoint p = random_surface_point(surface, random);
        const auto weights = barycentric(surface, p);
        CHECK(abs(from_barycentric(surface, p.face, weights).at - p.at) < 1e-12);
        for (const double w : weights) CHECK(w >= -1e-12);
        CHECK(std::abs(abs(position_in_space(surface, p)) - 1) < 0.05);
    }
}
