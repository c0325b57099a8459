#pragma once
// Colours as arguments (docs/analysis.md, 7.1): a grammar whose terminals are shapes learns which style each of them has.

#include <optional>

#include "analyzer/instancing.h"
#include "analyzer/to_grammar.h"

namespace rinceau {

/// `written` as from to_grammar of the same instancing, whose looks may have tints. The result draws every element in its
/// own style: by `;(n)` before terminals, n an expression in parameters that the productions gain and in their counters,
/// and by exceptions where the rule departs from it. Styles are numbered in order of the derivation. Nothing if productions
/// call each other in a circle.
std::optional<WrittenGrammar> with_colours(WrittenGrammar written, const Instancing& instancing);

}  // namespace rinceau
