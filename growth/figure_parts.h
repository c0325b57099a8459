#pragma once
// The shapes of a drawing one by one, with what they paint: what figures are put together from. Internal to the folder.

#include <string>
#include <vector>

#include "geometry/progress.h"
#include "lsystem/grammar.h"
#include "lsystem/interpret.h"
#include "scene/painted_region.h"

namespace rinceau {

struct FigurePart {
    Placement placement;  ///< with its address
    Region region;        ///< what it paints, scene space, never without area; of what is kept as SVG text, its box
    Region filled;        ///< the same with its holes filled
    Box box;
    bool cut = false;   ///< the picture's edge cuts it, it lies beyond that, or it is kept as SVG text
    bool kept = false;  ///< it is kept as SVG text: the region is no more than a box
};

struct FigureParts {
    /// The one that was given, with a terminal for each shape that only the picture's edge had cut, and with styles for strokes
    /// of fixed width: in the parts' placements every stroke follows the scale, so that copies of any scale look alike.
    Grammar grammar;
    std::vector<FigurePart> parts;  ///< in paint order
    std::vector<std::string> warnings;
};

/// What the grammar draws, part by part. What a clip has cut that is nothing but the picture's edge is made whole again, so
/// that it stands where it belongs; other fragments of SVG are boxes, and those of unknown extent are left out with a
/// warning. Throws as interpret().
FigureParts figure_parts(const Grammar& grammar, double deviation, const Progress& progress = {});

/// The region without its holes.
Region without_holes(const Region& region);

Region transformed(Region region, const Similarity& pose);

}  // namespace rinceau
