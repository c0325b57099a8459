#pragma once
// The names and the style numbers of a grammar that another one uses. Internal to the folder.

#include <string>

#include "lsystem/grammar.h"

namespace rinceau {

/// `prefix` and '_' before every symbol but the turtle's commands and before every constant, wherever they are named;
/// parameters, functions, pi and e stay as they are. Nothing changes for an empty prefix.
Grammar with_prefix(Grammar grammar, const std::string& prefix);

/// Every number of a style raised by `by` (>= 0), in styles, terminals and ;(..); 0, which is no style, stays 0. Exact for
/// numbers below a thousand million in size, and every expression stands once, so that what is drawn at random is drawn
/// once. The numbers that result must fit an int.
Grammar with_styles_raised(Grammar grammar, int by);

}  // namespace rinceau
