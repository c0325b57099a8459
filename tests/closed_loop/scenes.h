#pragma once
// Drawings whose rules a person would name at once: the paper's figures and common ornaments (docs/analysis.md), and the
// family of scenes that the benchmarks run on (section 0).

#include <cstdint>
#include <string>
#include <vector>

#include "scene/element.h"

namespace rinceau::test {

struct KnownScene {
    std::string name;
    Scene scene;
    int rules = 0;          ///< productions that describe it best; 0 = there is nothing to find
    int most_rules = 0;     ///< more are a fault
    int axiom_symbols = 1;  ///< symbols in the axiom that are no commands, at most
};

struct KnownSceneOptions {
    std::uint64_t seed = 1;
    bool shuffle = true;       ///< random order of the elements, where the order cannot be seen
    double rounding = 1e-3;    ///< of coordinates, in element sizes; 0 = none
};

/// Fig. 8 sequence, Fig. 5 linear, Fig. 9 helix, Fig. 10 facade, grids, rings, mandala, bricks, scales, facade with doors,
/// footprints, clutter of 40 and 500.
std::vector<KnownScene> known_scenes(const KnownSceneOptions& options = {});

/// `count` elements of five types in random places, angles, sizes and mirror images: no rule at all.
KnownScene clutter_scene(int count, const KnownSceneOptions& options = {});

/// Nested grids, a grid of rings of leaves, a grid of rings of circles, repeated in `rows` x `columns` blocks, beside random
/// clutter of the same four types: 1,200 elements a block, 96 of them clutter.
KnownScene nested_scene(int rows, int columns, const KnownSceneOptions& options = {});

}  // namespace rinceau::test
