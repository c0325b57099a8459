#include "growth/surface/grow_drawing.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "geometry/angle.h"
#include "lsystem/grammar_text.h"
#include "tests/surface/surface_directions.h"
#include "tests/surface/surface_shapes.h"

using namespace rinceau;

namespace {

SpacePoint corner(const NamedMesh& mesh, std::size_t t, std::size_t k) {
    return mesh.mesh.positions[static_cast<std::size_t>(mesh.mesh.triangles[t][k])];
}

double area(const std::vector<NamedMesh>& meshes) {
    double sum = 0;
    for (const NamedMesh& mesh : meshes)
        for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t)
            sum += 0.5 * abs(cross(corner(mesh, t, 1) - corner(mesh, t, 0), corner(mesh, t, 2) - corner(mesh, t, 0)));
    return sum;
}

/// Triangles that look into the surface, where `outside` is a point's outward direction.
template <class Outside>
long turned_over(const std::vector<NamedMesh>& meshes, Outside outside) {
    long count = 0;
    for (const NamedMesh& mesh : meshes)
        for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
            const SpacePoint normal =
                cross(corner(mesh, t, 1) - corner(mesh, t, 0), corner(mesh, t, 2) - corner(mesh, t, 0));
            constexpr double no_area = 1e-14;
            count += abs(normal) > no_area && dot(normal, outside(corner(mesh, t, 0))) < 0;
        }
    return count;
}

const char* const leaves = R"(lsystem 1
canvas -10 -10 20 20
axiom: +(20) Row(4) | *(0.7) -(35) Row(3)
Row(m) : m > 0 -> [+(40) Leaf] f(3) | *(0.9) +(25) Row(m-1)
style 1: fill #20a040; stroke #104020; stroke-width 0.1
terminal Leaf: style 1; path "M0 0C1 -1 1 -2 0 -3C-0.5 -2 -0.5 -1 0 0Z"
)";

const char* const ring = R"(lsystem 1
canvas -10 -10 20 20
axiom: Ring(12)
Ring(m) : m > 0 -> [f(4) Tile] +(30) Ring(m-1)
style 1: fill #a02040
terminal Tile: style 1; path "M-0.7 -0.7L0.7 -0.7L0.7 0.7L-0.7 0.7Z"
)";

SurfacePoint nearest_vertex(const SurfaceMesh& surface, SpacePoint p) {
    int best = 0;
    for (int v = 1; v < surface.vertices(); ++v)
        if (abs(surface.mesh.positions[static_cast<std::size_t>(v)] - p) <
            abs(surface.mesh.positions[static_cast<std::size_t>(best)] - p))
            best = v;
    return at_vertex(surface, best);
}

}  // namespace

TEST_CASE("On a flat mesh the turtle goes where it goes in the plane, mirrored and scaled too") {
    const SurfaceMesh plane = surface_mesh(plane_triangles(20, 20, 1, 0.3));
    const TurtleScript script = turtle_script(parse_grammar(leaves), {}, 1000);
    TurtleWays ways;
    ways.scale = 0.4;
    const SurfacePoint start = nearest_vertex(plane, {10, 10, 0});
    const SpacePoint origin = position_in_space(plane, start);
    const auto& frame = plane.frame[static_cast<std::size_t>(start.face)];
    // the drawing's x along the mesh's
    SurfaceTurtle turtle(plane, ways, {start, Complex{frame[0].x, frame[1].x}, {}});
    std::size_t placed = 0;
    for (const TurtleDeed& deed : script.deeds) {
        if (deed.kind == TurtleEventKind::pushed) turtle.push();
        if (deed.kind == TurtleEventKind::popped) turtle.pop();
        if (deed.kind == TurtleEventKind::moved) REQUIRE(turtle.move(deed.to));
        if (deed.kind != TurtleEventKind::placed) continue;
        const Point drawn = script.elements[placed++].pose.translation;
        const SpacePoint p = position_in_space(plane, turtle.stand().at);
        CHECK(std::abs(p.x - origin.x - ways.scale * drawn.x) < 1e-10);
        CHECK(std::abs(p.y - origin.y - ways.scale * drawn.y) < 1e-10);
    }
    CHECK(placed == 7);
}

TEST_CASE("On a flat mesh laid areas are those of the drawing, at the height of their rank, with and without groups") {
    const SurfaceMesh plane = surface_mesh(plane_triangles(24, 24, 1, 0.3));
    GrowDrawingOptions options;
    options.scale = 0.5;
    options.start = nearest_vertex(plane, {12, 12, 0});
    for (const LayGroups lay : {LayGroups::automatic, LayGroups::never}) {
        options.lay = lay;
        const GrownDrawing grown = grow_drawing(parse_grammar(ring), plane, nullptr, options);
        CHECK(grown.laid == 12);
        CHECK(area(grown.pattern.laid) == Approx(12 * 1.96 * 0.25).epsilon(1e-9));
        for (const NamedMesh& mesh : grown.pattern.laid)
            for (const SpacePoint& p : mesh.mesh.positions) CHECK(std::abs(p.z - 1e-5 * plane.diagonal) < 1e-9);
    }
}

