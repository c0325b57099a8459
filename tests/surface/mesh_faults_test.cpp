#include "growth/surface/mesh_faults.h"

#include <catch2/catch.hpp>

#include "geometry/index.h"
#include "growth/surface/mesh_repair.h"
#include "growth/surface/surface_read.h"
#include "surface_shapes.h"

using namespace rinceau;

namespace {

std::size_t count(const TriangleMesh& mesh, MeshFaultKind kind) { return mesh_faults(mesh).count_of(kind); }

std::size_t all_faults(const TriangleMesh& mesh) {
    std::size_t sum = 0;
    for (const std::size_t n : mesh_faults(mesh).count) sum += n;
    return sum;
}

std::string refusal(const TriangleMesh& mesh) {
    try {
        read_surface(mesh, "bad.obj");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

double area_of(const TriangleMesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto at = [&](int v) { return mesh.positions[static_cast<std::size_t>(v)]; };
        sum += abs(cross(at(b) - at(a), at(c) - at(a))) / 2;
    }
    return sum;
}

/// Three pages of a book that share the edge 0-1.
TriangleMesh book() {
    return {{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}}};
}

/// Two triangles that share the corner 0 only.
TriangleMesh bow_tie() { return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}}; }

TriangleMesh moebius_strip(int around) {
    TriangleMesh mesh;
    for (int i = 0; i < around; ++i) {
        const double u = two_pi * i / around;
        for (const double w : {-0.3, 0.3}) {
            const double r = 1 + w * std::cos(u / 2);
            mesh.positions.push_back({r * std::cos(u), r * std::sin(u), w * std::sin(u / 2)});
        }
    }
    for (int i = 0; i < around; ++i) {
        const bool last = i + 1 == around;
        const int a = 2 * i, b = 2 * i + 1, c = last ? 1 : a + 2, d = last ? 0 : b + 2;
        mesh.triangles.push_back({a, c, b});
        mesh.triangles.push_back({b, c, d});
    }
    return mesh;
}

}  // namespace

TEST_CASE("Closed and open surfaces have no faults") {
    CHECK(mesh_faults(sphere_triangles(2)).empty());
    CHECK(mesh_faults(torus_triangles(9, 7, 2, 0.7)).empty());
    CHECK(mesh_faults(plane_triangles(4, 3, 1, 0.2)).empty());
}

TEST_CASE("Each fault is found once, with its vertices, faces and place") {
    const MeshFaults pages = mesh_faults(book());
    REQUIRE(pages.list.size() == 1);
    CHECK(pages.list[0].kind == MeshFaultKind::crowded_edge);
    CHECK(pages.list[0].vertices == std::vector<int>{0, 1});
    CHECK(pages.list[0].faces == std::vector<int>{0, 1, 2});
    CHECK(pages.list[0].place == SpacePoint{0, 0, 0.5});

    const MeshFaults tie = mesh_faults(bow_tie());
    REQUIRE(tie.list.size() == 1);
    CHECK(tie.list[0].kind == MeshFaultKind::parted_fan);
    CHECK(tie.list[0].vertices == std::vector<int>{0});

    TriangleMesh turned = plane_triangles(3, 3, 1);
    std::swap(turned.triangles[8][0], turned.triangles[8][1]);
    CHECK(count(turned, MeshFaultKind::opposed_faces) == 3);

    TriangleMesh sphere = sphere_triangles(1);
    sphere.triangles.push_back(sphere.triangles[5]);
    sphere.triangles.push_back({3, 3, 7});
    sphere.positions.push_back({9, 9, 9});
    CHECK(count(sphere, MeshFaultKind::repeated_face) == 1);
    CHECK(count(sphere, MeshFaultKind::repeated_corner) == 1);
    CHECK(count(sphere, MeshFaultKind::unused_vertex) == 1);
    CHECK(all_faults(sphere) == 3);
    CHECK(count({}, MeshFaultKind::no_face) == 1);
}

TEST_CASE("Of many faults all are counted and the first are listed") {
    TriangleMesh many;
    for (int i = 0; i < 10; ++i) {
        const TriangleMesh pages = book();
        const int first = static_cast<int>(many.positions.size());
        for (const SpacePoint p : pages.positions) many.positions.push_back(p + SpacePoint{3.0 * i, 0, 0});
        for (const auto& [a, b, c] : pages.triangles) many.triangles.push_back({first + a, first + b, first + c});
    }
    const MeshFaults faults = mesh_faults(many, 4);
    CHECK(faults.count_of(MeshFaultKind::crowded_edge) == 10);
    CHECK(faults.list.size() == 4);
    const std::string message = refusal(many);
    CHECK(
        message.starts_with("bad.obj: no surface that patterns can grow on: the mesh has 10 edges of three or more faces"));
    CHECK(message.find("edge 20-21 of faces 12, 13, 14 at (12, 0, 0.5)") != std::string::npos);
    CHECK(message.find("edge 25-26") == std::string::npos);
    CHECK(message.find("--repair") != std::string::npos);
}

TEST_CASE("A face without area gives its middle corner to its neighbour: nothing opens") {
    // The side 0-1 of a square has a corner 4 on it that only a face without area uses.
    const TriangleMesh square{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0, 0}, {1, -1, 0}},
                              {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {0, 5, 4}, {4, 5, 1}}};
    const SurfaceReading reading = read_surface(square, "square.obj");
    CHECK(reading.surface.faces() == 5);
    CHECK(reading.surface.border_edges == 5);
    CHECK(euler_characteristic(reading.surface) == 1);
    CHECK(reading.surface.area == Approx(5));
    REQUIRE(reading.warnings.size() == 1);
    CHECK(reading.warnings[0].message == "1 face without area joined to a neighbour");
}

