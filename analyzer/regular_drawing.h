#pragma once
// The regular drawing behind an irregular one (docs/analysis.md, 4.8; Stava et al. 2010, figure 10): copies that stand
// in rows, columns and rings as well as a hand puts them are given the places, directions and sizes that they were meant to
// have. Rules are then searched for there, and what the drawing differs by is left over.

#include <optional>

#include "analyzer/instancing.h"

namespace rinceau {

/// The same elements in their regular poses, or nothing if nothing is regular without being so already. Elements in no
/// arrangement keep theirs. `diagonal`: of the drawing.
std::optional<Instancing> regular_drawing(const Instancing& instancing, double diagonal);

}  // namespace rinceau
