#pragma once
// Tables of what the analysis finds: in drawings whose rules are known, and in a folder of drawings.

#include <cstddef>
#include <string>

#include "analyzer/importance.h"

namespace rinceau::test {

struct SceneTableOptions {
    std::size_t largest = 12'500;  ///< elements of the scenes that are there for their size
    std::string only;              ///< families and scenes whose name has this in it; "" = all
    int seeds = 20;                ///< drawings of a scene that is made at random, at most
    Objective objective = Objective::bits;
    bool both = false;  ///< rules and bits of both objectives, side by side
};

/// A line for each of listed_scenes(): what a person would write, what was found, and found / partly / missed.
void print_scene_table(const SceneTableOptions& options);

/// A line for each .svg of the folder, then the median and the least ratio. False if there is none.
bool print_drawing_table(const std::string& folder, Objective objective, bool both);

}  // namespace rinceau::test
