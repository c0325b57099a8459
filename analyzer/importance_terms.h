#pragma once
// The values that the paper's importance function weighs, for chains that a hypothesis has found.

#include <vector>

#include "analyzer/chains.h"
#include "analyzer/importance.h"
#include "analyzer/search_state.h"

namespace rinceau {

/// The distance of two items is the least between the circles about their elements (of groups: about 16 of them), as a share
/// of the drawing's diagonal. The similarity of two items of one part is 1 if they stand exactly one step apart and 1/2 if
/// they miss that by the tolerance; items of different parts have none.
ImportanceTerms importance_terms(const SearchState& state, const std::vector<Chain>& chains, const Similarity& step);

}  // namespace rinceau
