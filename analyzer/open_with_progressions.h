#pragma once
// Rows whose step or size changes evenly (Stava et al. 2010, eq. 4; docs/analysis.md, 4.6): t(m) = t0 + tDelta m in alpha, d
// and beta, d also by a factor, sizes by a summand, about a seat of the element that need not be its centroid.

#include <optional>

#include "analyzer/search_state.h"

namespace rinceau {

/// Smooth rows (smooth_rows.h) of at least 6 items, or of all 4 or 5 items of the drawing, that follow such a law and no
/// constant step, and that chance does not make; each is an item of a linear rule, rows of one law and length of the same
/// rule. Nothing if there is none.
std::optional<SearchState> open_with_progressions(const SearchState& start);

}  // namespace rinceau
