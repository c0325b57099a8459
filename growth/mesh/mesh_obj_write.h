#pragma once
// Wavefront OBJ out.

#include "growth/mesh/triangle_mesh.h"
#include "lsystem/text_pieces.h"

namespace rinceau {

/// Every instance with triangles of its own, in a group "name_number" counted from 1 for each mesh; numbers in shortest
/// round-trip form. OBJ has no instances: a file for programs that do not read glTF. Throws as the sink.
void write_obj(const MeshAssembly& assembly, const TextSink& sink);

}  // namespace rinceau
