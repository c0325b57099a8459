#pragma once
// Rings with a few members missing (docs/analysis.md, 4.7): a clock face without its 12.

#include "analyzer/substitute.h"

namespace rinceau {

/// Of the sequences that were just made, those that would close to a ring of six or more become one with members missing: at
/// most a third of all and no two side by side, in rings of twelve or more no three. Keeps `made` and `grids` up to date.
void close_rings(SearchState& state, GridCache& grids, Substitution& made);

}  // namespace rinceau
