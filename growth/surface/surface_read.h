#pragma once
// Surfaces from files: read, checked, and repaired if that is wished.

#include <string>
#include <vector>

#include "growth/mesh/mesh_read_options.h"
#include "growth/surface/surface_mesh.h"
#include "scene/input_error.h"

namespace rinceau {

struct SurfaceReadOptions {
    bool repair = false;   ///< cut apart and turn what would otherwise be refused
    MeshReadOptions mesh;  ///< limits; its file_name plays no part
};

struct SurfaceReading {
    SurfaceMesh surface;
    std::vector<Warning> warnings;  ///< what was left out or repaired, with counts
};

/// Faces without area and vertices that no face uses are left out with a warning. Edges of three or more faces, faces that
/// turn against their neighbours, vertices at which parts only touch and faces that are there twice are refused with the
/// first five places, or repaired (see repaired_mesh()). Throws InputError in the name of `label`; also for coordinates that
/// are not finite or beyond 1e100, and for a mesh without a face that has an area.
SurfaceReading read_surface(const TriangleMesh& mesh, const std::string& label, const SurfaceReadOptions& options = {});

/// The same of a file's text, read by the label's ending: .obj, .off, .ply.
SurfaceReading read_surface(const std::string& text, const std::string& label, const SurfaceReadOptions& options = {});

}  // namespace rinceau
