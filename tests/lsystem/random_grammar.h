#pragma once
// Grammars drawn at random, for properties that hold for all of them.

#include <string>
#include <vector>

#include "geometry/random.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// `depth` bounds the nesting.
Expression random_expression(Random& random, const std::vector<std::string>& names, int depth);

/// Every part of the format occurs: constants, conditions, exceptions, gradients, fragments, comments. Well formed as a
/// text; what it derives to is left to chance.
Grammar random_grammar(Random& random);

/// Equal in everything but places.
bool same_grammar(const Grammar& a, const Grammar& b);

}  // namespace rinceau
