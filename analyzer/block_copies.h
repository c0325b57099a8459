#pragma once
// Runs of elements that are copies of other runs, element by element in the order of the drawing.

#include <span>
#include <vector>

#include "analyzer/search_state.h"

namespace rinceau {

/// A map of the plane under which a block of items is another block, forward or from its end.
struct BlockCopy {
    Similarity map;
    bool reversed = false;
};

/// All maps (at most four for blocks of several items: forward or reversed, mirrored or not; for single items one for each
/// symmetry) that take every item of `block` to the corresponding one of `other`, within `slack` tolerances. Blocks of equal
/// size of items of one part.
std::vector<BlockCopy> block_copies(const SearchState& state, std::span<const int> block, std::span<const int> other,
                                    double slack);

}  // namespace rinceau
