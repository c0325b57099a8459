#pragma once
// The shapes that a grammar places: meshes in a scope of size 1.

#include <string>
#include <vector>

#include "growth/mesh/triangle_mesh.h"
#include "scene/painted_region.h"

namespace rinceau {

enum class CollideAs : unsigned char { box, disc, hull, outline };

/// In a scope of size 1: x and y in [-0.5, 0.5] about the scope's position, which lies on the surface; what stands on it has
/// z in [0, 1], what is round about it z in [-0.5, 0.5]. A scope of size (a, b, c) scales the axes by a, b and c.
struct GrammarShape {
    std::string name;
    TriangleMesh mesh;
    SpacePoint low, high;     ///< box of the mesh; of a round kind, of its full circle
    Region outline;           ///< seen along the normal: drawn in the plane, and for collide = outline
    std::vector<Point> hull;  ///< for collide = hull: the convex hull of the outline, counter-clockwise
    CollideAs collide = CollideAs::box;
    double rim = 0;              ///< for collide = disc: share of the radius that is rounded, 0 a cylinder, 1 a ball
    Color color{204, 204, 204};  ///< unless the scope has one
};

}  // namespace rinceau
