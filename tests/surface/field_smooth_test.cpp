#include "growth/surface/field_smooth.h"

#include <catch2/catch.hpp>

#include "growth/surface/field_elements.h"
#include "scene/input_error.h"
#include "surface_shapes.h"

using namespace rinceau;

namespace {

SurfaceField noise(const SurfaceMesh& surface, int n) {
    Random random(3);
    SurfaceField field{.n = n};
    for (int v = 0; v < surface.vertices(); ++v)
        field.values.push_back(polar(random.uniform(0.2, 1), random.uniform(-pi, pi)));
    return field;
}

std::size_t singular(const SurfaceMesh& surface, const SurfaceField& field) {
    return FieldOnSurface(surface, field).singular_faces().size();
}

}  // namespace

TEST_CASE("smoothing removes singular points, the more the wider, and keeps the sum of the indices") {
    for (const TriangleMesh& shape : {sphere_triangles(4), torus_triangles(60, 30, 2, 0.7)}) {
        const SurfaceMesh surface = surface_mesh(shape);
        for (const int n : {1, 2, 4}) {
            const SurfaceField field = noise(surface, n);
            std::size_t before = singular(surface, field);
            for (const double radius : {0.02, 0.06, 0.2}) {
                const SurfaceField smoother = smoothed(surface, field, radius);
                const std::size_t after = singular(surface, smoother);
                CHECK(after < before);
                CHECK(FieldOnSurface(surface, smoother).index_sum() == n * euler_characteristic(surface));
                before = after;
            }
            CHECK(singular(surface, smoothed_by_rounds(surface, field, 100)) < singular(surface, field) / 4);
        }
    }
}

TEST_CASE("the smoothest field has the fewest singular points that the surface allows") {
    const SurfaceMesh sphere = surface_mesh(sphere_triangles(4)), torus = surface_mesh(torus_triangles(60, 30, 2, 0.7));
    CHECK(singular(sphere, smoothest_field(sphere, 1)) == 2);
    CHECK(singular(sphere, smoothest_field(sphere, 2)) == 4);
    CHECK(singular(sphere, smoothest_field(sphere, 4)) == 8);
    for (const int n : {1, 2}) CHECK(singular(torus, smoothest_field(torus, n)) == 0);
}

TEST_CASE("a constant field of the plane is as smooth as can be: both ways leave it as it is") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(12, 9, 1, 0.3));
    const SurfaceField constant{.n = 2, .exact = PlaneForm{.angle = 0.4}};
    const std::vector<Complex> values = FieldOnSurface(surface, constant).field().values;
    for (const SurfaceField& field : {smoothed(surface, constant, 0.2), smoothed_by_rounds(surface, constant, 50)}) {
        CHECK_FALSE(field.exact);
        for (std::size_t v = 0; v < values.size(); ++v) CHECK(abs(field.values[v] - values[v]) < 1e-9);
    }
}

TEST_CASE("one implicit step weakens a wave by 1 / (1 + (k radius)^2), its numbers too") {
    const double length = 8, k = 3 * two_pi / length;
    const SurfaceMesh surface = surface_mesh(plane_triangles(160, 16, length / 160));
    SurfaceField field{.n = 2, .exact = PlaneForm{}};
    for (const SpacePoint p : surface.mesh.positions) field.scalar.push_back(std::cos(k * p.x));
    const double radius = 0.5;
    const SurfaceField smoother = smoothed(surface, field, radius / surface.diagonal);
    const double expected = 1 / (1 + k * k * radius * radius);
    for (std::size_t v = 0; v < field.scalar.size(); ++v)
        CHECK(smoother.scalar[v] == Approx(expected * field.scalar[v]).margin(0.01));
}

TEST_CASE("rounds can be kept to a region") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(3));
    const SurfaceField field = noise(surface, 2);
    const std::vector<int> region = vertices_around(surface, 7, 0.6);
    const SurfaceField smoother = smoothed_by_rounds(surface, field, 20, region);
    int changed = 0;
    for (int v = 0; v < surface.vertices(); ++v) {
        const bool same = smoother.values[static_cast<std::size_t>(v)] == field.values[static_cast<std::size_t>(v)];
        if (!same) ++changed;
        CHECK((same || std::ranges::find(region, v) != region.end()));
    }
    CHECK(changed == static_cast<int>(region.size()));
    CHECK(region.size() > 40);
}

TEST_CASE("a radius of 0 changes nothing, and one below is refused") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(1));
    const SurfaceField field = noise(surface, 2);
    CHECK(smoothed(surface, field, 0).values == field.values);
    CHECK_THROWS_AS(smoothed(surface, field, -1), InputError);
    CHECK_THROWS_AS(smoothed(surface, field, std::nan("")), InputError);
}
