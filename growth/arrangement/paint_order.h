#pragma once
// Which element is painted over which, where outlines overlap as scales and feathers do (not in the paper, whose elements are
// solid bodies).

#include <vector>

#include "growth/arrangement/element_arrangement.h"
#include "growth/arrangement/exemplar.h"

namespace rinceau {

/// The elements, as indices into arranged_elements, in the order in which they are painted: of two neighbours whose reference
/// has one in the other's place, the one that is later in the exemplar (whose order is the drawing's paint order) comes later.
/// Where nothing says which, and where the wishes contradict each other in a circle, the one that is farther back in the
/// direction in which the exemplar paints comes first.
std::vector<int> paint_order(const ElementArrangement& arrangement, const Exemplar& exemplar);

}  // namespace rinceau
