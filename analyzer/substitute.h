#pragma once
// Applying a rule: its items become members of new items (Stava et al. 2010, sections 5.5 and 5.6; docs/analysis.md, 4.5).

#include <functional>
#include <set>
#include <vector>

#include "analyzer/evaluate.h"

namespace rinceau {

struct Substitution {
    std::vector<int> new_items;      ///< empty: no chain passed the guard and nothing has changed
    std::vector<int> touched_parts;  ///< parts that lost or gained items, rising
};

/// Calls `improve(rule, touched)` for each sequence rule that has new items; it may add and replace items of the state and
/// adds the parts that lost or gained some to `touched`. Keeps `made` up to date.
void improve_sequences(const SearchState& state, Substitution& made,
                       const std::function<void(int rule, std::set<int>& touched)>& improve);

/// Members may miss the place that their rule gives them by this many tolerances.
constexpr double guard_slack = 3;

/// The part that rule `rule` makes with `count` repetitions; not yet one of the state.
Part made_part(const SearchState& state, int rule, int count);

/// Fits the rule, makes a part for each count and an item for each chain whose members lie where the rule puts them.
Substitution substitute(SearchState& state, const Hypothesis& hypothesis, const Evaluation& evaluation);

}  // namespace rinceau
