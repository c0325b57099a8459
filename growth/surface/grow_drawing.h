#pragma once
// An analysed drawing's L-system with the turtle on a surface, its terminals laid on the surface.

#include <cstdint>
#include <optional>

#include "geometry/progress.h"
#include "growth/surface/lay_script.h"
#include "growth/surface/surface_pattern.h"
#include "lsystem/grammar.h"

namespace rinceau {

struct GrowDrawingOptions {
    std::optional<SurfacePoint> start;  ///< without one: a place far from borders and sharp bends
    double heading =
        0;  ///< degrees that the drawing's up is turned from the field (or from the surface's up), counter-clockwise
    /// Surface length of a unit of the drawing. 0 = the drawing's diagonal becomes half of the surface's; less, down to a
    /// fifth of that (two fifths if its elements do not fill its outline), if so the whole drawing lies in one piece.
    double scale = 0;
    double follow = 0.4;                   ///< of the field's turning: 1 = constant angle to it
    LayGroups lay = LayGroups::automatic;  ///< whole groups through one chart
    double height = 0;                     ///< of the walls, surface length; 0 = flat
    bool meet_itself = false;              ///< keep elements that overlap on the surface but not in the drawing
    double stretch = 1.5;                  ///< of a chart that an element is laid through
    std::optional<std::uint64_t> seed;
    int depth = -1;
    long max_shapes = 1'000'000;
};

/// What grew, with where it stopped. Colours, fills and strokes are the drawing's.
struct GrownDrawing {
    SurfacePattern pattern;  ///< `laid`
    long elements = 0;       ///< of the drawing
    long laid = 0, shrunk = 0, split = 0, spines = 0, dropped = 0,
         stopped = 0;  ///< stopped: at a border, where it met itself, or with what it hung on
    /// Of a surface that lies in the plane of x and y: the laid elements where they lie, in paint order, for pictures with
    /// true curves (to_scene.h). Empty of other surfaces.
    std::vector<Placement> placements;
    double folded = 0;  ///< share of laid area whose map is flipped; always 0
};

GrownDrawing grow_drawing(const Grammar& grammar, const SurfaceMesh& surface, const FieldOnSurface* field,
                          const GrowDrawingOptions& options = {}, const Progress& progress = {});

}  // namespace rinceau
