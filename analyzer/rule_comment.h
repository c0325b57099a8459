#pragma once
// What a rule is, in words that a person would use.

#include <string>
#include <vector>

#include "analyzer/rule_model.h"

namespace rinceau {

/// "sequence", "ring", "linear" or "group".
std::string kind_name(RuleKind kind);

/// "row of A", "ring of 12 A", "spiral of up to 336 A", "A and B together"; names[part] are symbols.
std::string rule_comment(const RuleSet& rules, const Part& part, const std::vector<std::string>& names, int longest);

}  // namespace rinceau
