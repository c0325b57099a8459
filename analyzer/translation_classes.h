#pragma once
// Elements that look alike but for where they stand, so that what was found out about a pair need not be found out again.

#include <vector>

#include "scene/element.h"

namespace rinceau {

/// For each element a number that it shares with those that are its copies, moved: outlines equal to within `quantum`
/// (nearly always, where they are; never if they differ by more), styles equal. Elements with a gradient, which moves along,
/// and verbatim ones are alone.
std::vector<int> translation_classes(const Scene& scene, double quantum);

}  // namespace rinceau
