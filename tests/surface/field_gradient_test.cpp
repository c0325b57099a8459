#include "growth/surface/field_gradient.h"

#include <catch2/catch.hpp>

#include "growth/surface/field_elements.h"
#include "surface_shapes.h"

using namespace rinceau;

namespace {

/// Of vectors in space, one by vertex.
template <class Vector>
SurfaceField vector_field(const SurfaceMesh& surface, int n, Vector vector) {
    SurfaceField field{.n = n};
    for (int v = 0; v < surface.vertices(); ++v) {
        const SpacePoint in_space = vector(surface.mesh.positions[static_cast<std::size_t>(v)]);
        field.values.push_back(polar(abs(in_space), n * direction_at_vertex(surface, v, in_space)));
    }
    return field;
}

}  // namespace

TEST_CASE("divergence and curl of linear vector fields of the plane are exact in every face") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(9, 9, 1, 0.3));
    const FieldOnSurface radial(surface, vector_field(surface, 1, [](SpacePoint p) {
                                    return SpacePoint{2 * (p.x - 4.1), 2 * (p.y - 4.3), 0};
                                }));
    const FieldOnSurface turning(surface, vector_field(surface, 1, [](SpacePoint p) {
                                     return SpacePoint{-(p.y - 4.1), p.x - 4.3, 0};
                                 }));
    const FieldOnSurface saddle(surface, vector_field(surface, 1, [](SpacePoint p) {
                                    return SpacePoint{p.x - 4.1, -(p.y - 4.3), 0};
                                }));
    for (int f = 0; f < surface.faces(); ++f) {
        const SurfacePoint p = from_barycentric(surface, f, {0.2, 0.3, 0.5});
        CHECK(divergence(vector_gradient(radial, p, {1, 0})) == Approx(4));
        CHECK(curl(vector_gradient(radial, p, {1, 0})) == Approx(0).margin(1e-9));
        CHECK(divergence(vector_gradient(turning, p, {1, 0})) == Approx(0).margin(1e-9));
        CHECK(curl(vector_gradient(turning, p, {1, 0})) == Approx(2));
        CHECK(divergence(vector_gradient(saddle, p, {1, 0})) == Approx(0).margin(1e-9));
        CHECK(curl(vector_gradient(saddle, p, {1, 0})) == Approx(0).margin(1e-9));
    }
}

TEST_CASE(
    "turning about the axis of a sphere has the curl 2 cos and no divergence, and flowing down has the divergence -2 cos") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(4));
    const FieldOnSurface turning(surface, vector_field(surface, 1, [](SpacePoint p) { return cross({0, 0, 1}, p); }));
    const FieldOnSurface upward(surface, vector_field(surface, 1, [](SpacePoint p) {
                                    return SpacePoint{0, 0, 1} - p.z * p;
                                }));
    double curl_squares = 0, divergence_squares = 0, up_squares = 0;
    for (int f = 0; f < surface.faces(); ++f) {
        const SurfacePoint p = from_barycentric(surface, f, {1.0 / 3, 1.0 / 3, 1.0 / 3});
        const double z = unit(position_in_space(surface, p)).z;
        const VectorGradient gradient = vector_gradient(turning, p, {1, 0});
        curl_squares += std::pow(curl(gradient) - 2 * z, 2);
        divergence_squares += std::pow(divergence(gradient), 2);
        up_squares += std::pow(divergence(vector_gradient(upward, p, {1, 0})) + 2 * z, 2);
    }
    CHECK(std::sqrt(curl_squares / surface.faces()) < 0.03);
    CHECK(std::sqrt(divergence_squares / surface.faces()) < 0.03);
    CHECK(std::sqrt(up_squares / surface.faces()) < 0.03);
}

TEST_CASE("both eigenvector fields of a tensor field have their divergence and curl, of closed forms and of vertices") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(60, 60, 1.0 / 60, 0.2));
    const SurfaceField form{.n = 2, .exact = PlaneForm{true, {-0.4, -0.3}, 0}};
    const FieldOnSurface exact(surface, form);
    SurfaceField values = exact.field();
    values.exact.reset();
    const FieldOnSurface by_vertex(surface, values);
    Random random(8);
    for (int i = 0; i < 100; ++i) {
        const SurfacePoint p = random_surface_point(surface, random);
        const SpacePoint place = position_in_space(surface, p);
        const double r = std::hypot(place.x + 0.4, place.y + 0.3);
        const Complex along = root_near(exact.at(p), 2, {1, 0}), across = Complex{0, 1} * along;
        for (const auto& [field, error] : {std::pair{&exact, 1e-6}, std::pair{&by_vertex, 0.05}}) {
            // unit vectors away from a centre spread by 1 / r and turn not; those round about it turn by 1 / r
            const VectorGradient major = vector_gradient(*field, p, along), minor = turned_left(major);
            CHECK(std::abs(std::abs(divergence(major)) - 1 / r) < error);
            CHECK(std::abs(curl(major)) < error);
            CHECK(std::abs(divergence(minor)) < error);
            CHECK(std::abs(std::abs(curl(minor)) - 1 / r) < error);
            CHECK(std::abs(std::abs(streamline_curvature(minor, across)) - 1 / r) < error);
            CHECK(std::abs(streamline_curvature(major, along)) < error);
        }
        CHECK(divergence(vector_gradient(exact, p, -along)) == Approx(-divergence(vector_gradient(exact, p, along))));
    }
}

TEST_CASE("numbers at vertices have a gradient") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(5, 5, 1, 0.3));
    SurfaceField field{.n = 2, .exact = PlaneForm{}};
    for (const SpacePoint p : surface.mesh.positions) field.scalar.push_back(3 * p.x - p.y);
    const FieldOnSurface numbers(surface, field);
    for (int f = 0; f < surface.faces(); ++f) {
        const SurfacePoint p = from_barycentric(surface, f, {0.2, 0.3, 0.5});
        const SpacePoint slope = direction_in_space(surface, f, scalar_gradient(numbers, p));
        CHECK(abs(slope - SpacePoint{3, -1, 0}) < 1e-9);
        CHECK(abs(value_gradient(numbers, p).by_x) < 1e-9);
    }
}
