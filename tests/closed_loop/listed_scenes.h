#pragma once
// Every drawing with known rules that the finder is measured on (docs/analysis.md, "Measured"): a table's rows as data.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "closed_loop/recipe.h"

namespace rinceau::test {

struct ListedScene {
    std::string family;
    std::string name;
    int rules = 0;          ///< productions that a person would write, at least and ..
    int most_rules = 0;     ///< .. at most; 0 = there is nothing to find
    int axiom_symbols = 1;  ///< symbols in the axiom that are no commands, at most
    int terminals = 0;      ///< if not 0: at most so many terminals
    int seeds = 1;          ///< drawings that are made at random: seeds 1, 2, ..
    std::function<Scene(std::uint64_t seed)> make;
};

/// The scene that a recipe draws: rounded to 1e-3 of the elements' sizes, and shuffled unless its order shows.
ListedScene listed(const std::string& family, const Recipe& recipe);

std::vector<ListedScene> branching_scenes();     ///< r3 and r4: trees, ferns, forests
std::vector<ListedScene> self_similar_scenes();  ///< curves and plants that are made of copies of themselves
std::vector<ListedScene> noise_scenes();         ///< regular layouts with places and angles shaken
std::vector<ListedScene> exception_scenes();     ///< holes and stand-ins in regular layouts
std::vector<ListedScene> progress_scenes();      ///< counts, distances and sizes that grow; phyllotaxis
std::vector<ListedScene> style_scenes();         ///< colours and widths that follow rules of their own
std::vector<ListedScene> whole_scenes();         ///< symmetries of the whole drawing

/// known_scenes() and all of the above; then clutter and nested grids of up to `largest` elements.
std::vector<ListedScene> listed_scenes(std::size_t largest);

}  // namespace rinceau::test
