#pragma once
// An aggregate as a relief: leather (Sakurai & Miyata 2014, section 5.3, figure 16).

#include <vector>

#include "geometry/progress.h"
#include "growth/aggregate/aggregate_options.h"
#include "scene/picture.h"
#include "scene/style.h"

namespace rinceau {

/// How a crista rises from its edge: round as a cushion, even with a rounded edge, straight.
enum class CristaProfile : std::uint8_t { dome, plateau, cone };

struct HeightMapOptions {
    int columns = 1024;  ///< pixels from left to right; rows follow from the box
    CristaProfile profile = CristaProfile::dome;
    double depth = 0.4;       ///< share of the range of heights that lies below the edges of the cristae, in [0, 1)
    double sulcus_width = 0;  ///< from an edge to the bottom of a sulcus, scene length; 0 = half of what a crista rises over
};

/// Heights over the box of a domain: 0 the bottom of the sulci, 1 the top of the highest crista.
struct HeightMap {
    int columns = 0, rows = 0;
    std::vector<double> heights;  ///< row by row from the top
    Box box;
    double rise = 0;  ///< distance from its edge over which the highest crista rises, scene length
};

/// `cristae[shape]` is what rises, in the frame of the exclusive regions that were placed; all that is left are sulci. With
/// `sulci` not empty, these shapes are also sunk in where the cristae of the same number stand. A tiled domain has no seam.
/// At least one thing is placed. Throws LimitError for more than 64 million pixels.
HeightMap height_map(const std::vector<Region>& cristae, const std::vector<Region>& sulci,
                     const std::vector<PlacedRegion>& placed, const PackDomain& domain, const HeightMapOptions& options = {},
                     const Progress& progress = {});

struct ReliefLook {
    Color base{150, 98, 62};  ///< of the material
    double relief = 1;        ///< height of the highest crista, times HeightMap::rise
    bool tiled = false;       ///< as the domain was
};

/// The map as it looks in light from the upper left.
Picture shaded_relief(const HeightMap& map, const ReliefLook& look = {});

}  // namespace rinceau
