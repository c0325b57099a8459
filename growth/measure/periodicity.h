#pragma once
// Does a pattern repeat itself?

#include <vector>

#include "growth/aggregate/pack_domain.h"

namespace rinceau {

struct RepeatingStep {
    Point step;
    double value = 0;  ///< of the autocorrelation, at most 1
};

/// Where the autocorrelation of what the regions cover is highest, of steps that are longer than `shortest` and at most half
/// of the domain's width and height: for a pattern that comes again after that step the share of the domain that meets
/// itself there, near 0 for one without period. On a tile, steps lead round it, and all of it meets itself.
RepeatingStep strongest_repeat(const std::vector<Region>& regions, const PackDomain& domain, double shortest);

}  // namespace rinceau
