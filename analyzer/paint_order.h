#pragma once
// Paint order as part of the grammar (docs/analysis.md, 8): layers where the order of derivation is not the drawing's.

#include <vector>

#include "analyzer/overlaps.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// The grammar with `z(k)` commands put before as few module occurrences as possible, and exceptions for what no
/// occurrence-wide layer can do, so that every overlapping pair is painted in the drawing's order.
/// element_of_leaf[k] = the scene element drawn by the k-th terminal in order of derivation.
/// An exception that the grammar already holds for an address keeps its successor, with z(k) put in front of it.
Grammar with_paint_order(const Grammar& grammar, const std::vector<int>& element_of_leaf, const Overlaps& overlaps);

}  // namespace rinceau
