#pragma once
// Pens that are no circles.

#include "scene/style.h"

namespace rinceau {

/// How much the pen stretches the circle at most: the larger singular value of its matrix.
double largest_stretch(const Linear2& pen);

}  // namespace rinceau