TEST_CASE("A closed ring laid through one chart on a sphere is regular, and none of it is turned over") {
    const SurfaceMesh sphere = surface_mesh(sphere_triangles(4));
    GrowDrawingOptions options;
    options.scale = 0.1;
    options.start = nearest_vertex(sphere, {0, 0, 1});
    const GrownDrawing grown = grow_drawing(parse_grammar(ring), sphere, nullptr, options);
    REQUIRE(grown.laid == 12);
    CHECK(turned_over(grown.pattern.laid, [](SpacePoint p) { return p; }) == 0);
    // every tile has the same area but for the chart's stretch, which is the same around the middle
    CHECK(area(grown.pattern.laid) == Approx(12 * 0.0196).epsilon(0.06));
}

TEST_CASE("A ring walked by the turtle on a sphere misses its begin by pi K r^3") {
    const SurfaceMesh sphere = surface_mesh(sphere_triangles(5));
    constexpr int sides = 12;
    constexpr double radius = 0.2, side = 2 * 0.2 * 0.25881904510252074;  // 2 r sin(15 degrees)
    TurtleWays ways;
    const SurfacePoint start = nearest_vertex(sphere, {0, 0, 1});
    DrawingStand stand{start, {1, 0}, {}};
    const SpacePoint begin = position_in_space(sphere, start);
    for (int k = 0; k < sides; ++k) {
        const Point to = stand.drawn + polar(side, two_pi * k / sides);
        const auto next = moved(sphere, ways, stand, to);
        REQUIRE(next);
        stand = *next;
    }
    CHECK(abs(stand.drawn) < 1e-12);
    CHECK(abs(position_in_space(sphere, stand.at) - begin) == Approx(pi * radius * radius * radius).epsilon(0.1));
}

TEST_CASE("Elements as large as the radius of curvature lie without a fold, and what cannot is dropped and told") {
    const auto disc = [](double radius) {
        const std::string r = std::to_string(radius);
        return parse_grammar(
            "lsystem 1\ncanvas -9 -9 18 18\naxiom: Disc Dot\nstyle 1: fill #336699\nterminal Disc: style 1; path \"M" + r +
            " 0A" + r + " " + r + " 0 1 0 -" + r + " 0A" + r + " " + r + " 0 1 0 " + r +
            " 0Z\"\nterminal Dot: style 0; path \"M8 8L8.1 8L8.1 8.1Z\"\n");
    };
    const SurfaceMesh sphere = surface_mesh(sphere_triangles(4));
    GrowDrawingOptions options;
    options.scale = 1;
    options.start = nearest_vertex(sphere, {0, 0, 1});
    const GrownDrawing good = grow_drawing(disc(1), sphere, nullptr, options);
    CHECK(turned_over(good.pattern.laid, [](SpacePoint p) { return p; }) == 0);
    CHECK(good.shrunk == 0);
    CHECK(area(good.pattern.laid) == Approx(pi).epsilon(0.12));
    const GrownDrawing bad = grow_drawing(disc(6), sphere, nullptr, options);
    CHECK(bad.dropped + bad.stopped >= 1);
    CHECK(turned_over(bad.pattern.laid, [](SpacePoint p) { return p; }) == 0);
    const SurfaceMesh torus = surface_mesh(torus_triangles(64, 32, 2, 0.8));
    options.start = nearest_vertex(torus, {2.8, 0, 0});
    const GrownDrawing on_torus = grow_drawing(disc(0.8), torus, nullptr, options);
    CHECK(on_torus.laid >= 1);
    CHECK(turned_over(on_torus.pattern.laid, [](SpacePoint p) {
              const double r = std::hypot(p.x, p.y);
              return p - SpacePoint{2 * p.x / r, 2 * p.y / r, 0};
          }) == 0);
}

TEST_CASE("A row that comes round to its begin stops there, unless it may meet itself") {
    const SurfaceMesh tube = surface_mesh(cylinder_triangles(48, 8, 1, 1.5));
    const Grammar row = parse_grammar(R"(lsystem 1
canvas 0 0 40 40
axiom: -(90) Row(40)
Row(m) : m > 0 -> Tile f(1) Row(m-1)
style 1: fill #336699
terminal Tile: style 1; path "M-0.4 -0.4L0.4 -0.4L0.4 0.4L-0.4 0.4Z"
)");
    GrowDrawingOptions options;
    options.scale = two_pi / 24.3;
    options.start = nearest_vertex(tube, {1, 0, 0.75});
    options.heading = 90;  // the drawing's up along the tube
    const GrownDrawing once = grow_drawing(row, tube, nullptr, options);
    options.meet_itself = true;
    const GrownDrawing over = grow_drawing(row, tube, nullptr, options);
    CHECK(over.laid == 40);
    CHECK(once.laid == 24);
    CHECK(once.stopped > 0);
}

