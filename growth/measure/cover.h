#pragma once
// How much of a domain regions cover, by the area of their union.

#include <vector>

#include "growth/aggregate/pack_domain.h"

namespace rinceau {

/// Scene areas, of outlines on a grid of 1e-9 of the domain.
struct Cover {
    double domain = 0;  ///< area of the domain
    double sum = 0;     ///< of the regions' areas
    double united = 0;  ///< area of their union; equals the sum if no two overlap
    double within = 0;  ///< of that, inside the domain
};

/// On a tile, what leaves it comes in on the other side: all is within.
Cover cover(const std::vector<Region>& regions, const PackDomain& domain);

}  // namespace rinceau
