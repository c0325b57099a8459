#pragma once
// Shape grammars as text.

#include <string>

#include "growth/surface/shape_grammar.h"

namespace rinceau {

/// parse_shape_grammar(to_text(g)) gives g again, places aside: params, fields, shapes, options, axioms, rules.
std::string to_text(const ShapeGrammar& grammar);

std::string statement_text(const ShapeRule& rule);
std::string statement_text(const ShapeAxiom& axiom);
std::string commands_text(const std::vector<ShapeCommand>& commands);

}  // namespace rinceau
