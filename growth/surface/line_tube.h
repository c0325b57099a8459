#pragma once
// The lines of a pattern as bodies.

#include "growth/surface/surface_pattern.h"

namespace rinceau {

/// A closed tube about the line, half of it below the surface, as thick as the line is wide at each point: rings of `sides`
/// corners (at least three) that neighbouring pieces share, mitred where the line bends a little and round where it turns
/// sharply. Ends are half spheres; an end that was cut at another line is flat and lies on that line. With normals. Nothing
/// for a line without two different points or without width.
NamedMesh line_tube(const PatternLine& line, int sides);

}  // namespace rinceau
