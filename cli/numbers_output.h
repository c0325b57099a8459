#pragma once
// The numbers of a grammar as a list for a person, and as JSON for other programs.

#include <string>
#include <vector>

#include "lsystem/numbers.h"

namespace rinceau {

/// Name, value and meaning, a number a line, in columns. Without `all` about as many as fit on a screen: first what the
/// rules are about; the last line says how many were left out.
std::string numbers_text(const std::vector<GrammarNumber>& numbers, bool all);

/// {"schema": 1, "numbers": [{"name", "value", "unit", "help", "kind", "whole", "low", "high", "written"?}]}; low and high
/// are null where there is no limit.
std::string numbers_json(const std::vector<GrammarNumber>& numbers);

}  // namespace rinceau
