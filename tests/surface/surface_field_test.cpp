#include "growth/surface/surface_field.h"

#include <catch2/catch.hpp>
#include <limits>

#include "growth/surface/field_filled.h"
#include "scene/input_error.h"
#include "surface_shapes.h"

using namespace rinceau;

namespace {

SurfaceField random_field(const SurfaceMesh& surface, int n, std::uint64_t seed) {
    Random random(seed);
    SurfaceField field{.n = n};
    for (int v = 0; v < surface.vertices(); ++v)
        field.values.push_back(polar(random.uniform(0.2, 1), random.uniform(-pi, pi)));
    return field;
}

/// A box of sharp corners: 12 faces, three squares at every vertex.
TriangleMesh box_triangles() {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) mesh.positions.push_back({1.0 * (i & 1), 1.0 * (i >> 1 & 1), 1.0 * (i >> 2)});
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

/// A thin needle: its tip's corners sum to much less than half a turn.
TriangleMesh needle_triangles() {
    TriangleMesh mesh;
    mesh.positions = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 8}, {0, 0, -1}};
    for (int i = 0; i < 4; ++i) {
        mesh.triangles.push_back({i, (i + 1) % 4, 4});
        mesh.triangles.push_back({(i + 1) % 4, i, 5});
    }
    return mesh;
}

std::vector<TriangleMesh> closed_shapes() {
    return {sphere_triangles(2), torus_triangles(16, 10, 2, 0.7), box_triangles(), needle_triangles()};
}

double largest_jump(const SurfaceMesh& surface, const FieldOnSurface& field) {
    double largest = 0;
    for (int h = 0; h < 3 * surface.faces(); ++h) {
        const int twin = surface.twin[static_cast<std::size_t>(h)];
        if (twin < 0) continue;
        for (const double share : {0.0, 0.01, 0.3, 0.5, 0.9}) {
            const auto on = [&](int edge, double s) {
                std::array<double, 3> weights{};
                weights[static_cast<std::size_t>(edge % 3)] = 1 - s;
                weights[static_cast<std::size_t>(next_in_face(edge) % 3)] = s;
                return from_barycentric(surface, face_of(edge), weights);
            };
            if (share == 0) continue;  // the direction at a vertex is that of a way to it
            const Complex here = field.at(on(h, share)), there = field.at(on(twin, 1 - share));
            const Complex carried = here * power(surface.across[static_cast<std::size_t>(h)], field.n());
            largest = std::max(largest, abs(carried - there));
        }
    }
    return largest;
}

}  // namespace

TEST_CASE("a field is continuous over every edge, at sharp corners too") {
    for (const TriangleMesh& shape : closed_shapes()) {
        const SurfaceMesh surface = surface_mesh(shape);
        for (const int n : {1, 2, 4}) {
            const FieldOnSurface field(surface, random_field(surface, n, 5));
            CHECK(largest_jump(surface, field) < 1e-12);
        }
    }
    const SurfaceMesh open = surface_mesh(cylinder_triangles(9, 4, 1, 2));
    CHECK(largest_jump(open, FieldOnSurface(open, random_field(open, 2, 5))) < 1e-12);
}

TEST_CASE("the indices of any field on a closed surface sum to its Euler characteristic") {
    for (const TriangleMesh& shape : closed_shapes()) {
        const SurfaceMesh surface = surface_mesh(shape);
        for (const int n : {1, 2, 4})
            for (std::uint64_t seed = 0; seed < 20; ++seed) {
                const FieldOnSurface field(surface, random_field(surface, n, seed));
                CHECK(field.index_sum() == n * euler_characteristic(surface));
            }
    }
}

TEST_CASE("indices sum exactly where turns are ties at half a turn, and where values are 0") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(3));
    for (const int n : {1, 2, 4}) {
        SurfaceField alternating{.n = n}, patches{.n = n};
        for (int v = 0; v < surface.vertices(); ++v) {
            alternating.values.push_back({v % 2 == 0 ? 1.0 : -1.0, 0});
            const SpacePoint p = surface.mesh.positions[static_cast<std::size_t>(v)];
            patches.values.push_back(p.z > 0.2 ? Complex{} : polar(1, 3.0 * v));
        }
        CHECK(FieldOnSurface(surface, alternating).index_sum() == 2 * n);
        CHECK(FieldOnSurface(surface, patches).index_sum() == 2 * n);
        CHECK(FieldOnSurface(surface, {.n = n, .values = std::vector<Complex>(alternating.values.size())}).index_sum() ==
              2 * n);
    }
}

TEST_CASE("vertices without a direction take that of their neighbours, weakly") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(8, 8, 1, 0.2));
    SurfaceField constant{.exact = PlaneForm{.angle = 0.7}};
    constant.values = filled_field(surface, constant).values;
    constant.exact.reset();
    for (const int v : {20, 21, 22, 30, 31, 40}) constant.values[static_cast<std::size_t>(v)] = {};
    const FieldOnSurface field(surface, constant), exact(surface, {.exact = PlaneForm{.angle = 0.7}});
    CHECK(field.singular_faces().empty());
    for (int v = 0; v < surface.vertices(); ++v) {
        const Complex filled = field.field().values[static_cast<std::size_t>(v)];
        const Complex expected = exact.field().values[static_cast<std::size_t>(v)];
        CHECK(abs(filled / abs(filled) - expected) < 1e-9);
        CHECK((abs(filled) == Approx(1) || abs(filled) == Approx(1e-6)));
    }
}

