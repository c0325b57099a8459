#pragma once
// Expressions in JavaScript. Internal to the folder.

#include <map>
#include <string>

#include "lsystem/expression.h"

namespace rinceau {

/// As a number. `names`: in the grammar -> in the file; functions are members of an object `math` (js_functions).
std::string js_expression(const Expression& expression, const std::map<std::string, std::string>& names);

/// The definition of the object `math`.
std::string js_functions();

}  // namespace rinceau
