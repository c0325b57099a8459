#pragma once
// Phyllotaxis (docs/analysis.md, 4.6): items that stand on a spiral of the power law r = c m^p, as one rule. Neighbours on the
// page are not neighbours in the spiral, so that the search from below sees only its parastichies.

#include <optional>

#include "analyzer/search_state.h"

namespace rinceau {

/// For each part that has a spiral (fit_spiral) of like-minded sizes and angles, a rule and an item of it; nothing if no part
/// has one.
std::optional<SearchState> open_with_spirals(const SearchState& start);

}  // namespace rinceau
