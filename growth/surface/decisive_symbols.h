#pragma once
// Which symbols are derived at once, so that a collision that is found rules later still culls what stands behind them (Li
// et al. 2010, section 4.4.1, the second example).

#include <vector>

#include "growth/surface/shape_expressions.h"

namespace rinceau {

/// By symbol: the least set of symbols with rules all of which place exactly one thing (I, IC, IM, Lock, LineSeg, or a
/// symbol of the set), have no other symbol and a priority of at least 0. A symbol of it leads back to itself through a Lock
/// alone. A rule of negative priority waits for others, so its symbol cannot be derived at once.
std::vector<bool> decisive_symbols(const CompiledShapeGrammar& grammar);

}  // namespace rinceau
