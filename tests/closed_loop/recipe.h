#pragma once
// Known drawings as data: rules in the grammar's notation, the elements they repeat, and what a person would count.

#include <string>
#include <utility>
#include <vector>

#include "closed_loop/shapes.h"

namespace rinceau::test {

constexpr Color ink{30, 40, 60};
constexpr Color clay{180, 80, 50};
constexpr Color sky{90, 150, 210};
constexpr Color gold{220, 170, 40};

/// The outline carried along by a scale.
Element sized(std::vector<Path> paths, double size, Style style);

struct Recipe {
    std::string name;
    std::string rules;  ///< axiom, productions, exceptions
    std::vector<std::pair<std::string, Element>> terminals;
    int fewest_rules = 0;
    int most_rules = 0;
    int axiom_symbols = 1;
    bool order_shows = false;  ///< elements overlap, or their order tells: it must stay
};

/// Drawn from its rules, unrounded.
Scene drawn_scene(const Recipe& recipe);

}  // namespace rinceau::test
