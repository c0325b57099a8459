#pragma once
// Which of the elements that overlap lies above.

#include <cstddef>
#include <vector>

#include "growth/arrangement/arrange_options.h"
#include "growth/arrangement/exemplar.h"

namespace rinceau {

/// Indices of the elements, lowest first. Of two that come near enough to overlap, the one lies above that does so in the
/// exemplar where neighbours stand alike, as far as that does not lead round in circles; otherwise the order is kept. If
/// nothing overlaps in the exemplar, the order is that of the elements.
std::vector<std::size_t> paint_order(const Exemplar& exemplar, const std::vector<ArrangedElement>& elements);

}  // namespace rinceau
