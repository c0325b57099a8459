#pragma once
// Stanford's polygon file format out.

#include "growth/mesh/triangle_mesh.h"
#include "lsystem/text_pieces.h"

namespace rinceau {

/// Every instance with triangles of its own, as binary little-endian PLY: positions in double precision, the mesh's colour
/// at each vertex, faces as lists of vertex_indices. PLY has no instances. Throws LimitError for more than 2^31 vertices or
/// faces, and as the sink.
void write_ply(const MeshAssembly& assembly, const TextSink& sink);

}  // namespace rinceau
