#include "growth/surface/surface_read.h"

#include <algorithm>
#include <cmath>

#include "growth/mesh/mesh_read.h"
#include "growth/surface/mesh_faults.h"
#include "growth/surface/mesh_repair.h"

namespace rinceau {
namespace {

constexpr std::size_t places_named = 5;

void check_coordinates(const TriangleMesh& mesh, const std::string& label) {
    constexpr double largest = 1e100;  // squares and products of lengths stay finite
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const SpacePoint p = mesh.positions[v];
        for (const double coordinate : {p.x, p.y, p.z})
            if (!(std::abs(coordinate) <= largest))
                throw InputError({label}, "expected coordinates up to 1e100, vertex " + std::to_string(v) + " has others");
    }
    const auto [low, high] = bounds(mesh);
    constexpr double smallest = 1e-100;
    if (!(abs(high - low) >= smallest))
        throw InputError({label}, "expected a mesh with an extent, all vertices are in one place");
}

/// Faults in the numbers that vertices and faces had in the file.
void renumber(MeshFaults& faults, const TidyMesh& tidy) {
    for (MeshFault& fault : faults.list) {
        for (int& v : fault.vertices) v = tidy.vertex_number[static_cast<std::size_t>(v)];
        for (int& f : fault.faces) f = tidy.face_number[static_cast<std::size_t>(f)];
    }
}

[[noreturn]] void refuse(const MeshFaults& faults, const std::string& label) {
    std::string counts;
    for (std::size_t k = 0; k < mesh_fault_kinds; ++k) {
        if (faults.count[k] == 0) continue;
        if (!counts.empty()) counts += ", ";
        counts += fault_count_text(static_cast<MeshFaultKind>(k), faults.count[k]);
    }
    std::string places;
    for (std::size_t i = 0; i < std::min(places_named, faults.list.size()); ++i)
        places += (i == 0 ? "" : "; ") + fault_place_text(faults.list[i]);
    throw InputError({label}, "no surface that patterns can grow on: the mesh has " + counts + ". The first: " + places +
                                  ". With --repair it is cut apart there and its faces are turned to agree");
}

class Warnings {
  public:
    explicit Warnings(const std::string& label) : label_(label) {}
    /// Nothing for a count of 0.
    void add(std::size_t count, const std::string& one, const std::string& many, const std::string& what) {
        if (count == 0) return;
        const std::string message = std::to_string(count) + " " + (count == 1 ? one : many) + " " + what;
        list_.push_back(Warning{SourcePlace{label_}, message});
    }
    std::vector<Warning> list() { return std::move(list_); }

  private:
    const std::string& label_;
    std::vector<Warning> list_;
};

void warn_of(const TidyMesh& tidy, Warnings& warnings) {
    warnings.add(tidy.repeated_corners, "face", "faces", "with one vertex twice left out");
    warnings.add(tidy.without_area - tidy.slits, "face", "faces", "without area joined to a neighbour");
    warnings.add(tidy.slits, "face", "faces", "without area left out, which leaves a slit");
    warnings.add(tidy.unused_vertices, "vertex", "vertices", "in no face left out; those behind have lower numbers now");
}

void warn_of(const MeshRepair& repair, Warnings& warnings) {
    warnings.add(repair.repeated_faces, "face", "faces", "that were there twice left out");
    warnings.add(repair.turned_faces, "face", "faces", "turned to agree with their neighbours");
    warnings.add(repair.cut_edges, "edge", "edges", "cut apart, where more than two faces met or the surface was one-sided");
    warnings.add(repair.copied_vertices, "vertex", "vertices", "added as copies along cuts, which are borders now");
}

}  // namespace

SurfaceReading read_surface(const TriangleMesh& mesh, const std::string& label, const SurfaceReadOptions& options) {
    check_coordinates(mesh, label);
    Warnings warnings(label);
    TidyMesh tidy = tidy_mesh(mesh);
    if (tidy.mesh.triangles.empty()) throw InputError({label}, "expected a mesh with faces that have an area, found none");
    warn_of(tidy, warnings);
    MeshFaults faults = mesh_faults(tidy.mesh, places_named);
    if (!faults.empty() && !options.repair) {
        renumber(faults, tidy);
        refuse(faults, label);
    }
    if (!faults.empty()) {
        MeshRepair repair = repaired_mesh(tidy.mesh);
        warn_of(repair, warnings);
        tidy.mesh = std::move(repair.mesh);
    }
    return {surface_mesh(std::move(tidy.mesh)), warnings.list()};
}

SurfaceReading read_surface(const std::string& text, const std::string& label, const SurfaceReadOptions& options) {
    return read_surface(read_mesh(label, text, options.mesh), label, options);
}

}  // namespace rinceau
