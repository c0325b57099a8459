#pragma once
// What is right in a shape grammar but perhaps not meant. Internal to the folder.

#include <vector>

#include "growth/surface/shape_expressions.h"

namespace rinceau {

/// By place: params and shapes that nothing uses, symbols that no axiom leads to, symbols from which every way leads on for
/// ever with no condition, probability or collision that could end it. Of a grammar without mistakes.
std::vector<Warning> shape_grammar_hints(const ShapeGrammar& grammar, const CompiledShapeGrammar& compiled);

}  // namespace rinceau
