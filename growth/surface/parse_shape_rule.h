#pragma once
// A rule of a shape grammar's text. Internal to the folder.

#include "growth/surface/shape_grammar.h"
#include "lsystem/scanner.h"

namespace rinceau {

/// [id :] symbol [(parameters)] [: condition] ~ commands [: probability] [@ priority]. Without parentheses behind the first
/// name, `a : b ~` is a rule for b by the name a; a condition that is a single name stands in parentheses.
/// Throws InputError.
ShapeRule parse_shape_rule(Scanner& scanner);

}  // namespace rinceau
