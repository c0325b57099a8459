#pragma once
// Expressions as Python. Internal to the folder.

#include <set>
#include <string>
#include <string_view>

#include "exports/expression_writer.h"

namespace rinceau {

/// Word of the language or a name that its expressions need.
bool is_python_name_taken(std::string_view name);

/// Operators and functions; `used` gets the functions that python_prelude has to define. Names are the caller's.
ExpressionSyntax python_syntax(std::set<std::string>& used);

/// Definitions of what the expressions call, empty for none.
std::string python_prelude(const std::set<std::string>& used);

}  // namespace rinceau