TEST_CASE("Unused vertices and faces with one vertex twice are left out with a warning") {
    TriangleMesh sphere = sphere_triangles(1);
    sphere.positions.insert(sphere.positions.begin(), {7, 7, 7});
    for (auto& face : sphere.triangles)
        for (int& v : face) ++v;
    sphere.triangles.push_back({1, 1, 2});
    const SurfaceReading reading = read_surface(sphere, "sphere.obj");
    CHECK(reading.surface.vertices() == 42);
    CHECK(reading.surface.faces() == 80);
    CHECK(reading.warnings.size() == 2);
}

TEST_CASE("Coordinates that are no numbers, meshes in one place and meshes without area are refused") {
    TriangleMesh sphere = sphere_triangles(0);
    sphere.positions[3].y = std::nan("");
    CHECK(refusal(sphere).find("vertex 3") != std::string::npos);
    sphere.positions[3].y = 1e200;
    CHECK(refusal(sphere).find("1e100") != std::string::npos);
    CHECK(refusal({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}}).find("in one place") != std::string::npos);
    CHECK(refusal({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}).find("found none") != std::string::npos);
    CHECK(refusal({}).find("bad.obj") != std::string::npos);
}

TEST_CASE("Repair turns the smaller part, and touches nothing else") {
    TriangleMesh mesh = torus_triangles(16, 12, 2, 0.7);
    const TriangleMesh sound = mesh;
    for (const int face : {3, 4, 50, 51, 52, 200}) {
        auto& corners = mesh.triangles[at(face)];
        std::swap(corners[1], corners[2]);
    }
    const MeshRepair repair = repaired_mesh(mesh);
    CHECK(repair.turned_faces == 6);
    CHECK(repair.cut_edges == 0);
    CHECK(repair.copied_vertices == 0);
    CHECK(repair.mesh.triangles == sound.triangles);
}

TEST_CASE("Repair cuts pages, bow ties and one-sided strips apart") {
    const MeshRepair pages = repaired_mesh(book());
    CHECK(pages.cut_edges == 1);
    CHECK(pages.copied_vertices == 4);
    CHECK(mesh_faults(pages.mesh).empty());

    const MeshRepair tie = repaired_mesh(bow_tie());
    CHECK(tie.copied_vertices == 1);
    CHECK(mesh_faults(tie.mesh).empty());

    const MeshRepair strip = repaired_mesh(moebius_strip(20));
    CHECK(strip.cut_edges == 1);
    CHECK(strip.copied_vertices == 2);
    CHECK(mesh_faults(strip.mesh).empty());
    CHECK(euler_characteristic(surface_mesh(strip.mesh)) == 1);
}

TEST_CASE("Two spheres that share an edge stay closed when they are cut apart") {
    TriangleMesh both = sphere_triangles(1);
    const auto [a, b, c] = both.triangles[0];
    const TriangleMesh other = sphere_triangles(1);
    const int first = static_cast<int>(both.positions.size());
    for (const SpacePoint p : other.positions) both.positions.push_back(p + SpacePoint{3, 0, 0});
    for (const auto& face : other.triangles) {
        std::array<int, 3> moved{};
        for (std::size_t k = 0; k < 3; ++k) moved[k] = face[k] == a ? a : face[k] == b ? b : face[k] + first;
        both.triangles.push_back(moved);
    }
    CHECK(count(both, MeshFaultKind::crowded_edge) == 1);
    const SurfaceReading reading = read_surface(both, "both.obj", {.repair = true});
    CHECK(reading.surface.border_edges == 0);
    CHECK(euler_characteristic(reading.surface) == 4);
}

TEST_CASE("Whatever triangles are thrown together, repair makes a surface of the same area, and repairs it once") {
    Random random(11);
    for (int trial = 0; trial < 300; ++trial) {
        TriangleMesh soup;
        const std::uint32_t vertices = 4 + random.below(8), faces = 1 + random.below(30);
        for (std::uint32_t v = 0; v < vertices; ++v)
            soup.positions.push_back({random.uniform(), random.uniform(), random.uniform()});
        for (std::uint32_t f = 0; f < faces; ++f) {
            std::array<int, 3> face{};
            for (int& v : face) v = static_cast<int>(random.below(vertices));
            soup.triangles.push_back(face);
        }
        const TidyMesh tidy = tidy_mesh(soup);
        if (tidy.mesh.triangles.empty()) continue;
        const MeshRepair repair = repaired_mesh(tidy.mesh);
        CAPTURE(trial, vertices, faces);
        REQUIRE(mesh_faults(repair.mesh).empty());
        CHECK(repair.mesh.triangles.size() + repair.repeated_faces == tidy.mesh.triangles.size());
        CHECK(repaired_mesh(repair.mesh).mesh.triangles == repair.mesh.triangles);
        if (repair.repeated_faces == 0) CHECK(area_of(repair.mesh) == Approx(area_of(soup)));
        const SurfaceMesh surface = surface_mesh(repair.mesh);
        CHECK(surface.area == Approx(area_of(repair.mesh)));
    }
}
