#pragma once
// The shapes of `rinceau pack`: what is drawn, what it keeps for itself, and the mesh in its place.

#include <string>
#include <vector>

#include "cli/pack_options.h"
#include "growth/figures.h"

namespace rinceau {

/// A shape in the frame of its exclusive region, upright as it is drawn.
struct PackShape {
    Similarity to_region;  ///< figure's frame -> that of its exclusive region
    Region outline;        ///< of the figure
    ExclusiveRegion region;
    Region sulcus;  ///< empty = none
};

struct PackShapes {
    FiguredDrawing drawing;             ///< a figure for each shape, without instances
    std::vector<PackShape> shapes;      ///< in the order of the figures
    std::vector<NamedMesh> meshes;      ///< one for each shape, standing upon the ground over the region's origin; or none
    std::vector<std::string> warnings;  ///< of the files of shapes; they were said
};

/// Reads all that options.shapes, meshes, drawn_regions and sulci name. Throws InputError if something is no drawing or
/// mesh, a shape has no area, margins leave nothing, or there are not as many regions or meshes as shapes.
PackShapes read_pack_shapes(const PackVerbOptions& options);

}  // namespace rinceau
