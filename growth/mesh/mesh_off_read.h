#pragma once
// Object File Format in.

#include <string>

#include "growth/mesh/mesh_read_options.h"
#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

/// Geomview's OFF, as text: the word OFF (or COFF, NOFF, CNOFF, STOFF ...: what follows the three coordinates in a line is
/// left out), the numbers of vertices, faces and edges, a line for each vertex and for each face. Comments begin with #.
/// Faces of more than three corners are split. Throws InputError with the line, LimitError beyond the limits.
TriangleMesh read_off(const std::string& text, const MeshReadOptions& options = {});

}  // namespace rinceau
