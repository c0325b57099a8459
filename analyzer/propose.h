#pragma once
// Hypotheses from neighbours (Stava et al. 2010, section 5.3, steps 1-3; docs/analysis.md, 4.1).

#include <vector>

#include "analyzer/hypothesis.h"
#include "analyzer/search_state.h"

namespace rinceau {

/// Sequences within one part: constant steps, steps of parts without direction, linearly changing steps.
std::vector<Hypothesis> propose_sequences(const SearchState& state, int part);

/// Groups of two parts, from the neighbours of `items` among all living items of other parts.
std::vector<Hypothesis> propose_groups(const SearchState& state, const std::vector<int>& items);

}  // namespace rinceau
