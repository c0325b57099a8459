#pragma once
// Wavefront OBJ in.

#include <cstddef>
#include <string>

#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

struct MeshReadOptions {
    std::string file_name;                   ///< for messages
    std::size_t max_positions = 10'000'000;  ///< more -> LimitError
    std::size_t max_triangles = 20'000'000;  ///< more -> LimitError
    std::size_t max_corners = 1000;          ///< of a face -> LimitError
};

/// All faces of the text as one mesh: quads and faces of more corners are split; objects, groups, normals, texture places
/// and materials play no part. Positions that no face uses are left out. Throws InputError, with the line, for a vertex
/// without three finite numbers, for a face of less than three corners or with a vertex that is not there, and if there is
/// no face.
TriangleMesh read_obj(const std::string& text, const MeshReadOptions& options = {});

}  // namespace rinceau
