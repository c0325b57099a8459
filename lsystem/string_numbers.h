#pragma once
// The numbers within the strings of a grammar, by name. Internal to the folder.

#include <map>
#include <string>
#include <vector>

#include "lsystem/numbers.h"
#include "lsystem/rule_loop.h"

namespace rinceau {

/// What stands before the dot: the symbol ("P", "P.case2" for its second production), "axiom", "except.1.2".
std::string name_of_string(const Grammar& grammar, const StringPlace& place);

/// Turns, distances, scales, arguments: all but counts of loops. `constants` are the grammar's.
std::vector<GrammarNumber> string_numbers(const Grammar& grammar, const Scope& constants,
                                          const std::vector<RuleLoop>& loops);

/// The counts: "Row.count", or "axiom.Row.count" and "Wall.Row.count" where they differ; "levels" for what branches.
std::vector<GrammarNumber> count_numbers(const Grammar& grammar, const std::vector<RuleLoop>& loops);

/// What the expression is written as: the constant whose name it is, or itself if it is more than a number.
void describe_written(const Grammar& grammar, const Expression& expression, GrammarNumber& number);

}  // namespace rinceau
