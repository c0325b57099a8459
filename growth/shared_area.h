#pragma once
// Do two outlines share area?

#include "scene/painted_region.h"

namespace rinceau {

/// More than a ten-thousandth of the smaller one's area: outlines are lines to within a deviation, and what touches does not
/// overlap.
bool share_area(const Region& a, const Region& b);

}  // namespace rinceau
