#pragma once
// Trees before the search from below (docs/analysis.md, 4.7).

#include <optional>

#include "analyzer/search_state.h"

namespace rinceau {

/// The state in which the trees of the drawing are items, or nothing if it has none.
std::optional<SearchState> open_with_branching(const SearchState& start);

/// The state in which what is made of small copies of itself, in the order of the drawing, is one item, or nothing.
std::optional<SearchState> open_with_self_similarity(const SearchState& start);

}  // namespace rinceau
