#pragma once
// Height maps as PNG files.

#include <string>

#include "growth/aggregate/height_map.h"

namespace rinceau {

/// PNG bytes, one channel of 16 bits: height 0 is 0, 1 is 65535. Nothing is said of gamma: values are heights, not light.
std::string height_png(const HeightMap& map);

}  // namespace rinceau
