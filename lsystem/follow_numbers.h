#pragma once
// The names of numbers after productions were moved or symbols renamed.

#include <set>
#include <string>
#include <vector>

#include "lsystem/grammar.h"

namespace rinceau {

/// The names by which the numbers of `names` (numbers.h) are known in `after`, in which each of them is still written;
/// those that are not are left out. `new_index[i]`: the index in `after` of the production i of `before`, -1 = it is gone;
/// strings are otherwise as long as before.
std::set<std::string> names_afterwards(const Grammar& before, const Grammar& after, const std::vector<int>& new_index,
                                       const std::set<std::string>& names);

}  // namespace rinceau
