#pragma once
// Binary glTF 2.0 out.

#include <string>

#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

enum class UpAxis : unsigned char { y, z };

enum class GlbInstancing : unsigned char {
    gpu,    ///< EXT_mesh_gpu_instancing: 40 bytes an instance; for viewers that know the extension
    nodes,  ///< a node for each instance, about 150 bytes
    merge   ///< every instance with triangles of its own, one mesh for each that has instances
};

struct GlbOptions {
    UpAxis up = UpAxis::y;
    GlbInstancing instancing = GlbInstancing::nodes;
    bool two_sided = false;  ///< draw the insides, too: of sheets that both sides are seen of
};

/// Each mesh that has an instance once (with gpu instancing a second, mirrored one if it has mirrored instances), and its
/// instances by translation, rotation and scale: small however many there are. glTF has y up; with z up a node above all
/// turns the assembly. Normals are smooth but for edges of more than 40 degrees, or those that a mesh brings. Coordinates of
/// meshes are single precision, as glTF wants. At least one instance. Throws LimitError for more than 2 GB.
std::string glb_bytes(const MeshAssembly& assembly, const GlbOptions& options);
std::string glb_bytes(const MeshAssembly& assembly, UpAxis up = UpAxis::y);

}  // namespace rinceau
