#pragma once
// Grammars of chosen sizes for the editor's benchmarks.

#include <string>
#include <vector>

#include "lsystem/grammar.h"

namespace rinceau {

struct EditorDrawing {
    std::string name;
    Grammar grammar;
    std::string number;  ///< of numbers.h: what a drag changes
};

/// Grids, rings, a tree, a list without rules, a grid with an exception in every tenth row, one on two layers and one with
/// noise, each of about so many elements.
std::vector<EditorDrawing> editor_drawings(int elements);

}  // namespace rinceau
