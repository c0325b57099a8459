#pragma once
// A mesh of a file format from any bytes, written and read again, and the surface that comes of it.

#include <string>

#include "growth/mesh/mesh_obj_write.h"
#include "growth/mesh/mesh_ply_write.h"
#include "growth/mesh/mesh_read.h"
#include "growth/surface/mesh_faults.h"
#include "growth/surface/surface_read.h"
#include "tests/fuzz/fuzz_target.h"

namespace rinceau {

inline void require_whole(const TriangleMesh& mesh) {
    const auto vertices = static_cast<int>(mesh.positions.size());
    for (const auto& triangle : mesh.triangles)
        for (const int vertex : triangle) require(vertex >= 0 && vertex < vertices, "a corner is a position");
}

/// OBJ and PLY of a mesh have the same faces again.
inline void write_and_read(const TriangleMesh& mesh) {
    MeshAssembly assembly;
    assembly.meshes.push_back({"any", mesh});
    assembly.instances.push_back({});
    std::string obj, ply;
    write_obj(assembly, [&](std::string_view text) { obj += text; });
    write_ply(assembly, [&](std::string_view text) { ply += text; });
    const TriangleMesh from_obj = read_mesh("any.obj", obj, {.keep_numbers = true});  // numbers to rounding
    require(from_obj.triangles == mesh.triangles, "a written OBJ has the same faces");
    const TriangleMesh from_ply = read_mesh("any.ply", ply);
    require(from_ply.triangles == mesh.triangles && from_ply.positions == mesh.positions,
            "a written PLY reads back as the same");
}

/// With repair: what is refused without it is cut apart.
inline void take_mesh(std::string_view bytes, const std::string& file_name) {
    constexpr std::size_t most = 20'000;  // positions and faces, for the time that a case takes
    const MeshReadOptions options{
        .file_name = file_name, .max_positions = most, .max_triangles = most, .keep_numbers = true};
    const TriangleMesh mesh = read_mesh(file_name, std::string(bytes), options);
    require_whole(mesh);
    write_and_read(mesh);
    const SurfaceReading reading = read_surface(mesh, file_name, {.repair = true, .mesh = options});
    require(mesh_faults(reading.surface.mesh).empty(), "a repaired mesh has no faults");
}

}  // namespace rinceau
