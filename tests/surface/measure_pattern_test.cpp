#include "growth/surface/measure_pattern.h"

#include <catch2/catch.hpp>

#include "geometry/random.h"
#include "growth/surface/bodies_overlap.h"
#include "surface_shapes.h"

namespace rinceau {
namespace {

GrammarShape unit_box() {
    GrammarShape box;
    box.name = "box";
    box.low = {-0.5, -0.5, 0};
    box.high = {0.5, 0.5, 1};
    return box;
}

/// A box of that size about a place of the plane of faces with sides of 1.
PatternShape box_at(const SurfaceMesh& plane, double x, double y, double size = 1) {
    const int face = 2 * (static_cast<int>(y) * 8 + static_cast<int>(x)) + (y - std::floor(y) > x - std::floor(x) ? 1 : 0);
    const auto corner =
        plane.mesh.positions[static_cast<std::size_t>(plane.mesh.triangles[static_cast<std::size_t>(face)][0])];
    const auto& frame = plane.frame[static_cast<std::size_t>(face)];
    const SpacePoint from = SpacePoint{x, y, 0} - corner;
    PatternShape shape;
    shape.at = {face, {dot(from, frame[0]), dot(from, frame[1])}};
    shape.position = {x, y, 0};
    shape.axes = {SpacePoint{1, 0, 0}, SpacePoint{0, 1, 0}, SpacePoint{0, 0, 1}};
    shape.size = {size, size, size};
    shape.tested = true;
    return shape;
}

SurfaceMesh plane() { return surface_mesh(plane_triangles(8, 8, 1)); }

}  // namespace

TEST_CASE("Overlaps count where the later shape was tested, and neither among kin that touch nor within a Lock",
          "[surface]") {
    const SurfaceMesh ground = plane();
    SurfacePattern pattern;
    pattern.shapes = {unit_box()};
    pattern.placed = {box_at(ground, 2.5, 2.5), box_at(ground, 3.2, 2.5), box_at(ground, 5.5, 2.5)};
    CHECK(measure_pattern(pattern, ground).overlaps == 1);
    pattern.placed[1].tested = false;
    CHECK(measure_pattern(pattern, ground).overlaps == 0);
    pattern.placed[1].tested = true;
    pattern.placed[1].parent = 0;
    CHECK(measure_pattern(pattern, ground).overlaps == 0);
    pattern.placed[1].position.x = 2.8;  // too near even for kin
    CHECK(measure_pattern(pattern, ground).overlaps == 1);
    pattern.placed[0].set = pattern.placed[1].set = 4;
    CHECK(measure_pattern(pattern, ground).overlaps == 0);
}

TEST_CASE("Shapes that only touch do not overlap", "[surface]") {
    const SurfaceMesh ground = plane();
    SurfacePattern pattern;
    pattern.shapes = {unit_box()};
    for (int i = 1; i < 7; ++i)
        for (int j = 1; j < 7; ++j) pattern.placed.push_back(box_at(ground, i + 0.5, j + 0.5));
    const PatternMeasures measures = measure_pattern(pattern, ground);
    CHECK(measures.overlaps == 0);
    CHECK(measures.pairs > 0);
    CHECK(measures.surface_distance_max < 1e-12);
}

TEST_CASE("The sweep finds as many overlaps as all pairs do", "[surface]") {
    const SurfaceMesh ground = plane();
    SurfacePattern pattern;
    pattern.shapes = {unit_box()};
    Random random(3);
    for (int i = 0; i < 300; ++i)
        pattern.placed.push_back(
            box_at(ground, random.uniform(0.5, 7.5), random.uniform(0.5, 7.5), random.uniform(0.05, 0.5)));
    std::vector<CollisionBody> bodies;
    for (const PatternShape& shape : pattern.placed)
        bodies.push_back(collision_body(pattern.shapes[0], shape.position, shape.axes, shape.size, {0, 0, 1}));
    const PatternMeasureOptions options;
    const double shrink = 1 - options.touch - options.dead_band;
    long overlaps = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) overlaps += bodies_overlap(bodies[i], bodies[j], shrink, shrink) ? 1 : 0;
    CHECK(overlaps > 100);
    CHECK(measure_pattern(pattern, ground, options).overlaps == overlaps);
}

TEST_CASE("What stands beside its foot is told, what is lifted along the normal is not", "[surface]") {
    const SurfaceMesh ground = plane();
    SurfacePattern pattern;
    pattern.shapes = {unit_box()};
    pattern.placed = {box_at(ground, 2.5, 2.25)};
    pattern.placed[0].position.z = 0.75;
    CHECK(measure_pattern(pattern, ground).surface_distance_max < 1e-12);
    pattern.placed[0].position.x += 0.1;
    CHECK(measure_pattern(pattern, ground).surface_distance_max == Approx(0.1 / ground.diagonal));
    PatternLine line;
    line.points = {{1, 1, 0.2}};
    line.at = {at_vertex(ground, 10)};
    pattern.placed.clear();
    pattern.lines = {line};
    CHECK(measure_pattern(pattern, ground).surface_distance_max == Approx(0.2 / ground.diagonal));
}

}  // namespace rinceau
