#pragma once
// When all rules are found, what is left is looked for in their gaps (docs/analysis.md, 4.7): the window without its pane.

#include "analyzer/gather.h"

namespace rinceau {

/// Where a member is missing below a root and it, or at least half of it, is left over in its place, it stands there.
void settle_gaps(SearchState& state, GridCache& grids);

}  // namespace rinceau
