#pragma once
// Rows and columns: bodies that stand alike, on the crossings of a few lines each way (facades, grids, staggered rows).

#include "analyzer/arrangement.h"

namespace rinceau {

/// The arrangement of all `bodies` of which `chosen` are indices, or nothing if they are no table: two on one crossing, most
/// crossings empty, lines that are not clearly apart, or no more regular than chance.
std::optional<Arrangement> arrange_in_lattice(std::span<const Body> bodies, std::span<const int> chosen, const BodyForm& form,
                                              const ArrangementScale& scale);

}  // namespace rinceau
