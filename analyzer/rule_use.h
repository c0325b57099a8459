#pragma once
// Where and how often a rule is used in a description: what its name and its comment speak of.

#include <vector>

#include "analyzer/rule_model.h"

namespace rinceau {

struct RuleUse {
    int item = -1;      ///< the first item that the rule has made, in order of derivation; -1 = not in use
    int fewest = 0;     ///< repetitions over all items
    int most = 0;
    bool even = true;   ///< all items have one scale, so that lengths in the scene speak for all of them
};

/// By rule.
std::vector<RuleUse> rule_uses(const RuleSet& rules, const std::vector<int>& roots);

/// Parts that are in use and made by rules, as a text should list them: what uses a part before the part, otherwise in the
/// order of the axiom and of the members. Parts of one rule stand together, the latest first.
std::vector<int> parts_top_down(const RuleSet& rules, const std::vector<int>& roots);

}  // namespace rinceau
