#pragma once
// The linear rule that a row of frames follows (docs/analysis.md, 4.6).

#include <optional>

#include "analyzer/chains.h"
#include "analyzer/search_state.h"

namespace rinceau {

struct Progression {
    Rule rule;          ///< linear; `repeated` is not set
    double worst = 0;   ///< as from worst_deviation
};

/// The simplest law that holds the frames of a row of items of part `p` (at least 4) within `slack` item sizes: directions,
/// distances, angles or sizes that change evenly. Nothing if there is none, or if a constant step does as well. A part that is
/// continuous has frames that do not turn.
std::optional<Progression> progression_of(const SearchState& state, int p, const Chain& row, double slack);

}  // namespace rinceau
