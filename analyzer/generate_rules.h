#pragma once
// From looks and poses to rules (Stava et al. 2010, sections 5.4 to 5.6; docs/analysis.md, 4.5): the most valuable
// hypothesis becomes a rule, its items are replaced by a group, and so on until nothing saves bits.

#include "analyzer/evaluate.h"
#include "geometry/progress.h"

namespace rinceau {

/// `state` is a starting_state; the result's rules describe every item of it.
SearchState generate_rules(SearchState state, const SearchOptions& options, const Progress& progress = {});

}  // namespace rinceau
