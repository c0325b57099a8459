#include "growth/surface/field_source.h"

#include <catch2/catch.hpp>

#include "growth/surface/field_filled.h"
#include "growth/surface/field_json.h"
#include "growth/surface/field_smooth.h"
#include "surface_shapes.h"

using namespace rinceau;

namespace {

using Numbers = std::map<std::string, double>;

/// The field that a source makes when every file holds `text`.
SurfaceField made(const SurfaceMesh& surface, const std::string& kind, const Numbers& numbers = {},
                  const std::string& text = {}) {
    const ReadNamedFile read = [&](const std::string&) { return text; };
    return make_field({.kind = kind, .text = text.empty() ? "" : "file.json", .numbers = numbers, .place = {"g.fgsg", 3, 5}},
                      surface, read);
}

SurfaceField random_tensors(const SurfaceMesh& surface, int n) {
    Random random(6);
    SurfaceField field{.n = n};
    for (int v = 0; v < surface.vertices(); ++v) {
        field.values.push_back(polar(random.uniform(0.1, 3), random.uniform(-pi, pi)));
        field.isotropic.push_back(random.uniform(-1, 1));
        field.scalar.push_back(random.uniform(0, 9));
    }
    return field;
}

}  // namespace

TEST_CASE("a field written as JSON reads back: to the bit by edges, to rounding in space") {
    const SurfaceMesh surface = surface_mesh(torus_triangles(12, 8, 2, 0.7));
    for (const int n : {1, 2, 4}) {
        const SurfaceField field = random_tensors(surface, n);
        const SurfaceField by_edge = read_field_json(field_json(field, surface, FieldFrame::edge), surface, "f.json");
        const SurfaceField in_space = read_field_json(field_json(field, surface, FieldFrame::space), surface, "f.json");
        CHECK(by_edge.n == n);
        CHECK(by_edge.values == field.values);
        CHECK(by_edge.isotropic == field.isotropic);
        CHECK(in_space.scalar == field.scalar);
        REQUIRE(in_space.values.size() == field.values.size());
        for (std::size_t v = 0; v < field.values.size(); ++v) CHECK(abs(in_space.values[v] - field.values[v]) < 1e-12);
    }
}

TEST_CASE("vectors in space mean the same on a surface whose faces are listed in another order") {
    TriangleMesh shape = torus_triangles(12, 8, 2, 0.7);
    const SurfaceMesh surface = surface_mesh(shape);
    const std::string text = field_json(random_tensors(surface, 2), surface, FieldFrame::space);
    std::reverse(shape.triangles.begin(), shape.triangles.end());
    const SurfaceMesh other = surface_mesh(shape);
    const SurfaceField here = read_field_json(text, surface, "f.json"), there = read_field_json(text, other, "f.json");
    CHECK(FieldOnSurface(surface, here).singular_faces().size() == FieldOnSurface(other, there).singular_faces().size());
}

TEST_CASE("numbers alone become a field with their gradient") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(3, 3, 1, 0.2));
    std::string list;
    for (const SpacePoint p : surface.mesh.positions) list += (list.empty() ? "" : ", ") + std::to_string(2 * p.x + p.y);
    const FieldOnSurface field(surface, read_field_json("{\"scalar\": [" + list + "]}", surface, "s.json"));
    Random random(1);
    for (int i = 0; i < 20; ++i) {
        const SurfacePoint p = random_surface_point(surface, random);
        const SpacePoint place = position_in_space(surface, p);
        CHECK(field.scalar_at(p) == Approx(2 * place.x + place.y).margin(1e-4));
        CHECK(abs(direction_in_space(surface, p.face, field.at(p)) - SpacePoint{2, 1, 0}) < 1e-4);
    }
}

