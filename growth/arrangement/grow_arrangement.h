#pragma once
// Growth of an arrangement, one element at a time (Ijiri et al. 2008, section 5). The value can be kept, copied, drawn and
// grown on at any time; whatever stands is a valid arrangement.

#include <vector>

#include "geometry/progress.h"
#include "growth/arrangement/arrange_options.h"
#include "growth/arrangement/element_arrangement.h"
#include "growth/arrangement/exemplar.h"

namespace rinceau {

/// Nothing yet; `options` hold from here on.
ElementArrangement empty_arrangement(const Exemplar& exemplar, const ArrangeOptions& options);

/// A seed without a symbol at `at`, unless one or an element stands within an edge's length, or the boundary forbids it.
ElementArrangement with_seed(ElementArrangement arrangement, const Exemplar& exemplar, const ArrangeSurroundings& around,
                             Point at);

/// Grows seeds, nearest to the first one before others, until the order is fulfilled or no seed is left. Ends within a bound
/// on steps that is proportional to the order. A step's cost does not depend on how much stands already.
ElementArrangement grow(ElementArrangement arrangement, const Exemplar& exemplar, const ArrangeSurroundings& around,
                        const GrowOrder& order, const Progress& progress = {});

/// Relaxes the whole and, if the exemplar is irregular and options say so, thins, repairs and re-reads it (docs/growth.md);
/// what that takes out is grown again at the rim, if the order has a count: afterwards that many stand, or one in a hundred
/// fewer. Without a count nothing is added but in holes. Afterwards: no outline crosses the boundary, nor another outline if
/// those of the exemplar do not. grow() can go on from what comes back.
ElementArrangement finished(ElementArrangement arrangement, const Exemplar& exemplar, const ArrangeSurroundings& around,
                            const GrowOrder& order = {}, const Progress& progress = {});

/// The nodes that are elements, in the order of placing.
std::vector<int> nodes_by_birth(const ElementArrangement& arrangement);
/// What stands, in the order of placing.
std::vector<ArrangedElement> arranged_elements(const ElementArrangement& arrangement);

/// Edges between elements as pairs of indices into arranged_elements: for pictures of the connectivity and for measures.
std::vector<std::pair<int, int>> arranged_edges(const ElementArrangement& arrangement);

}  // namespace rinceau
