#pragma once
// A drawing as terminals of a grammar.

#include <string>

#include "lsystem/grammar.h"
#include "scene/element.h"

namespace rinceau {

/// The name of a drawing's so manieth part: Leaf -> Leaf1, Leaf2 -> Leaf2_1.
std::string part_name(const std::string& symbol, std::size_t number);

/// The grammar with the drawing as `symbol`, laid into the turtle's frame by `map`: a terminal, or, if the drawing has
/// several styles or fragments of SVG, a production of that symbol with a terminal each. Neighbours in paint order that look
/// alike and do not touch are one terminal. `symbol` and the names of as many parts as there are elements must be free;
/// `elements` not empty.
Grammar with_drawing(Grammar grammar, const std::vector<Element>& elements, const Similarity& map,
                     const std::string& symbol);

}  // namespace rinceau
