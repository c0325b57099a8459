#pragma once
// Meshes with faults made into surfaces.

#include <cstddef>
#include <vector>

#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

/// A mesh without what adds nothing to its shape.
struct TidyMesh {
    TriangleMesh mesh;
    std::vector<int> vertex_number;    ///< by vertex: what it was before
    std::vector<int> face_number;      ///< by face: likewise
    std::size_t repeated_corners = 0;  ///< faces with one vertex twice, left out
    std::size_t without_area = 0;      ///< faces without area, all gone
    std::size_t slits = 0;             ///< of those, the ones whose place stays open
    std::size_t unused_vertices = 0;   ///< left out
};

/// Takes out faces that have a vertex twice, faces without area and vertices that no face uses. A face without area whose
/// middle corner lies on its longest edge gives that edge's other face the corner, so that nothing opens; only where this
/// cannot be done (also where two of its corners lie in one place) it leaves a slit.
TidyMesh tidy_mesh(const TriangleMesh& mesh);

struct MeshRepair {
    TriangleMesh mesh;
    std::size_t repeated_faces = 0;   ///< left out
    std::size_t turned_faces = 0;     ///< so that all of a part agree with the larger share of its area
    std::size_t cut_edges = 0;        ///< of three or more faces, or of a one-sided part (such as a Moebius strip)
    std::size_t copied_vertices = 0;  ///< added
};

/// Cuts a tidy mesh apart at edges of three or more faces and at vertices where parts only touch (after Gueziec et al. 1998,
/// cutting): each part gets vertices of its own, so that the cut becomes a border. Faces are turned to agree with their
/// neighbours. mesh_faults() finds nothing in the result; copies of vertices come last, the others keep their numbers.
MeshRepair repaired_mesh(const TriangleMesh& mesh);

}  // namespace rinceau
