#pragma once
// A mesh in, whatever its file format.

#include <string>

#include "growth/mesh/mesh_read_options.h"
#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

/// By the first line of a PLY or OFF file, else by the ending of `name`: .obj, .off or .ply (in any case). Messages call the
/// file options.file_name, or `name` if that is empty. Vertices keep the numbers of the file, counted from 0. Throws
/// InputError with line or byte, LimitError.
TriangleMesh read_mesh(const std::string& name, const std::string& text, MeshReadOptions options = {});

/// Does the name end as one that read_mesh() reads?
bool is_mesh_name(const std::string& name);

}  // namespace rinceau
