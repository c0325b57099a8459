#pragma once
// A drawing's way walked on a surface, its elements laid: whole groups through one chart where they lie well in it.

#include <functional>
#include <span>
#include <vector>

#include "geometry/progress.h"
#include "growth/surface/element_contacts.h"
#include "growth/surface/laid_shape.h"
#include "growth/surface/lay_elements.h"
#include "growth/surface/surface_turtle.h"
#include "growth/surface/turtle_script.h"

namespace rinceau {

enum class LayGroups : unsigned char { automatic, never, always };

struct LayScriptOptions {
    LayGroups groups = LayGroups::automatic;
    double stretch = 1.5;      ///< that an element may have; a group half of it above 1
    bool meet_itself = false;  ///< keep elements that overlap on the surface but not in the drawing
    bool rims = false;         ///< lay outlines too, for walls
    bool whole_only = false;   ///< nothing unless the whole drawing lies in one chart
    /// A compact drawing goes through one chart as far as that reaches, instead of a walk. An element that is near a laid
    /// one is set out from there; what has lost its support, or no longer hangs together with the rest, stops. Empty: all by
    /// the turtle alone.
    ElementTies ties = {};
};

/// An element that could not be laid, and where the turtle stood.
struct LayLoss {
    int element = 0;
    SurfacePoint at;
};

struct LaidScript {
    std::vector<LaidShape> shapes;         ///< in order of derivation
    std::vector<std::vector<int>> covers;  ///< by shape: earlier ones with area in common
    long shrunk = 0, split = 0, spines = 0, stopped = 0;
    long groups = 0;     ///< laid whole
    bool whole = false;  ///< all elements through one chart
    std::vector<LayLoss> dropped;
};

/// `elements` by TurtleScript::elements; those without art are passed over. The turtle begins at `start`.
LaidScript lay_script(const SurfaceMesh& surface, const TurtleScript& script, std::span<const DrawnElement> elements,
                      const TurtleWays& ways, const DrawingStand& start, const LayScriptOptions& options,
                      const Progress& progress = {});

}  // namespace rinceau
