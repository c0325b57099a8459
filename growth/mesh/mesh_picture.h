#pragma once
// A look at many meshes.

#include "geometry/angle.h"
#include "growth/mesh/mesh_glb_write.h"
#include "scene/picture.h"

namespace rinceau {

struct MeshView {
    double elevation =
        1.05;         ///< radians that the eye stands above the ground's horizon, in front; pi/2 = straight from above
    int width = 900;  ///< pixels
    double turn = 0;  ///< radians that the eye has gone about the up axis from the front, counter-clockwise seen from above
    int height = 0;   ///< pixels; 0 = follows from what is seen
    double occlusion = 0;           ///< how much less light reaches corners: 0 = no matter where, 1 = as from a clouded sky
    double crease = 40 * pi / 180;  ///< radians; sharper edges are seen as edges
};

/// The assembly over white, parallel projection, as large as fits; light from the upper left, a second one from the right.
/// Meshes are seen from both sides. At least one instance. Throws LimitError for more than 64 million pixels.
Picture mesh_picture(const MeshAssembly& assembly, UpAxis up, const MeshView& view = {});

}  // namespace rinceau
