#pragma once
// An element of a drawing on a surface.

#include <vector>

#include "growth/surface/lay_triangles.h"
#include "growth/surface/terminal_art.h"

namespace rinceau {

struct LaidLayer {
    Color color;
    int level = 0;    ///< of the art's layer
    LaidPieces area;  ///< convex polygons
    LaidPieces rim;   ///< lines around, counter-clockwise about the area; only if walls are wanted
};

struct LaidShape {
    int element = -1;  ///< index into TurtleScript::elements
    std::vector<LaidLayer> layers;
    double area = 0;  ///< on the drawing's scale, of all layers
    SpacePoint centre;
    double radius = 0;         ///< a ball about the centre holds all corners
    std::vector<Point> drawn;  ///< hull of what it covers in the drawing, counter-clockwise
    Similarity pose;           ///< of the terminal, in the chart's plane
    SurfacePoint middle;       ///< of the chart: its origin
    Complex turn{1, 0};        ///< the chart's x axis there, in the frame of the face
};

/// Fills centre and radius.
void bound_shape(const SurfaceMesh& surface, LaidShape& shape);

}  // namespace rinceau
