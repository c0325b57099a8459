#pragma once
// What a rule is, in words that a person would use.

#include <string>
#include <vector>

#include "analyzer/rule_use.h"

namespace rinceau {

/// "sequence", "ring", "linear" or "group".
std::string kind_name(RuleKind kind);

/// One word with a capital letter for what the rule makes, as it lies in the drawing where it is used first: "Row", "Column",
/// "Diagonal", "Grid" (a column of rows), "Taper", "Zigzag", "Arc", "Spiral", "Fan", "Nest", "Ring", "Curve", "Pair", "Motif",
/// "Mirrored" (two halves).
std::string rule_name(const RuleSet& rules, const Part& part, const std::vector<RuleUse>& uses);

/// "a row of 4 A, 12 apart", "a ring of 12 A, radius 40", "a spiral of 3 to 7 A, turning by 8.5 degrees, each 0.993 times as
/// large", "A and 2 B together"; names[part] are symbols. Lengths are in scene units and left out if the sizes differ.
std::string rule_comment(const RuleSet& rules, const Part& part, const std::vector<std::string>& names,
                         const std::vector<RuleUse>& uses);

}  // namespace rinceau
