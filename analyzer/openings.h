#pragma once
// What is tried before the search from below (docs/analysis.md, 4.6): finders that see the whole drawing at once. Each makes
// items of what it finds; the search then works on the rest.

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "analyzer/generate_rules.h"

namespace rinceau {

struct Opening {
    std::string_view name;
    /// The part of the bottom-up description's reading cost below which this reading is preferred to it, 0 < share <= 1.
    double convincing_share = 1;
    /// From a starting_state: the state in which what was found is already items, or nothing. A found item that the search
    /// shall leave alone is alive but in no list of members. To find nothing must cost far less than the search.
    std::function<std::optional<SearchState>(const SearchState& start, const SearchOptions& options, const Progress& progress)>
        open;
};

/// All of them; the first opens nothing, so that everything is found from below.
const std::vector<Opening>& openings();

}  // namespace rinceau
