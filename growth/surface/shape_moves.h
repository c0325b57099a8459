#pragma once
// Scopes walk over the surface: along a field at a constant angle, straight, or through a chart (Li et al. 2010,
// section 4.3.1).

#include "growth/surface/shape_scope.h"
#include "growth/surface/surface_chart.h"
#include "growth/surface/surface_pattern.h"
#include "growth/surface/trace.h"

namespace rinceau {

/// A map of the surroundings of a scope that is made as large as moves ask for.
struct ScopeChart {
    SurfacePoint anchor;
    Complex x{1, 0};  ///< the map's x axis at the anchor
    SurfaceChart chart;
    std::optional<ChartLookup> lookup;
    bool complete = false;  ///< it cannot grow any more
};

struct MoveGround {
    const SurfaceMesh* surface = nullptr;
    const FieldOnSurface* follow = nullptr;  ///< none: straight
    TraceOptions trace;
};

struct ScopeWalk {
    bool at_border = false;
    double length = 0;               ///< walked
    std::vector<SurfacePoint> path;  ///< start, where it bends or crosses edges, end; if asked for
};

/// Moves the scope by `way` (from its X, to its Y); its X keeps its angle to the way. A scope in a chart moves in the chart;
/// where the chart ends before the surface does, the scope leaves it and walks on from where it stands. Counts what it did.
ScopeWalk walk(const MoveGround& ground, ShapeScope& scope, Complex way, bool straight, bool keep_path,
               PatternCounts& counts);

/// From here on the scope moves in a chart about where it stands.
void begin_chart(ShapeScope& scope);

}  // namespace rinceau
