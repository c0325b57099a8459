#pragma once
// Wavefront OBJ out.

#include "growth/mesh/triangle_mesh.h"
#include "lsystem/text_pieces.h"

namespace rinceau {

struct ObjOptions {
    bool colors = false;   ///< of the mesh behind each position, r g b in [0, 1]: what many programs read
    bool normals = false;  ///< smooth but for edges of more than 40 degrees, or those that a mesh brings
};

/// Every instance with triangles of its own, in a group "name_number" counted from 1 for each mesh; numbers in shortest
/// round-trip form, those of normals and colours short. OBJ has no instances: a file for programs that do not read glTF.
/// Throws as the sink.
void write_obj(const MeshAssembly& assembly, const TextSink& sink, const ObjOptions& options = {});

}  // namespace rinceau
