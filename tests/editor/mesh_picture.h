#pragma once
// Meshes drawn without a graphics card: what the triangles say, as pixels.

#include "editor/mesh/draw_mesh.h"
#include "scene/element.h"
#include "scene/picture.h"

namespace rinceau {

/// The scene's outlines over white, solid paints only, one picture pixel a scene unit divided by `unit`, from 16 samples a
/// pixel.
Picture mesh_picture(const Scene& scene, double unit, double deviation);

/// The sum of the triangles' areas, each of them taken as positive.
double mesh_area(const DrawMesh& mesh, const std::vector<std::uint32_t>& triangles);

/// The smallest signed area of a triangle: below 0 if one runs clockwise.
double smallest_triangle(const DrawMesh& mesh, const std::vector<std::uint32_t>& triangles);

}  // namespace rinceau
