#include "closed_loop/recipe.h"

#include "closed_loop/known_grammar.h"

namespace rinceau::test {

Element sized(std::vector<Path> paths, double size, Style style) {
    return element(transformed(paths, scale_by(size)), std::move(style));
}

Scene drawn_scene(const Recipe& recipe) { return drawn_scene(known_grammar(recipe.rules, recipe.terminals)); }

}  // namespace rinceau::test
