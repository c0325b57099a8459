#include <catch2/catch.hpp>

#include "growth/surface/parse_shape_grammar.h"
#include "growth/surface/surface_world.h"
#include "surface_shapes.h"

using namespace rinceau;

TEST_CASE("without a surface a grammar grows on a piece of the plane about the origin") {
    const SurfaceWorld usual = make_world(parse_shape_grammar("axiom vertex 0 Rz(1)"), nullptr, {});
    CHECK(usual.plane);
    CHECK(usual.surface->area == Approx(1));
    CHECK(usual.surface->diagonal == Approx(std::sqrt(2)));
    const ShapeGrammar wide =
        parse_shape_grammar("param w = 6\noption plane = w height = 2 cells = 30\naxiom vertex 0 Rz(1)");
    const SurfaceWorld world = make_world(wide, nullptr, {});
    CHECK(world.surface->area == Approx(12));
    CHECK(world.surface->faces() == 2 * 30 * 10);
    CHECK(world.surface->border_edges == 2 * (30 + 10));
    for (const auto& frame : world.surface->frame) CHECK(frame[2].z == Approx(1));
    const auto [low, high] = bounds(world.surface->mesh);
    CHECK(low == SpacePoint{-3, -1, 0});
    CHECK(high == SpacePoint{3, 1, 0});
}

TEST_CASE("settings may name params and the surface's size") {
    const ShapeGrammar grammar = parse_shape_grammar(
        "param a = 1/diagonal\nshape s = disc height = a*2\nfield F = constant angle = 10*area n = 2\n"
        "axiom vertex 0 I(\"s\")");
    const SurfaceWorld world =
        make_world(grammar, std::make_shared<const SurfaceMesh>(surface_mesh(plane_triangles(4, 3, 1))), {});
    CHECK(!world.plane);
    REQUIRE(world.shapes.size() == 1);
    CHECK(world.shapes[0].high.z - world.shapes[0].low.z == Approx(2.0 / 5));
    REQUIRE(world.fields.size() == 1);
    const double angle = arg(world.fields[0].field->field().values.at(0)) / 2;  // up to the vertex's own frame
    CHECK(std::isfinite(angle));
    CHECK(world.fields[0].name == "F");
}

TEST_CASE("params are set by name, and what is none is named with what was perhaps meant") {
    const ShapeGrammar grammar =
        parse_shape_grammar("param size = 1\nparam twice = 2*size\naxiom vertex 0 Rz(twice)", "x.fgsg");
    const ShapeGrammar other = with_params(grammar, {{"size", parse_expression("3 + 4")}});
    CHECK(param_values(other) == std::vector<double>{7, 14});
    CHECK_THROWS_WITH(with_params(grammar, {{"sise", number_expression(1)}}),
                      Catch::Matchers::Contains("did you mean 'size'?"));
}

TEST_CASE("planes that cannot be are refused at their option") {
    for (const char* option : {"option plane = -1", "option plane = 0", "option plane = 1 cells = 0.5",
                               "option plane = 1 cells = 1e6", "option plane = wide", "option plane = 1 depth = 3"}) {
        CAPTURE(option);
        CHECK_THROWS_AS(plane_piece(parse_shape_grammar(option)), InputError);
    }
}

TEST_CASE("a field's settings are numbers") {
    const ShapeGrammar grammar = parse_shape_grammar("field F = constant angle = steep\naxiom vertex 0 Rz(1)");
    CHECK_THROWS_WITH(make_world(grammar, nullptr, {}), Catch::Matchers::Contains("steep"));
}
