#pragma once
// The regular drawing behind an irregular one (docs/analysis.md, 4.8; Stava et al. 2010, figure 10): copies that stand
// in rows, columns and rings as well as a hand puts them are given the places, directions and sizes that they were meant to
// have. Rules are then searched for there, and what the drawing differs by is left over.

#include <optional>
#include <span>
#include <vector>

#include "analyzer/instancing.h"

namespace rinceau {

/// One thing that may stand in an arrangement with its copies, which have the same `kind`.
struct PlacedCopy {
    int kind = 0;
    Similarity pose;                          ///< own frame -> scene
    const SymmetryGroup* symmetry = nullptr;  ///< of its kind
};

/// The poses that the copies were meant to have; those in no arrangement keep theirs. They may be turned by a symmetry of
/// their kind. `diagonal`: of the drawing.
std::vector<Similarity> regular_poses(std::span<const PlacedCopy> copies, double diagonal);

/// Is the regular place another one, or what a search for rules takes for the same?
bool stands_elsewhere(const Similarity& drawn, const Similarity& regular);

/// The same elements in their regular poses, or nothing if nothing is regular without being so already. Elements in no
/// arrangement keep theirs. `diagonal`: of the drawing.
std::optional<Instancing> regular_drawing(const Instancing& instancing, double diagonal);

}  // namespace rinceau
