#include "growth/surface/surface_pattern.h"

#include <catch2/catch.hpp>

#include "growth/surface/line_tube.h"
#include "growth/surface/mesh_faults.h"
#include "surface_shapes.h"

using namespace rinceau;

namespace {

PatternLine bent_line(const std::vector<Point>& points, double width) {
    PatternLine line;
    for (const Point p : points) {
        line.points.push_back({p.x, p.y, 0});
        line.normals.push_back({0, 0, 1});
        line.widths.push_back(width);
    }
    return line;
}

double enclosed(const TriangleMesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        const auto corner = [&](std::size_t k) { return mesh.positions[static_cast<std::size_t>(t[k])]; };
        sum += dot(corner(0), cross(corner(1), corner(2))) / 6;
    }
    return sum;
}

/// The longest way from the line to a vertex.
double farthest_from(const std::vector<SpacePoint>& line, const TriangleMesh& mesh) {
    double farthest = 0;
    for (const SpacePoint p : mesh.positions) {
        double best = HUGE_VAL;
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const SpacePoint d = line[i + 1] - line[i];
            const double share = dot(d, d) > 0 ? std::clamp(dot(p - line[i], d) / dot(d, d), 0.0, 1.0) : 0;
            best = std::min(best, abs(p - line[i] - share * d));
        }
        farthest = std::max(farthest, best);
    }
    return farthest;
}

}  // namespace

TEST_CASE("A line's tube is closed, as thick as the line is wide, and round at its ends") {
    const PatternLine line = bent_line({{0, 0}, {4, 0}}, 0.5);
    const NamedMesh tube = line_tube(line, 32);
    CHECK(mesh_faults(tube.mesh).empty());
    CHECK(euler_characteristic(surface_mesh(tube.mesh)) == 2);
    CHECK(enclosed(tube.mesh) == Approx(pi * 0.0625 * 4 + 4 * pi / 3 * 0.015625).epsilon(0.03));
    const auto [low, high] = bounds(tube.mesh);
    CHECK(low.x == Approx(-0.25));
    CHECK(high.x == Approx(4.25));
    CHECK(high.z == Approx(0.25));
    const auto flat = triangle_normals(tube.mesh);
    for (std::size_t t = 0; t < flat.size(); ++t)
        for (const int v : tube.mesh.triangles[t]) CHECK(dot(tube.normals[static_cast<std::size_t>(v)], flat[t]) > 0.8);
}

TEST_CASE("A tube stays one closed body of even thickness through small and sharp bends and back turns") {
    for (const auto& points : std::vector<std::vector<Point>>{{{0, 0}, {2, 0}, {4, 0.6}, {6, 0.2}},
                                                              {{0, 0}, {3, 0}, {3, 3}},
                                                              {{0, 0}, {3, 0}, {0.5, 1}, {3, 2}},
                                                              {{0, 0}, {2, 0}, {1, 0}},
                                                              {{0, 0}, {0, 0}, {2, 0}, {2, 0}}}) {
        const PatternLine line = bent_line(points, 0.4);
        const NamedMesh tube = line_tube(line, 8);
        CHECK(mesh_faults(tube.mesh).empty());
        CHECK(enclosed(tube.mesh) > 0);
        CHECK(farthest_from(line.points, tube.mesh) < 0.2 / std::cos(pi / 12) + 1e-12);
        CHECK(bounds(tube.mesh)[1].z == Approx(0.2));
    }
}

TEST_CASE("A merged line ends flat on the line that it met, and without length or width there is no tube") {
    PatternLine line = bent_line({{0, 0}, {4, 0}}, 0.5);
    line.merged = true;
    const NamedMesh tube = line_tube(line, 6);
    CHECK(bounds(tube.mesh)[1].x == 4);
    CHECK(mesh_faults(tube.mesh).empty());
    CHECK(line_tube(bent_line({{1, 1}}, 1), 6).mesh.triangles.empty());
    CHECK(line_tube(bent_line({{1, 1}, {1, 1}}, 1), 6).mesh.triangles.empty());
    CHECK(line_tube(bent_line({{1, 1}, {2, 1}}, 0), 6).mesh.triangles.empty());
    CHECK(line_tube({}, 6).mesh.triangles.empty());
}

TEST_CASE("A pattern's shapes become instances that stand in their scopes, one mesh for each shape and colour") {
    SurfacePattern pattern;
    pattern.shapes = {{.name = "box", .mesh = sphere_triangles(0)}, {.name = "leaf", .mesh = sphere_triangles(1)}};
    Random random(4);
    for (int i = 0; i < 60; ++i) {
        PatternShape placed{.shape = i % 2, .color = {static_cast<std::uint8_t>(i % 3), 0, 255}};
        const SpacePoint z = unit({random.normal(), random.normal(), random.normal()});
        const SpacePoint x = unit(cross(z, {random.normal(), random.normal(), random.normal()}));
        placed.axes = {x, cross(z, x), z};
        if (i == 0) placed.axes = {SpacePoint{1, 0, 0}, SpacePoint{0, 1, 0}, SpacePoint{0, 0, 1}};
        if (i == 1) placed.axes = {SpacePoint{-1, 0, 0}, SpacePoint{0, -1, 0}, SpacePoint{0, 0, 1}};
        if (i == 2) placed.axes = {SpacePoint{1, 0, 0}, SpacePoint{0, -1, 0}, SpacePoint{0, 0, -1}};
        placed.position = {random.uniform(), random.uniform(), random.uniform()};
        placed.size = {1 + random.uniform(), 0.5, 2};
        pattern.placed.push_back(placed);
    }
    pattern.lines = {bent_line({{0, 0}, {1, 0}}, 0.1), bent_line({{0, 1}, {1, 1}}, 0.1)};
    pattern.laid = {{.name = "petal", .mesh = sphere_triangles(0)}};
    const SurfaceMesh surface = surface_mesh(plane_triangles(2, 2, 1));
    const MeshAssembly assembly = assembly_of(pattern, surface, {.with_surface = true});
    REQUIRE(assembly.meshes.size() == 1 + 6 + 1 + 1);
    CHECK(assembly.meshes[0].name == "surface");
    CHECK(assembly.meshes[1].name == "box_0000ff");
    CHECK(assembly.meshes[7].name == "line");
    CHECK(assembly.meshes[8].name == "petal");
    REQUIRE(assembly.instances.size() == 63);
    for (std::size_t i = 0; i < pattern.placed.size(); ++i) {
        const PatternShape& placed = pattern.placed[i];
        const MeshPose& pose = assembly.instances[i + 1].pose;
        const SpacePoint p{0.3, -0.2, 0.7};
        const SpacePoint wanted = placed.position + placed.size.x * p.x * placed.axes[0] +
                                  placed.size.y * p.y * placed.axes[1] + placed.size.z * p.z * placed.axes[2];
        CHECK(abs(apply(pose, p) - wanted) < 1e-12);
        CHECK(assembly.meshes[static_cast<std::size_t>(assembly.instances[i + 1].mesh)].color == placed.color);
    }
    const long tubes = static_cast<long>(assembly.meshes[7].mesh.triangles.size());
    CHECK(faces_out(assembly) == 8 + 30 * 20 + 30 * 80 + tubes + 20);
    CHECK(assembly_of({}, surface).instances.empty());
}
