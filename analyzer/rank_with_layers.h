#pragma once
// Which description costs a reader least when it is also painted in the right order (docs/analysis.md, 8 and 10).

#include <vector>

#include "analyzer/description.h"
#include "geometry/progress.h"

namespace rinceau {

/// The descriptions, best first, as their rules cost. If the layers that the first needs cost more than a little, those that
/// follow and would be cheaper than it (the first four of them) get theirs as well, and the cheapest goes to the front. What
/// goes before cheaper rules for reasons of its own keeps that lead. The same for any number of threads.
std::vector<Description> ranked_with_layers(std::vector<Description> descriptions, const Overlaps& overlaps, int threads,
                                            const Progress& progress = {});

}  // namespace rinceau
