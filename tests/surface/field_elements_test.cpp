#include "growth/surface/field_elements.h"

#include <catch2/catch.hpp>

#include "growth/surface/vertex_axes.h"
#include "scene/input_error.h"
#include "surface_shapes.h"

using namespace rinceau;

namespace {

/// n * index of all faces within `reach` of a vertex; the others must have none.
int index_about(const SurfaceMesh& surface, const FieldOnSurface& field, int vertex, double reach) {
    int sum = 0;
    for (const int face : field.singular_faces()) {
        const SpacePoint place = position_in_space(surface, {face, field.zero(face)});
        if (abs(place - surface.mesh.positions[static_cast<std::size_t>(vertex)]) > reach) return 1000;
        sum += field.index(face);
    }
    return sum;
}

constexpr int middle_of_20 = 10 * 21 + 10;  ///< vertex of plane_triangles(20, 20, ..)

}  // namespace

TEST_CASE("every element on a plane has its index, at its vertex and nowhere else, whichever way it is turned") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(20, 20, 1, 0.25));
    struct Case {
        int n;
        const char* name;
        int index;  // n * index
    };
    const std::vector<Case> cases{{1, "regular", 0}, {1, "source", 1},        {1, "sink", 1},    {1, "centre", 1},
                                  {1, "saddle", -1}, {2, "regular", 0},       {2, "wedge", 1},   {2, "trisector", -1},
                                  {2, "node", 2},    {2, "centre", 2},        {2, "saddle", -2}, {4, "regular", 0},
                                  {4, "quarter", 1}, {4, "minus-quarter", -1}};
    for (const auto& [n, name, index] : cases)
        for (const double direction : {0.0, 0.9, -2.0})
            for (const bool gauss : {false, true}) {
                CAPTURE(n, name, direction, gauss);
                const FieldElement element{*field_element_kind(name), middle_of_20, direction, 0, 1, 3, gauss};
                const FieldOnSurface field(surface, field_of_elements(surface, n, {element}, "test"));
                CHECK(index_about(surface, field, middle_of_20, 1.6) == index);
            }
}

TEST_CASE("on a plane an element says exactly what its formula says") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(20, 20, 1, 0.25));
    const SpacePoint middle = surface.mesh.positions[middle_of_20];
    struct Case {
        int n;
        FieldElementKind kind;
        double angle_per_way, turn;  // field angle = angle_per_way * (way - direction) + direction + turn
    };
    for (const auto& [n, kind, share, turn] :
         {Case{2, FieldElementKind::regular, 0, 0}, Case{2, FieldElementKind::wedge, 0.5, 0},
          Case{2, FieldElementKind::trisector, -0.5, 0}, Case{2, FieldElementKind::node, 1, 0},
          Case{2, FieldElementKind::centre, 1, pi / 2}, Case{2, FieldElementKind::saddle, -1, 0},
          Case{1, FieldElementKind::sink, 1, pi}, Case{4, FieldElementKind::quarter, 0.25, 0}}) {
        const double way_of_x = direction_at_vertex(surface, middle_of_20, {1, 0, 0}), direction = 0.7;
        const FieldElement element{kind, middle_of_20, way_of_x + direction};
        const SurfaceField field = field_of_elements(surface, n, {element}, "test");
        for (int v = 0; v < surface.vertices(); ++v) {
            if (v == middle_of_20) continue;
            const SpacePoint ray = surface.mesh.positions[static_cast<std::size_t>(v)] - middle;
            const double way = std::atan2(ray.y, ray.x), angle = share * (way - direction) + direction + turn;
            const Complex z = field.values[static_cast<std::size_t>(v)];
            const Complex x_axis = polar(1, direction_at_vertex(surface, v, {1, 0, 0}));
            CHECK(abs(z) == Approx(std::exp(-3 * abs(ray) / surface.diagonal)).epsilon(1e-6));
            CHECK(std::abs(wrap_angle(arg(z) - n * (arg(x_axis) + angle))) < 1e-6);
        }
    }
}

