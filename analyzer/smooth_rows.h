#pragma once
// Rows of items along which way, direction and size go on smoothly, whatever their law (docs/analysis.md, 4.6).

#include <span>
#include <vector>

#include "analyzer/search_state.h"

namespace rinceau {

/// Rows of at least `least` living items of a part; of a row and its reverse the one that rises in the drawing. No two share a
/// step. `neighbours[k]` lists other items of the part near alive(p)[k], nearest first. O(number of neighbours).
std::vector<std::vector<int>> smooth_rows(const SearchState& state, int p, std::span<const std::vector<int>> neighbours,
                                          std::size_t least);

/// Frames for the items of a row: their poses, each times the symmetry that turns it least against how the row has turned so
/// far; nothing if that cannot be without a mirror image. Of continuous parts: unturned.
std::vector<Similarity> smooth_frames(const SearchState& state, std::span<const int> row);

}  // namespace rinceau
