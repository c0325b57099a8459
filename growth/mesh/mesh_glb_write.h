#pragma once
// Binary glTF 2.0 out.

#include <string>

#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

enum class UpAxis : unsigned char { y, z };

/// Each mesh that has an instance once, a node for each instance (translation, rotation, scale): small however many there
/// are. glTF has y up; with z up a node above all turns the assembly. Normals are smooth but for edges of more than 40
/// degrees. Coordinates of meshes are single precision, as glTF wants. At least one instance.
std::string glb_bytes(const MeshAssembly& assembly, UpAxis up = UpAxis::y);

}  // namespace rinceau
