#pragma once
// Expressions as cpfg reads them. Internal to the folder.

#include <set>
#include <string>
#include <string_view>

#include "exports/expression_writer.h"

namespace rinceau {

/// Operators and functions; `used` gets the macros that cpfg_prelude has to define. Names are the caller's.
ExpressionSyntax cpfg_syntax(std::set<std::string>& used);

std::string cpfg_prelude(const std::set<std::string>& used);

/// A number as cpfg's scanner takes it: an exponent stands behind a point only.
std::string cpfg_number(double value);

/// A function or word of its expressions, or a variable that it sets itself.
bool is_cpfg_name_taken(std::string_view name);

}  // namespace rinceau