TEST_CASE("A branch ends at a border, and what was laid lies whole on the surface") {
    const SurfaceMesh plane = surface_mesh(plane_triangles(10, 10, 1, 0.2));
    GrowDrawingOptions options;
    options.scale = 1;
    options.start = nearest_vertex(plane, {5, 5, 0});
    const GrownDrawing grown = grow_drawing(parse_grammar(R"(lsystem 1
canvas 0 0 40 40
axiom: Row(20)
Row(m) : m > 0 -> Tile f(1) Row(m-1)
style 1: fill #336699
terminal Tile: style 1; path "M-0.4 -0.4L0.4 -0.4L0.4 0.4L-0.4 0.4Z"
)"),
                                            plane, nullptr, options);
    CHECK(grown.laid > 3);
    CHECK(grown.laid < 7);
    CHECK(area(grown.pattern.laid) == Approx(0.64 * static_cast<double>(grown.laid)).epsilon(1e-9));
}

TEST_CASE("Walls stand on the surface and raise the element by the height") {
    const SurfaceMesh plane = surface_mesh(plane_triangles(10, 10, 1, 0.2));
    GrowDrawingOptions options;
    options.scale = 1;
    options.height = 0.5;
    options.start = nearest_vertex(plane, {5, 5, 0});
    const GrownDrawing grown =
        grow_drawing(parse_grammar("lsystem 1\ncanvas 0 0 9 9\naxiom: Tile\nstyle 1: fill #336699\nterminal "
                                   "Tile: style 1; path \"M-1 -1L1 -1L1 1L-1 1Z\"\n"),
                     plane, nullptr, options);
    CHECK(area(grown.pattern.laid) == Approx(4 + 8 * 0.5).epsilon(1e-9));
}

TEST_CASE("A lattice along a field on a torus lies without gaps, and its neighbours keep their distance") {
    const SurfaceMesh torus = surface_mesh(torus_triangles(64, 32, 2, 0.8));
    const Grammar lattice = parse_grammar(R"(lsystem 1
canvas -1 -1 12 12
axiom: Row(6)
Row(m) : m > 0 -> [Tiles(6)] -(90) f(2) +(90) Row(m-1)
Tiles(m) : m > 0 -> Tile f(2) Tiles(m-1)
style 1: fill #a02040
terminal Tile: style 1; path "M-0.95 -0.95L0.95 -0.95L0.95 0.95L-0.95 0.95Z"
)");
    GrowDrawingOptions options;
    options.scale = 0.12;
    options.start = nearest_vertex(torus, {2.8, 0, 0});
    const FieldOnSurface field(torus, field_of_directions(torus, 4, [](SpacePoint p) {
                                   const double r = std::hypot(p.x, p.y);
                                   const SpacePoint middle{2 * p.x / r, 2 * p.y / r, 0};
                                   return DirectionAndNormal{{-p.y / r, p.x / r, 0}, unit(p - middle)};
                               }));
    const GrownDrawing grown = grow_drawing(lattice, torus, &field, options);
    CHECK(grown.laid == 36);
    CHECK(grown.stopped + grown.dropped + grown.shrunk == 0);
    CHECK(area(grown.pattern.laid) == Approx(36 * 1.9 * 1.9 * 0.0144).epsilon(0.2));
}

TEST_CASE("Leaves do not outlive the stem that they hang on") {
    const std::string stem_and_leaves = R"(lsystem 1
canvas -5 -60 10 60
axiom: Stem [f(1) Leaf] [f(5) Leaf] Dot
style 1: fill #20a040
terminal Stem: style 1; path "M-0.5 0L0.5 0L0.5 -50L-0.5 -50Z"
terminal Leaf: style 1; path "M0.4 0C1 -1 3 -2 3 0C3 2 1 1 0.4 0Z"
terminal Dot: style 1; path "M-9 0L-8 0L-8 -1L-9 -1Z"
)";
    const SurfaceMesh plane = surface_mesh(plane_triangles(20, 20, 1, 0.2));
    GrowDrawingOptions options;
    options.scale = 0.1;
    options.start = nearest_vertex(plane, {10, 10, 0});
    CHECK(grow_drawing(parse_grammar(stem_and_leaves), plane, nullptr, options).laid == 4);
    options.scale = 0.5;  // the stem reaches over the border, the leaves and the dot do not
    const GrownDrawing cut = grow_drawing(parse_grammar(stem_and_leaves), plane, nullptr, options);
    CHECK(cut.laid == 1);
    CHECK(cut.stopped + cut.dropped == 3);
}