TEST_CASE("field files that are wrong say what and where") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(1, 1, 1));
    const auto message = [&](const std::string& text) {
        try {
            read_field_json(text, surface, "f.json");
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    CHECK_THAT(message("{\"n\": 2,\n \"z\": [[1,0]"), Catch::StartsWith("f.json:2:"));
    CHECK_THAT(message("{\"n\": 3, \"z\": []}"), Catch::Contains("n: expected 1 (vectors)"));
    CHECK_THAT(message("{\"n\": 2, \"z\": [[1,0]]}"), Catch::Contains("1 values") && Catch::Contains("4 vertices"));
    CHECK_THAT(message("{\"z\": [[1,0],[1,0],[1,0],[1]]}"), Catch::Contains("z[3]: expected a list of 2 numbers"));
    CHECK_THAT(message("{\"z\": [[1,0],[1,0],[1,0],[1,null]]}"), Catch::Contains("z[3][1]: expected a number, found null"));
    CHECK_THAT(message("{\"z\": [[1,0],[1,0],[1,0],[1,1e200]]}"), Catch::Contains("vertex 3") && Catch::Contains("finite"));
    CHECK_THAT(message("{\"z\": [[1,0],[1,0],[1,0],[1,1e999]]}"), Catch::Contains("too large"));
    CHECK_THAT(message("{\"vectors\": [], \"frame\": \"edge\", \"zz\": 1}"), Catch::Contains("unknown key \"zz\""));
    CHECK_THAT(message("{\"n\": 2}"), Catch::Contains("\"vectors\", \"z\" or \"scalar\""));
    CHECK_THAT(message("[[[[[[[[[[[[1]]]]]]]]]]]]"), Catch::Contains("nested deeper"));
    CHECK_THAT(message("{\"scalar\": [1, 2, 3]}"), Catch::Contains("4 vertices"));
    CHECK_THAT(message("[1]"), Catch::Contains("expected an object"));
}

TEST_CASE("a design in JSON places its elements by vertex or place, turned by a vector or an angle") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(20, 20, 1));
    const std::string text = R"({"n": 2, "elements": [
        {"type": "regular", "at": [4.2, 9.9, 0], "direction": [0, 1, 0], "decay": 20},
        {"type": "regular", "vertex": 226, "angle": 30, "weight": 2, "decay": 20, "fall": "gauss"}]})";
    const FieldDesign design = read_field_design_json(text, surface, "vine.json");
    REQUIRE(design.elements.size() == 2);
    CHECK(design.elements[0].vertex == 10 * 21 + 4);
    CHECK(design.elements[1].gauss);
    const FieldOnSurface field(surface, made(surface, "elements", {}, text));
    const auto way_at = [&](int vertex) {
        const SurfacePoint p = at_vertex(surface, vertex);
        const SpacePoint way = direction_in_space(surface, p.face, root_near(field.at(p), 2, {1, 1}));
        return std::remainder(std::atan2(way.y, way.x), pi);
    };
    CHECK(std::abs(std::remainder(way_at(10 * 21 + 4) - pi / 2, pi)) < 1e-2);
    CHECK(std::abs(std::remainder(way_at(226) - radians(30), pi)) < 1e-2);
    const auto fails = [&](const std::string& design_text, const std::string& part) {
        CHECK_THROWS_WITH(read_field_design_json(design_text, surface, "vine.json"), Catch::Contains(part));
    };
    fails(R"([{"type": "wedge"}])", "[0]: expected either \"vertex\" or \"at\"");
    fails(R"([{"type": "vedge", "vertex": 1}])", "[0].type: expected one of regular, ");
    fails(R"([{"type": "wedge", "vertex": 441}])", "whole number from 0 to 440");
    fails(R"({"elements": [{"type": "wedge", "vertex": 1, "angel": 3}]})", "elements[0]: unknown key \"angel\"");
    fails(R"([{"type": "wedge", "vertex": 1, "angle": 3, "direction": [1, 0, 0]}])", "not both");
}

TEST_CASE("every kind of source makes a field, and smoothing applies to each") {
    const SurfaceMesh plane = surface_mesh(plane_triangles(6, 6, 1, 0.2)), sphere = surface_mesh(sphere_triangles(2));
    CHECK(made(plane, "constant", {{"angle", 30}}).exact->angle == Approx(radians(30)));
    CHECK(made(plane, "vortex", {{"x", 3}, {"y", 2}}).exact->centre == Point{3, 2});
    CHECK(made(plane, "spiral", {}).exact->angle == Approx(pi / 4));
    CHECK_FALSE(made(plane, "radial", {{"smooth", 0.1}}).exact);
    CHECK(made(sphere, "smoothest", {{"n", 4}}).n == 4);
    CHECK(made(sphere, "curvature").isotropic.size() == 162);
    const FieldOnSurface upwards(sphere, made(sphere, "direction", {{"z", 2}}));
    CHECK(upwards.index_sum() == 2);
    const SurfacePoint equator = at_vertex(sphere, 0);
    // seen from straight above the vertex: the face itself leans by some 9 degrees
    const SpacePoint normal = sphere.vertex_normal[0], lying = direction_in_space(sphere, equator.face, upwards.at(equator));
    const SpacePoint way = lying - dot(lying, normal) * normal, up = SpacePoint{0, 0, 1} - normal.z * normal;
    CHECK(dot(unit(way), unit(up)) > 0.9999);
    for (const std::string& kind : field_source_kinds()) CHECK_THROWS_AS(made(sphere, kind, {{"smoth", 1}}), InputError);
}

TEST_CASE("sources that make no sense are refused at their place") {
    const SurfaceMesh sphere = surface_mesh(sphere_triangles(1));
    const auto fails = [&](const std::string& kind, const Numbers& numbers, const std::string& part) {
        CHECK_THROWS_WITH(made(sphere, kind, numbers), Catch::StartsWith("g.fgsg:3:5") && Catch::Contains(part));
    };
    fails("wavy", {}, "expected the kind of a field, found 'wavy': there is elements, file");
    fails("smoothest", {{"sigma", 2}}, "has no sigma");
    fails("smoothest", {{"n", 3}}, "expected 1, 2 or 4");
    fails("smoothest", {{"rounds", 1.5}}, "rounds is no whole number");
    fails("curvature", {{"smooth", -1}}, "below 0");
    fails("direction", {}, "not all 0");
    fails("file", {}, "the name of a file");
    CHECK_THROWS_WITH(FieldOnSurface(sphere, made(sphere, "radial")), Catch::Contains("not flat"));
    CHECK_THROWS_WITH(made(sphere, "image", {}, "no png"), Catch::Contains("expected a PNG picture"));
}
