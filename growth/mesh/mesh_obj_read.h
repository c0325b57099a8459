#pragma once
// Wavefront OBJ in.

#include <string>

#include "growth/mesh/mesh_read_options.h"
#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

/// All faces of the text as one mesh: quads and faces of more corners are split; objects, groups, normals, texture places
/// and materials play no part. Positions that no face uses are left out unless keep_numbers is set. Throws InputError, with
/// the line, for a vertex without three finite numbers, for a face of less than three corners or with a vertex that is not
/// there, and if there is no face.
TriangleMesh read_obj(const std::string& text, const MeshReadOptions& options = {});

}  // namespace rinceau