TEST_CASE("a node at a pole of the sphere leads along the meridians, a centre along the parallels") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(4));
    const int pole = nearest_vertex(surface, {0, 0, 1});
    const SpacePoint north = surface.mesh.positions[static_cast<std::size_t>(pole)];
    for (const bool round : {false, true}) {
        const FieldElement element{round ? FieldElementKind::centre : FieldElementKind::node, pole};
        const SurfaceField field = field_of_elements(surface, 2, {element}, "test");
        double largest = 0, sum = 0;
        int count = 0;
        for (int v = 0; v < surface.vertices(); ++v) {
            const SpacePoint p = surface.mesh.positions[static_cast<std::size_t>(v)];
            if (dot(p, north) > 0.98 || dot(p, north) < -0.2) continue;  // beyond, the rays meet again
            const SpacePoint east = unit(cross(north, p)), south = cross(east, p);
            const double expected = direction_at_vertex(surface, v, round ? east : south);
            const double off = std::abs(wrap_angle(arg(field.values[static_cast<std::size_t>(v)]) - 2 * expected)) / 2;
            largest = std::max(largest, off);
            sum += off;
            ++count;
        }
        CHECK(degrees(sum / count) < 0.3);
        CHECK(degrees(largest) < 1.5);
        const FieldOnSurface whole(surface, field);
        CHECK(whole.index_sum() == 4);
    }
}

TEST_CASE("several elements share the surface by their distance and weight") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(20, 20, 1));
    const int left = 10 * 21 + 4, right = 10 * 21 + 16, middle = 10 * 21 + 10;
    const double up = direction_at_vertex(surface, left, {0, 1, 0});
    const FieldElement upwards{FieldElementKind::regular, left, up, 0, 1, 20};
    const FieldElement along{FieldElementKind::regular, right, direction_at_vertex(surface, right, {1, 0, 0}), 0, 2, 20};
    const SurfaceField field = field_of_elements(surface, 2, {upwards, along}, "test");
    const auto way = [&](int v) {
        const Complex z = field.values[static_cast<std::size_t>(v)];
        return from_vertex_to_space(surface, vertex_axis(surface, v), v, polar(abs(z), arg(z) / 2));
    };
    CHECK(std::abs(way(left).y) == Approx(1).epsilon(0.01));
    CHECK(std::abs(way(right).x) == Approx(2).epsilon(0.01));
    CHECK(std::abs(way(middle).x) > 0);  // twice the weight wins half-way
    CHECK(std::abs(way(middle).y) < 1e-6);
}

TEST_CASE("a direction in space comes back from a vertex's frame, and angle 0 is the way of +x") {
    const SurfaceMesh surface = surface_mesh(torus_triangles(24, 12, 2, 0.7));
    for (int v = 0; v < surface.vertices(); ++v) {
        const SpacePoint axis = vertex_axis(surface, v), normal = surface.vertex_normal[static_cast<std::size_t>(v)];
        const SpacePoint wanted{0.3, -0.2, 0.9}, tangent = wanted - dot(wanted, normal) * normal;
        const SpacePoint back = from_vertex_to_space(surface, axis, v, from_space_to_vertex(surface, axis, v, wanted));
        CHECK(abs(back - tangent) < 1e-12);
        if (std::abs(normal.x) > 0.9) continue;
        const SpacePoint zero = from_vertex_to_space(surface, axis, v, polar(1, reference_direction(surface, v)));
        CHECK(dot(zero, unit(SpacePoint{1, 0, 0} - normal.x * normal)) == Approx(1));
    }
}

TEST_CASE("elements that make no sense are refused by their number") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(2, 2, 1));
    const auto make = [&](int n, std::vector<FieldElement> elements) {
        field_of_elements(surface, n, elements, "vine.json");
    };
    CHECK_THROWS_WITH(make(2, {}), Catch::Contains("vine.json") && Catch::Contains("at least one element"));
    CHECK_THROWS_WITH(make(2, {{FieldElementKind::wedge, 0}, {FieldElementKind::source, 0}}),
                      Catch::Contains("element 2") && Catch::Contains("\"source\"") && Catch::Contains("wedge, trisector"));
    CHECK_THROWS_WITH(make(2, {{FieldElementKind::wedge, 9}}), Catch::Contains("no vertex 9"));
    CHECK_THROWS_WITH(make(2, {{FieldElementKind::wedge, 0, 0, 0, -1}}), Catch::Contains("weight"));
    CHECK_THROWS_WITH(make(2, {{FieldElementKind::wedge, 0, 0, 0, 1, 0}}), Catch::Contains("decay"));
    CHECK_FALSE(field_element_kind("spiral"));
    CHECK(field_element_kind("center") == FieldElementKind::centre);
}
