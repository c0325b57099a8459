#include <catch2/catch.hpp>

#include "derivation_world.h"
#include "geometry/angle.h"
#include "growth/surface/bodies_overlap.h"
#include "growth/surface/collision_body.h"

using namespace rinceau;

namespace {

SurfaceWorld with_field(TriangleMesh mesh, Complex direction) {
    SurfaceWorld world = bare_world(std::move(mesh));
    const SurfaceMesh& surface = *world.surface;
    SurfaceField field;
    field.n = 2;
    const SpacePoint way{direction.x, direction.y, 0};
    for (int v = 0; v < surface.vertices(); ++v) {
        // in the vertex's frame: seen in the face of its outgoing edge, turned back
        const SurfacePoint p = at_vertex(surface, v);
        const auto& frame = surface.frame[static_cast<std::size_t>(p.face)];
        const Complex in_face{dot(way, frame[0]), dot(way, frame[1])};
        const Complex in_vertex = in_face * conj(from_vertex_frame(surface, v, {1, 0}));
        field.values.push_back(in_vertex * in_vertex);
    }
    world.fields.push_back({"F1", std::make_shared<FieldOnSurface>(surface, std::move(field))});
    return world;
}

/// Centres of other shapes within `reach`, by distance.
std::vector<double> distances_from(const SurfacePattern& pattern, std::size_t i, double reach) {
    std::vector<double> result;
    for (std::size_t j = 0; j < pattern.placed.size(); ++j)
        if (const double away = abs(pattern.placed[i].position - pattern.placed[j].position); j != i && away < reach)
            result.push_back(away);
    return result;
}

bool is_inner(const PatternShape& shape, double side, double margin) {
    const SpacePoint p = shape.position;
    return std::min({p.x, p.y, side - p.x, side - p.y}) > margin;
}

/// Is j one of the last six before i on its way, which i may touch?
bool is_kin(const SurfacePattern& pattern, std::size_t i, std::size_t j) {
    int before = pattern.placed[i].parent;
    for (int k = 0; k < ShapeDerivationOptions{}.kin && before >= 0; ++k) {
        if (before == static_cast<int>(j)) return true;
        before = pattern.placed[static_cast<std::size_t>(before)].parent;
    }
    return false;
}

/// Pairs of placed shapes that overlap when all are shrunk to `share`, kin to half of it.
int overlaps_of(const SurfacePattern& pattern, const SurfaceMesh& surface, double share) {
    std::vector<CollisionBody> bodies;
    for (const PatternShape& shape : pattern.placed)
        bodies.push_back(collision_body(pattern.shapes[static_cast<std::size_t>(shape.shape)], shape.position, shape.axes,
                                        shape.size, normal_at(surface, shape.at)));
    int count = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double own = is_kin(pattern, i, j) ? share / 2 : share;
            count += bodies_overlap(bodies[i], bodies[j], own, own) ? 1 : 0;
        }
    return count;
}

const std::string kagome = R"(
param d = 0.6
shape ring = disc
P ~ [Rz(30) T(d,0,0) A] [Rz(150) T(d,0,0) A] [Rz(-90) T(d,0,0) A]
A ~ B [T(d,0,0) Rz(60) T(d,0,0) A] [T(d,0,0) Rz(-60) T(d,0,0) A]
B ~ S(1,1,0.6) IC("ring")
axiom nearest 10 10 0 P
)";

}  // namespace

TEST_CASE("T in the plane goes where its numbers say, along a field and without one") {
    const std::string text = "shape dot = box\naxiom nearest 3 4 0 Rz(30) T(1.25,-0.5,0.2) I(\"dot\")";
    const Complex expected = Complex{3, 4} + polar(1, radians(30)) * Complex{1.25, -0.5};
    for (const SurfaceWorld& world : {plane_world(10, 0.2), with_field(plane_triangles(20, 20, 0.5, 0.2), {1, 0})}) {
        const SurfacePattern pattern = grown(text, world);
        REQUIRE(pattern.placed.size() == 1);
        CHECK(abs(pattern.placed[0].position - SpacePoint{expected.x, expected.y, 0.2}) < 1e-12);
        CHECK(abs(pattern.placed[0].axes[0] - SpacePoint{std::cos(radians(30)), std::sin(radians(30)), 0}) < 1e-12);
    }
}

TEST_CASE("the planar tile of figure 4 has four neighbours at sqrt(3) d everywhere inside") {
    const SurfacePattern pattern = grown(kagome, with_field(plane_triangles(40, 40, 0.5, 0.2), {0.6, 0.8}));
    const double distance = std::sqrt(3.0) * 0.6;
    CHECK(pattern.complete);
    int inner = 0;
    for (std::size_t i = 0; i < pattern.placed.size(); ++i) {
        if (!is_inner(pattern.placed[i], 20, 2.5)) continue;
        ++inner;
        const std::vector<double> near = distances_from(pattern, i, 1.2 * distance);
        REQUIRE(near.size() == 4);
        for (const double away : near) CHECK(std::abs(away - distance) < 1e-9);
    }
    // three tiles for each hexagonal cell, whose sides are 2 d apart from its middle
    CHECK(inner == Approx(15.0 * 15.0 * 3 / (2 * std::sqrt(3.0) * distance * distance)).epsilon(0.05));
}

TEST_CASE("tested shapes do not overlap on curved surfaces, compared pair by pair") {
    const std::string text = R"(
shape tile = box
shape disc = disc
axiom vertex 5 Tile(0)
axiom scatter 200 Fill
Tile(n) ~ Place [T(0.32,0,0) Tile(n+1)] [Rz(70) T(0.32,0,0) Tile(n+1)] [Rz(140) T(0.32,0,0) Tile(n+1)] [Rz(-110) T(0.32,0,0) Tile(n+1)]
Place ~ Rz(rand(0,20)) S(0.3,0.2,0.1) IC("tile")
Fill ~ S(0.1,0.1,0.1) IC("disc")
)";
    for (const TriangleMesh& mesh : {sphere_triangles(3), torus_triangles(48, 24, 1, 0.4)}) {
        const SurfaceWorld world = bare_world(mesh);
        const SurfacePattern pattern = grown(text, world);
        CHECK(pattern.complete);
        CHECK(count_of(pattern, "tile") > 80);
        CHECK(count_of(pattern, "disc") > 10);
        CHECK(pattern.counts.collisions_avoided > 300);
        for (const PatternShape& shape : pattern.placed) CHECK(shape.tested);
        CHECK(overlaps_of(pattern, *world.surface, 0.98 - 1e-3) == 0);
    }
}

TEST_CASE("merged points close a net of hexagons") {
    const std::string text = R"(
shape node = disc
axiom nearest 10 10 0 S(0.2,0.2,0.2) IM("node",0.1,180) [Out] [Rz(120) Out] [Rz(240) Out]
Out ~ Line(0) LineSeg(0.9,0.05) Node
Node ~ S(0.2,0.2,0.2) IM("node",0.1,180) [Rz(60) Out] [Rz(-60) Out]
)";
    const SurfacePattern pattern = grown(text, plane_world(20, 0.2));
    CHECK(pattern.counts.merged_points > 100);
    for (std::size_t i = 0; i < pattern.placed.size(); ++i) {
        if (!is_inner(pattern.placed[i], 20, 2)) continue;
        const std::vector<double> near = distances_from(pattern, i, 1.2);
        REQUIRE(near.size() == 3);
        for (const double away : near) CHECK(std::abs(away - 0.9) < 1e-9);
    }
}
