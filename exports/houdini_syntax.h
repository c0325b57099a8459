#pragma once
// Expressions as Houdini's L-System SOP reads them. Internal to the folder.

#include "exports/expression_writer.h"

namespace rinceau {

/// Arithmetic, min, max and what can be said by them. Names are the caller's.
ExpressionSyntax houdini_argument_syntax();

/// The same and comparisons, without the sign = that ends a condition: a == b is !((a<b)|(a>b)).
ExpressionSyntax houdini_condition_syntax();

}  // namespace rinceau
