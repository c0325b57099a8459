#include "growth/surface/curvature_field.h"

#include <catch2/catch.hpp>

#include "growth/surface/field_elements.h"
#include "surface_shapes.h"

using namespace rinceau;

TEST_CASE("curvature of a torus is that of its closed form, in size and direction") {
    const double large = 2, small = 0.7;
    const SurfaceMesh surface = surface_mesh(torus_triangles(120, 60, large, small));
    const SurfaceField field = curvature_field(surface);
    double major_squares = 0, minor_squares = 0, direction_squares = 0;
    for (int v = 0; v < surface.vertices(); ++v) {
        const SpacePoint p = surface.mesh.positions[static_cast<std::size_t>(v)];
        const double distance = std::hypot(p.x, p.y), cos_of_small = (distance - large) / small;
        const Complex z = field.values[static_cast<std::size_t>(v)];
        const double major = field.isotropic[static_cast<std::size_t>(v)] + abs(z);
        const double minor = field.isotropic[static_cast<std::size_t>(v)] - abs(z);
        major_squares += std::pow(major - 1 / small, 2);
        minor_squares += std::pow(minor - cos_of_small / distance, 2);
        const SpacePoint around{-p.y / distance, p.x / distance, 0};
        const double off = wrap_angle(arg(z) - 2 * direction_at_vertex(surface, v, around) - pi) / 2;
        direction_squares += off * off;
    }
    CHECK(std::sqrt(major_squares / surface.vertices()) < 0.005 / small);
    CHECK(std::sqrt(minor_squares / surface.vertices()) < 0.01);
    CHECK(degrees(std::sqrt(direction_squares / surface.vertices())) < 0.1);
}

TEST_CASE("curvature of a cylinder is exact away from its rims") {
    const SurfaceMesh surface = surface_mesh(cylinder_triangles(40, 10, 0.5, 3));
    const SurfaceField field = curvature_field(surface);
    const double chord = std::cos(pi / 40);  // of the faces' mean radius against the vertices'
    for (int v = 80; v < surface.vertices() - 80; ++v) {
        const Complex z = field.values[static_cast<std::size_t>(v)];
        CHECK(field.isotropic[static_cast<std::size_t>(v)] + abs(z) == Approx(2).epsilon(1 - chord));
        CHECK(std::abs(field.isotropic[static_cast<std::size_t>(v)] - abs(z)) < 1e-12);
        CHECK(std::abs(wrap_angle(arg(z) - 2 * direction_at_vertex(surface, v, {0, 0, 1}) - pi)) < 1e-3);
    }
}

TEST_CASE("curvature of a sphere is the same all over, positive, and negative inside out") {
    TriangleMesh shape = sphere_triangles(4);
    const SurfaceField outside = curvature_field(surface_mesh(shape));
    for (auto& [a, b, c] : shape.triangles) std::swap(b, c);
    const SurfaceField inside = curvature_field(surface_mesh(shape));
    for (std::size_t v = 0; v < shape.positions.size(); ++v) {
        CHECK(std::abs(outside.isotropic[v] - 1) < 0.03);
        CHECK(abs(outside.values[v]) < 0.03);
        CHECK(std::abs(inside.isotropic[v] + 1) < 0.03);
    }
}

TEST_CASE("for guiding, directions of nearly equal curvatures count little") {
    const SurfaceMesh sphere = surface_mesh(sphere_triangles(3));
    const SurfaceField raw = curvature_field(sphere), guiding = guiding_curvature_field(sphere);
    for (std::size_t v = 0; v < raw.values.size(); ++v) {
        CHECK(abs(guiding.values[v]) <= abs(raw.values[v]));
        if (abs(raw.values[v]) < 1e-3) CHECK(abs(guiding.values[v]) < 0.1 * abs(raw.values[v]));
    }
    const SurfaceMesh cylinder = surface_mesh(cylinder_triangles(40, 10, 0.5, 3));
    CHECK(abs(guiding_curvature_field(cylinder).values[120]) > 0.9);
}
