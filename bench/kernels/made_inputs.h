#pragma once
// Inputs of any size, the same ones at every run.

#include <string>
#include <vector>

#include "geometry/point.h"
#include "growth/mesh/triangle_mesh.h"
#include "lsystem/grammar.h"
#include "scene/element.h"

namespace rinceau::bench {

/// What stands in the file. Throws std::runtime_error if it cannot be read.
std::string content_of(const std::string& file);

/// bench/drawings/ornament.lsys with rows and columns for about `elements` elements: nested structure.
std::string ornament_text(int elements);
/// bench/drawings/clutter.lsys with so many elements, of one density at any number.
std::string clutter_text(int elements);

/// What the text of a grammar draws.
Scene drawn(const std::string& grammar_text);

/// Strewn over the unit square.
std::vector<Point> strewn_points(int count);

/// A torus of about so many faces.
TriangleMesh torus_of(int faces);

}  // namespace rinceau::bench
