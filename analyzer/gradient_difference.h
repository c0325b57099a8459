#pragma once
// Do two gradients look the same where an element is painted? Far from it they may differ: a gradient of which a small part
// is seen, turned by a thousandth, has its ends elsewhere and the same colours here.

#include "geometry/box.h"
#include "scene/style.h"

namespace rinceau {

/// In the box every colour lies within `distance` (in the gradients' frame) of its place in the other gradient, or differs
/// there by no more than 2 of 255 levels. Stops and spread are equal.
bool same_gradient_in(const Gradient& a, const Gradient& b, const Box& box, double distance);

}  // namespace rinceau
