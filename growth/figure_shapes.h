#pragma once
// How two shapes stand to each other. Internal to the folder.

#include "geometry/box.h"
#include "scene/painted_region.h"

namespace rinceau {

/// A region with its box.
struct BoxedRegion {
    const Region& region;
    const Box& box;
};

/// The least distance between the two; 0 if they overlap or touch; nothing less than `within` is told exactly, otherwise
/// `within`.
double region_gap(const BoxedRegion& a, const BoxedRegion& b, double within);

/// Does nearly all of the inner one's outline lie inside the outer one, or on its outline?
bool lies_inside(const BoxedRegion& inner, const BoxedRegion& outer);

/// Do the two have the same outline to within `tolerance`?
bool same_outline(const Region& a, const Region& b, double tolerance);

}  // namespace rinceau
