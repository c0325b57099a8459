#pragma once
// Count families (docs/analysis.md, 4.9): rows of one rule whose counts progress – triangles, pyramids, bowling pins – are
// one rule over that rule.

#include "analyzer/search_state.h"

namespace rinceau {

/// Chains of living items of one sequence rule, each with the same number of members fewer than the one before and in the
/// same step from it, become items of family rules; a single element at the end counts as a row of one, two as a row of two.
/// At least four rows. Returns whether there was any.
bool join_families(SearchState& state);

}  // namespace rinceau
