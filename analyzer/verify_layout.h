#pragma once
// The check of a regular layout (docs/analysis.md, 4.8): it does not draw the drawing, but as many of each element, and the
// report says how far they moved.

#include "analyzer/instancing.h"
#include "analyzer/to_grammar.h"
#include "analyzer/verify.h"

namespace rinceau {

/// Derives the grammar afresh. Passed = it places every element of the drawing once, by the terminal of its look. The
/// deviations are distances of the elements' centres, as shares of the diagonal; `faulty` lists elements of other terminals.
Verification verify_layout(const Grammar& grammar, const WrittenGrammar& written, const Instancing& instancing, double diagonal);

}  // namespace rinceau
