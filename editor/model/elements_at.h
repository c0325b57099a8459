#pragma once
// Which elements of a picture are at a point.

#include <cstddef>
#include <vector>

#include "editor/model/derived_picture.h"

namespace rinceau {

/// Orders of at most `most` elements that the scene point is in, or not farther from than `reach` (scene units): the
/// uppermost first.
std::vector<int> elements_at(const DerivedPicture& picture, Point at, double reach, std::size_t most);

}  // namespace rinceau
