#pragma once
// What stands in a gap belongs to it (docs/analysis.md, 5): the door in a row of windows.

#include "analyzer/rule_model.h"

namespace rinceau {

/// Roots whose origin lies within the reach of a missing member, and that are not much larger, stand in for it, the nearest
/// first. A sequence of which each member finds a gap of its own is taken apart.
RuleSet with_filled_gaps(RuleSet rules);

}  // namespace rinceau
