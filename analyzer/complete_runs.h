#pragma once
// Rows that lack members at their ends (docs/analysis.md, 4.7): the other rows beside them tell.

#include "analyzer/substitute.h"

namespace rinceau {

/// Where sequences of one rule stand side by side at even steps, three or more of which at least two have the same, largest
/// count, the shorter ones among them become ones of this count with members missing: of all at most one in eight. Keeps
/// `made` and `grids` up to date.
void complete_runs(SearchState& state, GridCache& grids, Substitution& made);

}  // namespace rinceau
