#pragma once
// What is tried before the search from below (docs/analysis.md, 4.6): finders that see the whole drawing at once. Each makes
// items of what it finds; the search then works on the rest.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/generate_rules.h"

namespace rinceau {

/// Shares of the reading cost of the description from below: what costs less is preferred to it.
struct ConvincingCost {
    double all = 1;
    double visible = 1;  ///< without residuals that cannot be seen
};

struct Opening {
    std::string name;
    ConvincingCost if_longer;      ///< if it needs more productions, or breaks a ring
    ConvincingCost if_not_longer;
    /// From a starting_state: the state in which what was found is already items, or nothing. A found item that the search
    /// shall leave alone is alive but in no list of members. To find nothing must cost far less than the search.
    std::function<std::optional<SearchState>(const SearchState& start, const SearchOptions& options, const Progress& progress)>
        open;
};

/// Opens nothing, so that everything is found from below.
Opening opening_from_below();

/// Those that may open this drawing. `start` is a starting_state. Several readings of one kind are openings of their own.
std::vector<Opening> openings_of(const SearchState& start);

}  // namespace rinceau
