#pragma once
// Sequences go on over what is missing (docs/analysis.md, 4.7): a row with a gap is one row, and a row that is cut short
// belongs to the column of the others.

#include "analyzer/substitute.h"

namespace rinceau {

/// Joins and extends the sequences that were just made, with all others of the same rules: items that continue them exactly,
/// parts of items that do (gather.h), and further runs beyond a gap of one or two places. A gap is bridged if the line then is
/// as long as another one without this gap, or if it stands alone and its runs differ in length: equal runs are blocks, gaps
/// alike in all lines are aisles. At most a third of the places may be exceptions. Keeps `made` and `grids` up to date.
void bridge_gaps(SearchState& state, GridCache& grids, Substitution& made);

}  // namespace rinceau
