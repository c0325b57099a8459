#pragma once
// Outlines in their style as triangles, ready for a graphics card.

#include <cstdint>
#include <vector>

#include "geometry/box.h"
#include "scene/path.h"
#include "scene/style.h"

namespace rinceau {

/// In the frame of the outlines.
struct MeshPoint {
    float x = 0;
    float y = 0;
    friend constexpr bool operator==(const MeshPoint&, const MeshPoint&) = default;
};

/// Three indices into `points` a triangle, counter-clockwise. The triangles of the fill do not overlap each other, nor do
/// those of the stroke: a translucent paint covers every place once. Fill and stroke may overlap.
struct DrawMesh {
    std::vector<MeshPoint> points;
    std::vector<std::uint32_t> fill;
    std::vector<std::uint32_t> stroke;
    Box box;  ///< of all points; empty if nothing is painted
};

struct MeshOptions {
    /// The greatest distance between a curve and its mesh (> 0), in the frame's unit.
    double deviation = 0.1;
    /// Scene length of the frame's unit (> 0): strokes of fixed width are as wide as that makes them.
    double stroke_scale = 1;
};

/// What the style paints of the outlines: the fill by its rule, open paths closed; the stroke with its caps, joins, dashes
/// and pen. A sub-path of length 0 has a dot where its caps make one. Nothing is painted of points that are not finite.
/// Outlines that cross themselves very many times are drawn coarser, so that time stays bounded. Same arguments, same mesh.
DrawMesh tessellated(const std::vector<Path>& paths, const Style& style, const MeshOptions& options = {});

}  // namespace rinceau
