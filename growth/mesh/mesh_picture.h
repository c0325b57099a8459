#pragma once
// A look at many meshes.

#include "growth/mesh/mesh_glb_write.h"
#include "scene/picture.h"

namespace rinceau {

struct MeshView {
    double elevation =
        1.05;         ///< radians that the eye stands above the ground's horizon, in front; pi/2 = straight from above
    int width = 900;  ///< pixels; the height follows from what is seen
};

/// The assembly over white, parallel projection, as large as fits; light from the upper left. At least one instance. Throws
/// LimitError for more than 64 million pixels.
Picture mesh_picture(const MeshAssembly& assembly, UpAxis up, const MeshView& view = {});

}  // namespace rinceau