TEST_CASE("values at the vertices of a plane give a constant field exactly, in every face's frame") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(7, 5, 0.5, 0.3));
    for (const int n : {1, 2, 4}) {
        SurfaceField by_vertex{.n = n, .exact = PlaneForm{.angle = 0.4}};
        const FieldOnSurface exact(surface, by_vertex);
        by_vertex.values = exact.field().values;
        by_vertex.exact.reset();
        const FieldOnSurface field(surface, by_vertex);
        Random random(2);
        for (int i = 0; i < 200; ++i) {
            const SurfacePoint p = random_surface_point(surface, random);
            CHECK(abs(field.at(p) - exact.at(p)) < 1e-12);
            const Complex axis = root_near(exact.at(p), n, {1, 0});
            const SpacePoint way = direction_in_space(surface, p.face, axis);
            CHECK(std::abs(std::remainder(std::atan2(way.y, way.x) - 0.4, two_pi / n)) < 1e-12);
        }
    }
}

TEST_CASE("radial, spiral and vortex fields point away from their centre at their angle, and are singular there") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(9, 9, 1, 0.3));
    const Point centre{4.3, 5.6};
    for (const double angle : {0.0, 0.6, pi / 2}) {
        const FieldOnSurface field(surface, {.n = 1, .exact = PlaneForm{true, centre, angle}});
        REQUIRE(field.singular_faces().size() == 1);
        const int face = field.singular_faces().front();
        CHECK(field.index(face) == 1);
        const SpacePoint zero = position_in_space(surface, {face, field.zero(face)});
        CHECK(std::hypot(zero.x - centre.x, zero.y - centre.y) < 1e-12);
        Random random(2);
        for (int i = 0; i < 100; ++i) {
            const SurfacePoint p = random_surface_point(surface, random);
            const SpacePoint place = position_in_space(surface, p), way = direction_in_space(surface, p.face, field.at(p));
            const Complex ray{place.x - centre.x, place.y - centre.y};
            CHECK(abs(Complex{way.x, way.y} - ray / abs(ray) * polar(1, angle)) < 1e-12);
        }
    }
}

TEST_CASE("a face with an index has its zero where the field is zero") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(3));
    int found = 0;
    for (const int n : {1, 2, 4}) {
        const FieldOnSurface field(surface, random_field(surface, n, 11));
        for (const int face : field.singular_faces()) {
            const auto weights = barycentric(surface, {face, field.zero(face)});
            for (const double w : weights) CHECK(w >= -1e-12);
            CHECK(abs(field.at({face, field.zero(face)})) < 1e-6);
            ++found;
        }
    }
    CHECK(found > 500);
}

TEST_CASE("the n-th root is the one nearest to a direction") {
    Random random(4);
    for (const int n : {1, 2, 4})
        for (int i = 0; i < 500; ++i) {
            const Complex near = polar(1, random.uniform(-pi, pi));
            const double angle = random.uniform(-pi, pi);
            const Complex z = polar(random.uniform(0.1, 9), n * angle), root = root_near(z, n, near);
            CHECK(abs(power(root, n) - z / abs(z)) < 1e-14);
            if (n > 1) CHECK(std::abs(arg(root * conj(near))) < pi / n + 1e-12);
        }
    CHECK(abs(root_near(polar(1, pi - 1e-12), 2, {0, 1}) - polar(1, (pi - 1e-12) / 2)) < 1e-15);
    CHECK(root_near({}, 2, {0, 2}) == Complex{0, 1});
}

TEST_CASE("numbers at vertices are interpolated beside the directions") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(4, 4, 1, 0.2));
    SurfaceField field{.n = 2, .exact = PlaneForm{}};
    for (const SpacePoint p : surface.mesh.positions) field.scalar.push_back(3 * p.x - p.y);
    field.isotropic = field.scalar;
    const FieldOnSurface with_numbers(surface, field);
    Random random(9);
    for (int i = 0; i < 50; ++i) {
        const SurfacePoint p = random_surface_point(surface, random);
        const SpacePoint place = position_in_space(surface, p);
        CHECK(with_numbers.scalar_at(p) == Approx(3 * place.x - place.y));
        CHECK(with_numbers.isotropic_at(p) == Approx(3 * place.x - place.y));
    }
    field.scalar.clear();
    CHECK(FieldOnSurface(surface, field).scalar_at({0, {0.1, 0.1}}) == Approx(1));
}

TEST_CASE("fields that do not fit their surface are refused with the reason") {
    const SurfaceMesh plane = surface_mesh(plane_triangles(2, 2, 1)), sphere = surface_mesh(sphere_triangles(1));
    const std::vector<Complex> nine(9, Complex{1, 0});
    auto broken = nine;
    broken[4].y = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(FieldOnSurface(sphere, {.values = nine, .label = "f.json"}),
                      Catch::Contains("f.json") && Catch::Contains("9 values") && Catch::Contains("42 vertices"));
    CHECK_THROWS_WITH(FieldOnSurface(plane, {.values = broken}), Catch::Contains("vertex 4"));
    CHECK_THROWS_WITH(FieldOnSurface(plane, {.n = 3, .values = nine}), Catch::Contains("n = 3"));
    CHECK_THROWS_WITH(FieldOnSurface(plane, {.values = nine, .isotropic = {1, 2}}), Catch::Contains("isotropic"));
    CHECK_THROWS_WITH(FieldOnSurface(sphere, {.exact = PlaneForm{}}), Catch::Contains("not flat"));
}
