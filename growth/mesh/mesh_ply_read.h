#pragma once
// Stanford's polygon file format in.

#include <string>

#include "growth/mesh/mesh_read_options.h"
#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

/// PLY 1.0 as text or binary, of either byte order: element `vertex` with properties x, y, z of any type, element `face`
/// with a list vertex_indices (or vertex_index) of any types. Other elements and properties are skipped; faces of more than
/// three corners are split. Throws InputError with the line (in binary data with the byte), LimitError beyond the limits;
/// memory is bounded by the text, whatever its header promises.
TriangleMesh read_ply(const std::string& text, const MeshReadOptions& options = {});

}  // namespace rinceau
