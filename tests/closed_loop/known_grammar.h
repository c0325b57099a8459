#pragma once
// Grammars made by tests: rules as text, terminals as elements.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/random.h"
#include "lsystem/grammar.h"
#include "scene/element.h"

namespace rinceau::test {

/// `rules` in the .lsys notation (axiom, productions, exceptions); terminals from elements, each with a style of its own.
Grammar known_grammar(std::string_view rules, const std::vector<std::pair<std::string, Element>>& terminals);

/// What the grammar draws, in paint order, with a viewport that holds it.
Scene drawn_scene(const Grammar& grammar);

/// The same elements in a random order.
Scene shuffled(const Scene& scene, Random& random);

/// Coordinates as a drawing program writes them: multiples of `share` of each element's size, the size rounded down to
/// a power of ten.
Scene rounded(const Scene& scene, double share);

}  // namespace rinceau::test
