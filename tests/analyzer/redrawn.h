#pragma once
// The same outline written in other ways, and a bank of outlines that are all different.

#include <vector>

#include "geometry/random.h"
#include "scene/element.h"

namespace rinceau::test {

/// Another start node (closed paths), perhaps the other direction, some segments split in two, sub-paths in another order.
std::vector<Path> redrawn(std::vector<Path> paths, Random& random);

/// Every number moved by up to `noise`.
std::vector<Path> shaken(std::vector<Path> paths, double noise, Random& random);

/// 70 outlines of which no two are similar: polygons, circle, ellipses, rectangles, stars, compound rings, blobs closed and
/// open, and ten that differ by 8 % from one of them.
std::vector<std::vector<Path>> different_outlines();

/// An ellipse of four cubics, half axes 1 and `ratio`.
std::vector<Path> ellipse(double ratio);

Similarity random_similarity(Random& random, bool mirror = true);

}  // namespace rinceau::test
