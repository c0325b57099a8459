#pragma once
// Scenes of copies with known poses, and how far an instancing is from them.

#include "analyzer/instancing.h"
#include "analyzer/redrawn.h"

namespace rinceau::test {

struct CopiedScene {
    Scene scene;
    std::vector<int> shape;        ///< of each element: index into the outlines it was made of
    std::vector<Similarity> pose;  ///< of each element: outline -> scene
};

/// `count` stroked copies of the outlines in turn and in random poses, rewritten by redrawn() and shaken by `noise` (of the
/// outline's own size), in a viewport of 1000 by 1000.
CopiedScene copied_scene(const std::vector<std::vector<Path>>& outlines, int count, double noise, std::uint64_t seed);

/// How well looks answer to shapes, over pairs of elements: 1 = perfect.
struct PairScore {
    double purity = 0;  ///< share of pairs in one look that are of one shape
    double recall = 0;  ///< share of pairs of one shape that are in one look
};
PairScore pair_score(const CopiedScene& truth, const Instancing& found);

/// Largest difference of turns, scales and places of the found poses from the true ones, in unit lengths, modulo the
/// symmetry of the looks, each look's first copy being the reference.
double pose_error(const CopiedScene& truth, const Instancing& found);

}  // namespace rinceau::test
