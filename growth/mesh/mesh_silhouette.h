#pragma once
// What a mesh covers of the ground it stands on (Sakurai & Miyata 2014, section 3.3).

#include <string>

#include "growth/mesh/mesh_glb_write.h"
#include "scene/painted_region.h"

namespace rinceau {

/// A position seen from above: x, and the axis that lies to the back. With y up (x, -z), with z up (x, y).
Point ground_point(SpacePoint p, UpAxis up);

/// The union of all triangles as they are seen from above. Throws InputError in the name of `label` if that has no area.
Region silhouette(const TriangleMesh& mesh, UpAxis up, const std::string& label);

/// A pose on the ground for what stands at the origin: turned and scaled as the similarity says, which is no mirror image.
MeshPose ground_pose(const Similarity& pose, UpAxis up);

}  // namespace rinceau
